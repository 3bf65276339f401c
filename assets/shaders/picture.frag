// A canvas where there is no ink.
layout(location = 0) out vec4 pixel;
void main() { pixel = Pixel(PictureHere()); }
