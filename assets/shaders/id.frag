flat in vec4 face_id;
layout(location = 0) out vec4 pixel;
void main() { pixel = face_id; }
