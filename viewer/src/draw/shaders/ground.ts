// GLSL of planes with lines at equal distances, and of the shadows of obstacles.

/** Vertices of a rectangle; `local` are lengths along both axes of the plane. */
export const GROUND_VERTEX = /* glsl */ `
in vec2 local;
out vec2 onPlane;
void main() {
  onPlane = local;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

export const GROUND_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec4 face;        // colour and opacity of the plane
uniform float spacing;    // distance of the lines
uniform vec4 bounds;      // smallest and largest coordinates along both axes
uniform float fade;       // width of the transparent border, 0: sharp edge with a line
in vec2 onPlane;
out vec4 colour;

// Share of a pixel that lines at integer positions cover.
float lines(vec2 x) {
  vec2 size = max(fwidth(x), 1e-6);
  vec2 distance = abs(fract(x - 0.5) - 0.5) / size;
  vec2 cover = clamp(1.0 - distance, 0.0, 1.0) * clamp(0.6 - 0.6 * (size - 0.25) / 0.5, 0.0, 0.6);
  return max(cover.x, cover.y);
}

void main() {
  vec2 border = min(onPlane - bounds.xy, bounds.zw - onPlane);
  float inside = min(border.x, border.y);
  float line = lines(onPlane / spacing);
  if (fade == 0.0) line = max(line, 1.0 - clamp(inside / max(fwidth(inside), 1e-9) - 0.5, 0.0, 1.0));
  float alpha = face.a * (gl_FrontFacing ? 1.0 : 0.4);
  float opacity = mix(alpha, max(alpha, 0.6), line);
  if (fade > 0.0) opacity *= smoothstep(0.0, fade, inside);
  vec3 base = mix(face.rgb, vec3(0.44, 0.47, 0.51), line * (face.a > 0.0 ? 0.75 : 1.0));
  colour = vec4(base * opacity, opacity);
}
`;
