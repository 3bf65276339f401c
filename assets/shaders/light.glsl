// Colour and light shared by faces and ground. Prepended where it is needed; linear colours.

vec3 LinearFromSrgb(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

uniform highp sampler2DShadow shadow_map;
uniform float shadow_soft;  // of the map's side, how far its taps lie apart; 0: one tap

// The part of the sun that reaches a point: one tap or four, each filtered over 2 x 2 texels.
// Outside the map, and beyond its far side's nothing, all is lit.
float SunReaching(vec3 at) {
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
  float depth = clamp(at.z, 0.0, 1.0);
  if (shadow_soft == 0.0) return texture(shadow_map, vec3(at.xy, depth));
  float r = shadow_soft;
  return 0.25 * (texture(shadow_map, vec3(at.xy + vec2(-r, -0.4 * r), depth)) +
                 texture(shadow_map, vec3(at.xy + vec2(0.4 * r, -r), depth)) +
                 texture(shadow_map, vec3(at.xy + vec2(r, 0.4 * r), depth)) +
                 texture(shadow_map, vec3(at.xy + vec2(-0.4 * r, r), depth)));
}
