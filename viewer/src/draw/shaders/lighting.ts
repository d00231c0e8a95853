// GLSL for the lighting of solids.

/**
 * Lighting in camera coordinates: key light from the upper left with a Blinn-Phong highlight, fill light, and a rim that
 * contrasts with the background: dark in the light theme, bright in the dark one.
 */
export const LIGHTING_GLSL = /* glsl */ `
uniform float backdrop;   // 0: light theme, 1: dark theme
vec3 shade(vec3 base, vec3 viewNormal, vec3 viewPosition) {
  vec3 n = normalize(viewNormal);
  vec3 v = normalize(-viewPosition);
  if (dot(n, v) < 0.0) n = -n;
  vec3 key = normalize(vec3(-0.45, 0.75, 0.9));
  vec3 fill = normalize(vec3(0.8, -0.1, 0.5));
  float diffuse = 0.60 + 0.42 * max(0.0, dot(n, key)) + 0.14 * max(0.0, dot(n, fill)) - 0.16 * max(0.0, -n.y);
  float specular = pow(max(0.0, dot(n, normalize(key + v))), 48.0);
  float rim = 1.0 - max(0.0, dot(n, v));
  float lift = backdrop * (0.12 + 0.3 * rim * rim * rim);
  float dim = (1.0 - backdrop) * 0.45 * rim * rim;
  return base * (diffuse - dim) * (1.0 - lift) + lift + 0.16 * specular;
}
`;
