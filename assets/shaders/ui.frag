// Panels' colours are blended as sRGB bytes, as their style was designed.
in vec2 at_texture;
in vec4 tint;
uniform sampler2D image;
layout(location = 0) out vec4 pixel;

void main() { pixel = tint * texture(image, at_texture); }
