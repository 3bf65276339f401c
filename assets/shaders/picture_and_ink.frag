// A canvas where there is ink: what is settled, and what is being drawn, blended as light.
uniform sampler2D settled;   // sRGB, premultiplied
uniform sampler2D coverage;  // of live_ink
uniform sampler2D tail;      // of live_ink
uniform vec4 live_ink;       // sRGB, alpha
layout(location = 0) out vec4 pixel;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 done = texelFetch(settled, at, 0);
  vec3 color = PictureHere() * (1.0 - done.a) + done.rgb;
  float cover = max(texelFetch(coverage, at, 0).r, texelFetch(tail, at, 0).r);
  pixel = Pixel(mix(color, LinearFromSrgb(live_ink.rgb), cover * live_ink.a));
}
