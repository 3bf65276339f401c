// Flat-shaded faces: light that is the same all over a triangle is worked out here.
layout(location = 2) in vec4 color;  // sRGB
layout(location = 4) in vec2 uv;     // where an image is worn, its rows from the top; else unused

uniform mat4 shadow_from_world;
uniform vec3 to_sun;
uniform vec3 to_fill;
uniform vec3 sun_light;
uniform vec3 fill_light;
uniform vec3 sky_light;
uniform vec3 ground_light;
uniform float shadow_bias;       // m, along the normal
uniform vec2 base_shade;         // darkening at the foot: amount, height in m
uniform float base_height;       // y of the foot, m

flat out vec3 ambient;
flat out vec3 sunlit;
out vec3 shadow_at;
out float foot;
out vec2 at_image;

void main() {
  gl_Position = Place();
  vec3 n = normalize(SeenFromBehind() ? -normal.xyz : normal.xyz);

  vec3 albedo = LinearFromSrgb(color.rgb);
  float slope = dot(n, to_sun);
  ambient = albedo * (mix(ground_light, sky_light, 0.5 * n.y + 0.5) +
                      fill_light * max(dot(n, to_fill), 0.0));
  sunlit = albedo * sun_light * max(slope, 0.0);
  shadow_at = (shadow_from_world * vec4(position + n * shadow_bias, 1.0)).xyz;
  foot = 1.0 - clamp((position.y - base_height) / base_shade.y, 0.0, 1.0);
  at_image = uv;
}
