// Panels: triangles in pixels.
layout(location = 0) in vec2 position;  // px, y down
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;     // sRGB, straight alpha
uniform vec2 picture;  // px
uniform float opacity;
out vec2 at_texture;
out vec4 tint;

void main() {
  gl_Position = vec4(2.0 * position.x / picture.x - 1.0, 1.0 - 2.0 * position.y / picture.y, 0.0, 1.0);
  at_texture = uv;
  tint = vec4(color.rgb, color.a * opacity);
}
