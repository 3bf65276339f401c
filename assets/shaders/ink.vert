// A piece of ink between two samples: a capsule whose width changes from end to end.
layout(location = 0) in vec2 end_a;  // px, y down
layout(location = 1) in vec2 end_b;
layout(location = 2) in vec2 radii;  // px

uniform vec2 picture;  // px

flat out vec3 shape;  // length, radii; px
out vec2 along_across;

void main() {
  vec2 step_px = end_b - end_a;
  float length_px = length(step_px);
  vec2 direction = length_px > 1e-4 ? step_px / length_px : vec2(1.0, 0.0);
  float margin = max(radii.x, radii.y) + 1.0;
  float along = (gl_VertexID & 1) == 1 ? length_px + margin : -margin;
  float across = (gl_VertexID & 2) == 2 ? margin : -margin;
  vec2 at = end_a + direction * along + vec2(-direction.y, direction.x) * across;
  gl_Position = vec4(2.0 * at.x / picture.x - 1.0, 1.0 - 2.0 * at.y / picture.y, 0.0, 1.0);
  shape = vec3(length_px, radii);
  along_across = vec2(along, across);
}
