// GLSL of markers, arrows and links.

import { LIGHTING_GLSL } from "./lighting";
import { POINT_GLSL } from "./point";

/** Vertices of the flat symbol of a marker, with a size in pixels. */
export const MARKER_VERTEX = /* glsl */ `
${POINT_GLSL}
uniform vec2 viewport;
uniform float width;      // pixels
in vec2 corner;
in float marker;
in float kind;
out vec2 position2d;
flat out int symbol;
void main() {
  vec4 clip = projectionMatrix * viewMatrix * vec4(point(int(marker + 0.5)), 1.0);
  clip.xy += corner * width / viewport * clip.w;
  position2d = corner;
  symbol = int(kind + 0.5);
  gl_Position = clip;
}
`;

export const MARKER_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 symbolColours[3];
uniform vec3 background;
in vec2 position2d;
flat in int symbol;
out vec4 colour;
// Distance function of the symbol: circle of a joint, diamond of a probe, triangle of a load.
float symbolDistance(vec2 p) {
  if (symbol == 1) return (abs(p.x) + abs(p.y)) * 0.92;
  if (symbol == 2) return max(abs(p.x) * 0.9 + p.y * 0.52, -p.y) * 1.35;
  return length(p);
}
void main() {
  float d = symbolDistance(position2d);
  float soft = fwidth(d);
  float inside = 1.0 - smoothstep(0.92 - soft, 0.92, d);
  float edge = smoothstep(0.62 - soft, 0.62, d);
  float core = 1.0 - smoothstep(0.30 - soft, 0.30, d);
  vec3 c = mix(symbolColours[symbol], background, edge);
  if (symbol == 0) c = mix(c, background, core);
  colour = vec4(c * inside, inside);
}
`;

/** Vertices of arrows of forces and moments. The length is in space, widths are in pixels. */
export const ARROW_VERTEX = /* glsl */ `
${POINT_GLSL}
uniform float head;       // length of a head in pixels
in vec4 shape;            // position (arrow lengths), backward shift (heads), radius (heads), angle
in float secondHead;      // 1: vertex of the second head, drawn for moments only
in vec2 anchor;           // indices of the base and of the vector
in float moment;
in float perUnit;         // length in space per unit of the vector
in float colour;
out vec3 viewNormal;
out vec3 viewPosition;
flat out int colourIndex;
void main() {
  vec3 base = point(int(anchor.x + 0.5));
  vec3 v = interpolated(int(anchor.y + 0.5));
  float size = length(v);
  float arrowLength = size * perUnit;
  vec3 n = v / max(size, 1e-30), u, w;
  perpendicular(n, u, w);
  float h = min(head * pixelSize(base), 0.45 * arrowLength);
  if (secondHead > 0.5 && moment < 0.5) h = 0.0;
  vec3 radial = cos(shape.w) * u + sin(shape.w) * w;
  vec3 world = base + n * (shape.x * arrowLength - shape.y * h) + radial * shape.z * h;
  vec4 view = viewMatrix * vec4(world, 1.0);
  viewNormal = mat3(viewMatrix) * (radial + 0.3 * n);
  viewPosition = view.xyz;
  colourIndex = int(colour + 0.5);
  gl_Position = arrowLength > 0.0 ? projectionMatrix * view : vec4(0.0, 0.0, 2.0, 1.0);
}
`;

/** Vertices of links: a straight rod, or the wire of a coil spring between both ends. */
export const LINK_VERTEX = /* glsl */ `
${POINT_GLSL}
uniform float coil;       // radius of the coil of a spring
uniform float wire;       // radius of a rod or wire
uniform float minPixels;  // lower limit of the radius in pixels
in vec2 shape;            // position along the length (0 to 1), angle around the wire
in vec2 ends;             // indices of both ends
in float turns;           // number of turns, 0: straight
in float radiusFactor;
in float colour;
out vec3 viewNormal;
out vec3 viewPosition;
flat out int colourIndex;
void main() {
  vec3 a = point(int(ends.x + 0.5)), b = point(int(ends.y + 0.5));
  vec3 n = b - a, u, v;
  float size = length(n);
  n = size > 0.0 ? n / size : vec3(1.0, 0.0, 0.0);
  perpendicular(n, u, v);
  float s = shape.x;
  float r = turns > 0.0 ? coil * smoothstep(0.06, 0.12, s) * (1.0 - smoothstep(0.88, 0.94, s)) : 0.0;
  float along = clamp((s - 0.09) / 0.82, 0.0, 1.0);
  float phi = 6.2831853 * turns * along;
  vec3 radial = cos(phi) * u + sin(phi) * v;
  vec3 centre = a + n * (s * size) + r * radial;
  vec3 tangent = normalize(n * max(size, 1e-20) + r * 6.2831853 * turns * (cos(phi) * v - sin(phi) * u));
  vec3 normal = cos(shape.y) * radial + sin(shape.y) * cross(tangent, radial);
  vec3 world = centre + normal * radiusFactor * max(wire, minPixels * pixelSize(centre));
  vec4 view = viewMatrix * vec4(world, 1.0);
  viewNormal = mat3(viewMatrix) * normal;
  viewPosition = view.xyz;
  colourIndex = int(colour + 0.5);
  gl_Position = projectionMatrix * view;
}
`;

/** Shaded surface of arrows, links and supported edges. */
export const SOLID_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 solidColours[7];
in vec3 viewNormal;
in vec3 viewPosition;
flat in int colourIndex;
out vec4 colour;
${LIGHTING_GLSL}
void main() { colour = vec4(shade(solidColours[colourIndex % 7], viewNormal, viewPosition), 1.0); }
`;
