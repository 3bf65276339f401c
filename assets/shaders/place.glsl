// Where faces go, the same in pictures and ids. Prepended to both vertex shaders.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // w: 1 where the face yields to others that it touches
layout(location = 3) in vec4 id;  // four bytes, lowest first

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float back_push;   // of the distance to the eye
uniform float layer_push;
uniform float depth_unit;  // how far clip z moves when a point moves by its distance to the eye

bool SeenFromBehind() { return dot(normal.xyz, position - eye) > 0.0; }

// Faces that lie in one plane must not fight for its pixels. One that is seen from behind yields to
// one that is seen from the front, and of sixteen neighbours in the order of ids the last wins, or
// the one that doesn't yield.
// A push along the ray from the eye changes clip z alone, and so no pixel.
vec4 Place() {
  float layer = 15.0 - mod(round(id.x * 255.0), 16.0) + 16.0 * normal.w;
  float push = layer * layer_push + (SeenFromBehind() ? back_push : 0.0);
  return clip_from_world * vec4(position, 1.0) + vec4(0.0, 0.0, push * depth_unit, 0.0);
}
