// Faces of one colour.
layout(location = 0) out vec4 pixel;
void main() { pixel = vec4(Lit(), 1.0); }
