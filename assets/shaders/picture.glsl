// The bottom of a canvas, its picture of the model or plain paper. Prepended to what composes; the
// result is written as sRGB bytes into a target that knows nothing of sRGB, as windows are.
uniform sampler2D picture;       // sRGB
uniform mat3 picture_from_view;  // [0, 1] from pixels, both y up; homogeneous
uniform vec3 paper;              // sRGB, where there is no picture

vec3 PictureHere() {
  vec3 from = picture_from_view * vec3(gl_FragCoord.xy, 1.0);
  vec2 uv = from.xy / from.z;
  bool inside = from.z > 0.0 && uv == clamp(uv, 0.0, 1.0);
  return inside ? textureLod(picture, uv, 0.0).rgb : LinearFromSrgb(paper);
}

vec4 Pixel(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return vec4(mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)), 1.0);
}
