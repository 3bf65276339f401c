// One triangle over the whole picture.
uniform vec3 ray_middle;  // through the middle of the picture, world, depth 1
uniform vec3 ray_right;   // from the middle to the right side
uniform vec3 ray_up;      // from the middle to the upper side
out vec3 ray;
out float height;  // 0 at the lower side of the picture, 1 at the upper
void main() {
  vec2 at = vec2(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID & 2) << 1) - 1.0);
  gl_Position = vec4(at, 1.0, 1.0);
  ray = ray_middle + ray_right * at.x + ray_up * at.y;
  height = 0.5 * at.y + 0.5;
}
