// The bottom of a canvas: the model's picture, ink that is settled, ink that is being drawn. Blended
// as light, written as sRGB bytes into a target that knows nothing of sRGB, as windows are.
uniform sampler2D picture;   // sRGB
uniform sampler2D settled;   // sRGB, premultiplied
uniform sampler2D coverage;  // of live_ink
uniform sampler2D tail;      // of live_ink
uniform mat3 picture_from_view;  // [0, 1] from pixels, both y up; homogeneous
uniform vec3 paper;          // sRGB, where there is no picture
uniform vec4 live_ink;       // sRGB, alpha
layout(location = 0) out vec4 pixel;

vec3 SrgbFromLinear(vec3 c) {
  return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 from = picture_from_view * vec3(gl_FragCoord.xy, 1.0);
  vec2 uv = from.xy / from.z;
  bool inside = from.z > 0.0 && uv == clamp(uv, 0.0, 1.0);
  vec3 color = inside ? textureLod(picture, uv, 0.0).rgb : LinearFromSrgb(paper);
  vec4 done = texelFetch(settled, at, 0);
  color = color * (1.0 - done.a) + done.rgb;
  float cover = max(texelFetch(coverage, at, 0).r, texelFetch(tail, at, 0).r);
  color = mix(color, LinearFromSrgb(live_ink.rgb), cover * live_ink.a);
  pixel = vec4(SrgbFromLinear(clamp(color, 0.0, 1.0)), 1.0);
}
