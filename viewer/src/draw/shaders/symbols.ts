// GLSL of everything that moves: positions come from the textures of points.ts, so that a frame costs no upload.

import { WIDTH } from "../points";

/** A point of an instant: between two frames, then enlarged from the reference. Same formula as instant.ts. */
export const POINT = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
uniform sampler2D centres;
uniform sampler2D referenceCentres;
uniform int points;
uniform ivec2 frames;
uniform float weight;
uniform float scale;
uniform float pixel;      // height of a pixel at distance one

ivec2 texel(int i) { return ivec2(i % ${WIDTH}, i / ${WIDTH}); }

vec3 between(int i) {
  vec3 a = texelFetch(centres, texel(frames.x * points + i), 0).xyz;
  vec3 b = texelFetch(centres, texel(frames.y * points + i), 0).xyz;
  return mix(a, b, weight);
}

vec3 point(int i) {
  vec3 x = between(i);
  vec4 r = texelFetch(referenceCentres, texel(i), 0);
  return mix(x, r.xyz + scale * (x - r.xyz), r.w);      // w = 0: a point that is never scaled
}

float pixelAt(vec3 world) {
  return pixel * max(1e-20, -(viewMatrix * vec4(world, 1.0)).z);
}

// Two unit vectors across a direction.
void across(vec3 n, out vec3 u, out vec3 v) {
  vec3 most = abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  u = normalize(cross(n, most));
  v = cross(n, u);
}
`;

/** Sections swept along the stations; boxes and spheres of rigid bodies are sections with a length. */
export const SWEEP_VERTEX = /* glsl */ `
${POINT}
uniform usampler2D directors;
uniform usampler2D referenceDirectors;
uniform usampler2D field;
uniform int stations;
uniform float thickness;
uniform float least;      // half the width in pixels below which nothing gets
uniform bool ghost;
in vec3 local;            // along d1, d2, d3
in vec3 slope;            // normal, likewise
in float end;             // 0: at the instance's station, 1: at the next one
in float at;
in float body;
in float radius;
in vec3 near;             // factors of the local coordinates at either end
in vec3 far;
out vec3 facing;
out vec3 eye;
out float level;
out float missing;
flat out int owner;

void axes(usampler2D from, int i, out vec3 y, out vec3 z) {
  uvec4 w = texelFetch(from, texel(i), 0);
  int yx = int(w.x << 16) >> 16, yy = int(w.x) >> 16, yz = int(w.y << 16) >> 16;
  int zx = int(w.y) >> 16, zy = int(w.z << 16) >> 16, zz = int(w.z) >> 16;
  y = vec3(yx, yy, yz) / 32767.0;
  z = vec3(zx, zy, zz) / 32767.0;
}

void main() {
  int i = int(at + end + 0.5);
  vec3 y, z, ry, rz;
  axes(referenceDirectors, i, ry, rz);
  vec3 centre = texelFetch(referenceCentres, texel(i), 0).xyz;
  float a = 65535.0, b = 65535.0;
  if (ghost) {
    y = ry;
    z = rz;
  } else {
    vec3 ay, az, by, bz;
    axes(directors, frames.x * stations + i, ay, az);
    axes(directors, frames.y * stations + i, by, bz);
    y = ry + scale * (mix(ay, by, weight) - ry);
    z = rz + scale * (mix(az, bz, weight) - rz);
    centre = point(i);
    a = float(texelFetch(field, texel(frames.x * stations + i), 0).r);
    b = float(texelFetch(field, texel(frames.y * stations + i), 0).r);
  }
  y = normalize(y + vec3(1e-9));
  z = normalize(z + vec3(1e-9));
  vec3 x = normalize(cross(y, z) + vec3(1e-9));
  float wide = max(thickness, least * pixelAt(centre) / max(radius, 1e-30));
  vec3 part = local * mix(near, far, end) * wide;
  vec3 world = centre + part.x * x + part.y * y + part.z * z;
  vec3 normal = slope.x * x + slope.y * y + slope.z * z;
  vec4 seen = viewMatrix * vec4(world, 1.0);
  facing = mat3(viewMatrix) * normal;
  eye = seen.xyz;
  level = mix(a, b, weight) / 65534.0;
  missing = max(a, b) > 65534.5 ? 1.0 : 0.0;
  owner = int(body + 0.5);
  gl_Position = projectionMatrix * seen;
}
`;

/** Light from over the viewer's left shoulder, from the sky and a little from behind. */
const LIGHT = /* glsl */ `
vec3 lit(vec3 base, vec3 facing, vec3 eye) {
  vec3 n = normalize(facing);
  vec3 v = normalize(-eye);
  if (dot(n, v) < 0.0) n = -n;
  vec3 key = normalize(vec3(-0.45, 0.75, 0.9));
  vec3 fill = normalize(vec3(0.8, -0.1, 0.5));
  float diffuse = 0.60 + 0.42 * max(0.0, dot(n, key)) + 0.14 * max(0.0, dot(n, fill)) - 0.16 * max(0.0, -n.y);
  float shine = pow(max(0.0, dot(n, normalize(key + v))), 48.0);
  float rim = pow(1.0 - max(0.0, dot(n, v)), 3.0);
  return base * (diffuse - 0.18 * rim) + 0.16 * shine;
}
`;

export const SWEEP_FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D colours;
uniform vec2 window;      // share of the colours' span at the least and the greatest value of the field
uniform vec3 bodies[8];
uniform bool ghost;
uniform bool coloured;
uniform vec4 plain;       // of the ghost
in vec3 facing;
in vec3 eye;
in float level;
in float missing;
flat in int owner;
out vec4 colour;
${LIGHT}
void main() {
  if (ghost) {
    float rim = 1.0 - abs(dot(normalize(facing), normalize(-eye)));
    colour = vec4(plain.rgb, plain.a * (0.55 + 0.45 * rim));
    colour.rgb *= colour.a;
    return;
  }
  vec3 base = bodies[owner % 8];
  if (coloured) {
    base = missing > 0.0 ? vec3(0.6) : texture(colours, vec2(mix(window.x, window.y, level), 0.5)).rgb;
  }
  colour = vec4(lit(base, facing, eye), 1.0);
}
`;

/** A flat sign of a few pixels at a marker. */
export const MARKER_VERTEX = /* glsl */ `
${POINT}
uniform vec2 viewport;
uniform float width;      // pixels
in vec2 corner;
in float at;
in float kind;
out vec2 spot;
flat out int token;
void main() {
  vec4 clip = projectionMatrix * viewMatrix * vec4(point(int(at + 0.5)), 1.0);
  clip.xy += corner * width / viewport * clip.w;
  spot = corner;
  token = int(kind + 0.5);
  gl_Position = clip;
}
`;

export const MARKER_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 signs[3];
uniform vec3 paper;
in vec2 spot;
flat in int token;
out vec4 colour;
float away(vec2 p) {
  if (token == 1) return (abs(p.x) + abs(p.y)) * 0.92;
  if (token == 2) return max(abs(p.x) * 0.9 + p.y * 0.52, -p.y) * 1.35;
  return length(p);
}
void main() {
  float d = away(spot);
  float soft = fwidth(d);
  float inside = 1.0 - smoothstep(0.92 - soft, 0.92, d);
  float edge = smoothstep(0.62 - soft, 0.62, d);
  float core = 1.0 - smoothstep(0.30 - soft, 0.30, d);
  vec3 c = mix(signs[token], paper, edge);
  if (token == 0) c = mix(c, paper, core);
  colour = vec4(c * inside, inside);
}
`;

/** Arrows of forces and moments: shaft and heads with widths in pixels and a length in space. */
export const ARROW_VERTEX = /* glsl */ `
${POINT}
uniform float head;       // pixels
uniform vec2 lengths;     // length in space of one unit of force, of moment
in vec4 shape;            // along (lengths), back (heads), radius (heads), angle
in float second;          // 1: belongs to the second head, for moments only
in vec2 anchor;           // index of the marker and of the vector
in float moment;
out vec3 facing;
out vec3 eye;
flat out int owner;
void main() {
  vec3 base = point(int(anchor.x + 0.5));
  vec3 v = between(int(anchor.y + 0.5));
  float size = length(v);
  float long_ = size * (moment > 0.5 ? lengths.y : lengths.x);
  vec3 n = v / max(size, 1e-30), u, w;
  across(n, u, w);
  float h = min(head * pixelAt(base), 0.45 * long_);
  if (second > 0.5 && moment < 0.5) h = 0.0;
  vec3 radial = cos(shape.w) * u + sin(shape.w) * w;
  vec3 world = base + n * (shape.x * long_ - shape.y * h) + radial * shape.z * h;
  vec4 seen = viewMatrix * vec4(world, 1.0);
  facing = mat3(viewMatrix) * (radial + 0.3 * n);
  eye = seen.xyz;
  owner = moment > 0.5 ? 1 : 0;
  gl_Position = long_ > 0.0 ? projectionMatrix * seen : vec4(0.0, 0.0, 2.0, 1.0);
}
`;

/** Links: a straight rod, or the wire of a coil between the two ends. */
export const LINK_VERTEX = /* glsl */ `
${POINT}
uniform float coil;       // radius of a spring
uniform float wire;
uniform float least;
in vec2 shape;            // share of the length, angle around the wire
in float at;
in float turns;           // 0: straight
in float wide;            // factor of the radius
in float body;
out vec3 facing;
out vec3 eye;
flat out int owner;
void main() {
  vec3 a = point(int(at + 0.5)), b = point(int(at + 1.5));
  vec3 n = b - a, u, v;
  float size = length(n);
  n = size > 0.0 ? n / size : vec3(1.0, 0.0, 0.0);
  across(n, u, v);
  float s = shape.x;
  float r = turns > 0.0 ? coil * smoothstep(0.06, 0.12, s) * (1.0 - smoothstep(0.88, 0.94, s)) : 0.0;
  float share = clamp((s - 0.09) / 0.82, 0.0, 1.0);
  float phi = 6.2831853 * turns * share;
  vec3 out_ = cos(phi) * u + sin(phi) * v;
  vec3 centre = a + n * (s * size) + r * out_;
  vec3 along = normalize(n * max(size, 1e-20) + r * 6.2831853 * turns * (cos(phi) * v - sin(phi) * u));
  vec3 normal = cos(shape.y) * out_ + sin(shape.y) * cross(along, out_);
  vec3 world = centre + normal * wide * max(wire, least * pixelAt(centre));
  vec4 seen = viewMatrix * vec4(world, 1.0);
  facing = mat3(viewMatrix) * normal;
  eye = seen.xyz;
  owner = int(body + 0.5);
  gl_Position = projectionMatrix * seen;
}
`;

/** Lit in the colour of its kind. */
export const SOLID_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 solids[5];
in vec3 facing;
in vec3 eye;
flat in int owner;
out vec4 colour;
${LIGHT}
void main() { colour = vec4(lit(solids[owner % 5], facing, eye), 1.0); }
`;
