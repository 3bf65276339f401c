// Faces as the pen feels them: each pixel says which one it is.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 3) in vec4 id;  // four bytes, lowest first
uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float back_push;
flat out vec4 face_id;
void main() {
  vec3 away = position - eye;
  bool back = dot(normal.xyz, away) > 0.0;
  gl_Position = clip_from_world * vec4(back ? position + away * back_push : position, 1.0);
  face_id = id;
}
