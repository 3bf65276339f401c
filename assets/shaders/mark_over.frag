// Marks of one colour onto a canvas, by their coverage; sRGB bytes as canvases hold them.
uniform sampler2D coverage;
uniform vec4 color;  // sRGB, alpha
layout(location = 0) out vec4 pixel;

void main() {
  float alpha = color.a * texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r;
  pixel = vec4(color.rgb * alpha, alpha);
}
