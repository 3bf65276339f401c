// One triangle over the whole picture.
void main() {
  vec2 at = vec2(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID & 2) << 1) - 1.0);
  gl_Position = vec4(at, 0.0, 1.0);
}
