flat in vec3 ambient;
flat in vec3 sunlit;
in vec3 shadow_at;
in float foot;

uniform vec2 base_shade;

layout(location = 0) out vec4 pixel;

void main() {
  vec3 light = ambient;
  if (sunlit.r + sunlit.g + sunlit.b > 0.0) light += sunlit * SunReaching(shadow_at);
  pixel = vec4(light * (1.0 - base_shade.x * foot * foot), 1.0);
}
