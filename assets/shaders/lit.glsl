// The light that a face sends back, from what face.vert worked out. Prepended to faces' shaders.
flat in vec3 ambient;
flat in vec3 sunlit;
in vec3 shadow_at;
in float foot;

uniform vec2 base_shade;

vec3 Lit() {
  vec3 light = ambient;
  if (sunlit.r + sunlit.g + sunlit.b > 0.0) light += sunlit * SunReaching(shadow_at);
  return light * (1.0 - base_shade.x * foot * foot);
}
