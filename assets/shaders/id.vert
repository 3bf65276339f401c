// Faces as the pen feels them: each pixel says which one it is.
flat out vec4 face_id;

void main() {
  gl_Position = Place();
  face_id = id;
}
