// Faces that wear an image; it is opaque, and linear by its format.
in vec2 at_image;
uniform sampler2D image;
layout(location = 0) out vec4 pixel;
void main() { pixel = vec4(Lit() * texture(image, at_image).rgb, 1.0); }
