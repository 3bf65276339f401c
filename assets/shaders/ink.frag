// Coverage only, the greatest of a stroke's pieces: joints are neither gaps nor darker.
flat in vec3 shape;
in vec2 along_across;
layout(location = 0) out vec4 coverage;

void main() {
  float t = shape.x > 0.0 ? clamp(along_across.x / shape.x, 0.0, 1.0) : 0.0;
  float radius = mix(shape.y, shape.z, t);
  float from_axis = length(vec2(along_across.x - t * shape.x, along_across.y));
  // Lines thinner than a pixel are paler, not narrower.
  float thin = min(2.0 * radius, 1.0);
  coverage = vec4(thin * clamp(max(radius, 0.5) + 0.5 - from_axis, 0.0, 1.0), 0.0, 0.0, 1.0);
}
