// A line in the world as a capsule of constant width on the picture: one instance a line, four
// corners from the vertex number. Lines that come to lie closer together than pixels can show are
// fainter, so that the picture keeps the color of the faces between them.
layout(location = 0) in vec3 end_a;
layout(location = 1) in vec3 end_b;
layout(location = 2) in vec4 color;  // sRGB, alpha
layout(location = 3) in vec3 width_dash_spacing;  // px, px, m
layout(location = 4) in vec4 behind;  // normal of the face that the line lies on the back of, or 0

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform vec2 picture;  // px
uniform float near;    // m
uniform float pull;    // towards the eye, of the distance to it
uniform float scale;   // of widths and dashes
uniform float metre;   // px that a metre takes at the distance of 1 m
uniform vec2 full;     // px between lines, px of a line: from either on they have all their color
uniform float least;   // part of their color that the faintest lines keep
uniform float depth_unit;  // how far clip z moves when a point moves by its distance to the eye

flat out vec4 ink;     // linear
flat out vec3 shape;   // length, half width, dash; px
out vec2 along_across; // px

void main() {
  // Drawn a little nearer than they are, so that a face never hides its own edge.
  vec4 nearer = vec4(0.0, 0.0, pull * depth_unit, 0.0);
  vec4 a = clip_from_world * vec4(end_a, 1.0) - nearer;
  vec4 b = clip_from_world * vec4(end_b, 1.0) - nearer;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  ink = vec4(0.0);
  shape = vec3(0.0);
  along_across = vec2(0.0);
  if (a.w < near && b.w < near) return;
  if (dot(behind.xyz, eye - end_a) > 0.0) return;
  vec4 cut = mix(a, b, (near - a.w) / (b.w - a.w));
  if (a.w < near) a = cut;
  if (b.w < near) b = cut;

  vec3 from = a.xyz / a.w, to = b.xyz / b.w;
  vec2 step_px = 0.5 * (to.xy - from.xy) * picture;
  float length_px = length(step_px);
  vec2 direction = length_px > 1e-4 ? step_px / length_px : vec2(1.0, 0.0);
  float width = width_dash_spacing.x * scale;
  float half_width = 0.5 * max(width, 1.0);
  float margin = half_width + 0.5;
  bool at_end = (gl_VertexID & 1) == 1;
  float along = at_end ? length_px + margin : -margin;
  float across = (gl_VertexID & 2) == 2 ? margin : -margin;
  vec2 offset = direction * along + vec2(-direction.y, direction.x) * across;
  float depth_slope = (to.z - from.z) / max(length_px, 2.0 * margin);
  // w is 1: everything between the corners is then linear on the picture, depth included.
  gl_Position = vec4(from.xy + 2.0 * offset / picture, from.z + depth_slope * along, 1.0);
  float spacing_px = width_dash_spacing.z * metre / (0.5 * (a.w + b.w));
  vec2 part = vec2(spacing_px, length_px) / (full * scale);
  float crowded = width_dash_spacing.z > 0.0 ? clamp(max(part.x, part.y), least, 1.0) : 1.0;
  float thin = min(width, 1.0) * crowded;
  ink = vec4(LinearFromSrgb(color.rgb), color.a * thin);
  shape = vec3(length_px, half_width, width_dash_spacing.y * scale);
  along_across = vec2(along, across);
}
