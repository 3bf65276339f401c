// Paper, and on the plane y = 0 a metre grid that fades out and the building's shadow.
in vec3 ray;
in float height;

uniform vec3 eye;
uniform vec3 paper_low;  // sRGB
uniform vec3 paper_high;
uniform vec3 grid_ink;   // sRGB
uniform vec3 grid_strength;  // of 1 m, 10 m, 100 m lines
uniform vec3 shadow_ink; // linear factor where the sun does not reach
uniform vec3 ground_middle;
uniform vec2 ground_fade;  // m: full inside the first, none outside the second
uniform mat4 shadow_from_world;
uniform float shadow_bias;
uniform float with_ground;

layout(location = 0) out vec4 pixel;

// Coverage of lines one pixel wide, every `step` metres; none where they would run together.
float Grid(vec2 at, vec2 pixel_size, float step_m) {
  vec2 from_line = abs(fract(at / step_m + 0.5) - 0.5) * step_m;
  vec2 cover = clamp(1.0 - from_line / pixel_size, 0.0, 1.0);
  vec2 crowded = 1.0 - smoothstep(0.08, 0.3, pixel_size / step_m);
  return max(cover.x * crowded.x, cover.y * crowded.y);
}

void main() {
  vec3 color = LinearFromSrgb(mix(paper_low, paper_high, smoothstep(0.0, 1.0, height)));
  float down = -ray.y / length(ray);
  float distance_along = eye.y / max(-ray.y, 1e-6);
  vec3 at = eye + ray * distance_along;
  at.y = 0.0;
  vec2 pixel_size = max(fwidth(at.xz), vec2(1e-6));
  if (with_ground > 0.5 && eye.y > 0.0 && down > 1e-3) {
    float near_middle =
        1.0 - smoothstep(ground_fade.x, ground_fade.y, distance(at, ground_middle));
    vec3 grids = vec3(Grid(at.xz, pixel_size, 1.0), Grid(at.xz, pixel_size, 10.0),
                      Grid(at.xz, pixel_size, 100.0)) * grid_strength;
    float ink = max(grids.x, max(grids.y, grids.z));
    color = mix(color, LinearFromSrgb(grid_ink), ink * near_middle);
    vec3 shadow_at = (shadow_from_world * vec4(at + vec3(0.0, shadow_bias, 0.0), 1.0)).xyz;
    color *= mix(shadow_ink, vec3(1.0), SunReaching(shadow_at));
  }
  pixel = vec4(color, 1.0);
}
