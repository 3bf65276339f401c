flat in vec4 ink;
flat in vec3 shape;
in vec2 along_across;
uniform float strength;
layout(location = 0) out vec4 pixel;

void main() {
  float beyond = along_across.x - clamp(along_across.x, 0.0, shape.x);
  float cover = clamp(shape.y + 0.5 - length(vec2(beyond, along_across.y)), 0.0, 1.0);
  if (shape.z > 0.0) {
    float phase = mod(along_across.x, 2.0 * shape.z);
    float from_dash = min(abs(phase - 0.5 * shape.z), abs(phase - 2.5 * shape.z));
    cover *= clamp(0.5 * shape.z + 0.5 - from_dash, 0.0, 1.0);
  }
  // Nothing is discarded: that would cost the early depth test, which is faster.
  float alpha = ink.a * cover * strength;
  pixel = vec4(ink.rgb * alpha, alpha);
}
