// Ink of one colour onto the picture, by its coverage.
uniform sampler2D coverage;
uniform vec4 color;  // sRGB, alpha
layout(location = 0) out vec4 pixel;

void main() {
  float alpha = color.a * texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r;
  pixel = vec4(LinearFromSrgb(color.rgb) * alpha, alpha);
}
