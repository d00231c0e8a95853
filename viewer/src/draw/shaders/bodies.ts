// GLSL of the bodies and of the ghost of their reference configuration.

import { LIGHTING_GLSL } from "./lighting";
import { POINT_GLSL } from "./point";

/** Vertices of sections swept along the stations, and of boxes and spheres of rigid bodies. */
export const BODY_VERTEX = /* glsl */ `
${POINT_GLSL}
uniform usampler2D directors;
uniform usampler2D referenceDirectors;
uniform usampler2D field;
uniform int stations;
uniform float thickness;
uniform float minPixels;  // lower limit of the radius in pixels
uniform bool ghost;
uniform bool shadow;      // projection onto the ground
uniform bool crease;      // line on a surface
uniform vec4 ground;      // vertical axis and level of the ground
in vec3 local;            // coordinates along d1, d2, d3
in vec3 localNormal;      // components along d1, d2, d3
in float end;             // 0: station of the instance, 1: next station, ..
in float station;
in float body;
in float radius;
in vec2 face;             // coordinates on a face with edges
in vec3 startScale;       // factors of the local coordinates at both ends
in vec3 endScale;
out vec3 viewNormal;
out vec3 viewPosition;
out float level;
out float missing;
out float height;         // above the ground
out vec2 onFace;
flat out int colourIndex;

void sectionAxes(usampler2D source, int i, out vec3 y, out vec3 z) {
  uvec4 w = texelFetch(source, texel(i), 0);
  int yx = int(w.x << 16) >> 16, yy = int(w.x) >> 16, yz = int(w.y << 16) >> 16;
  int zx = int(w.y) >> 16, zy = int(w.z << 16) >> 16, zz = int(w.z) >> 16;
  y = vec3(yx, yy, yz) / 32767.0;
  z = vec3(zx, zy, zz) / 32767.0;
}

void main() {
  int i = int(station + end + 0.5);
  vec3 y, z, ry, rz;
  sectionAxes(referenceDirectors, i, ry, rz);
  vec3 centre = texelFetch(referenceCentres, texel(i), 0).xyz;
  float a = 65535.0, b = 65535.0;
  if (ghost) {
    y = ry;
    z = rz;
  } else {
    vec3 ay, az, by, bz;
    sectionAxes(directors, frames.x * stations + i, ay, az);
    sectionAxes(directors, frames.y * stations + i, by, bz);
    y = ry + scale * (mix(ay, by, weight) - ry) + imaginary * (by - ry);
    z = rz + scale * (mix(az, bz, weight) - rz) + imaginary * (bz - rz);
    centre = point(i);
    a = float(texelFetch(field, texel(frames.x * stations + i), 0).r);
    b = float(texelFetch(field, texel(frames.y * stations + i), 0).r);
  }
  y = normalize(y + vec3(1e-9));
  z = normalize(z + vec3(1e-9));
  vec3 x = normalize(cross(y, z) + vec3(1e-9));
  float size = max(thickness, minPixels * pixelSize(centre) / max(radius, 1e-30));
  vec3 offset = local * mix(startScale, endScale, min(end, 1.0)) * size;
  vec3 world = centre + offset.x * x + offset.y * y + offset.z * z;
  height = dot(world, ground.xyz) - ground.w;
  if (shadow) world -= height * ground.xyz;
  onFace = face;
  vec3 normal = localNormal.x * x + localNormal.y * y + localNormal.z * z;
  vec4 view = viewMatrix * vec4(world, 1.0);
  viewNormal = mat3(viewMatrix) * normal;
  viewPosition = view.xyz;
  level = mix(a, b, weight) / 65534.0;
  missing = max(a, b) > 65534.5 ? 1.0 : 0.0;
  colourIndex = int(body + 0.5);
  // Lines are in front of the faces that they bound.
  gl_Position = projectionMatrix * vec4(crease ? view.xyz * 0.9995 : view.xyz, 1.0);
}
`;

export const BODY_FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D colours;
uniform vec2 window;      // positions in the colour map of the smallest and largest value of the field
uniform vec3 palette[8];
uniform bool ghost;
uniform bool coloured;
uniform bool shadow;
uniform bool crease;
uniform float edges;      // strength of the lines on faces
uniform float fading;     // height at which a shadow has faded to a third
uniform vec4 ghostColour;
in vec3 viewNormal;
in vec3 viewPosition;
in float level;
in float missing;
in float height;
in vec2 onFace;
flat in int colourIndex;
out vec4 colour;
${LIGHTING_GLSL}
void main() {
  if (ghost) {
    float rim = 1.0 - abs(dot(normalize(viewNormal), normalize(-viewPosition)));
    colour = vec4(ghostColour.rgb, ghostColour.a * (0.55 + 0.45 * rim));
    colour.rgb *= colour.a;
    return;
  }
  if (shadow) {
    if (height < 0.0) discard;
    colour = vec4(0.0, 0.0, 0.0, 0.10 + 0.24 * exp(-height / fading));
    return;
  }
  vec3 base = palette[colourIndex % 8];
  if (coloured) {
    base = missing > 0.0 ? vec3(0.68, 0.71, 0.74) : texture(colours, vec2(mix(window.x, window.y, level), 0.5)).rgb;
  }
  vec2 size = max(fwidth(onFace), 1e-6);
  vec2 edge = (1.0 - abs(mod(onFace + 1.0, 2.0) - 1.0)) / size;
  // Lines fade out on faces of a few pixels.
  vec2 lines = (1.0 - smoothstep(0.8, 1.8, edge)) * (1.0 - smoothstep(0.1, 0.3, size));
  float line = crease ? 1.0 : edges * max(lines.x, lines.y);
  colour = vec4(shade(base, viewNormal, viewPosition) * (1.0 - 0.55 * line), 1.0);
}
`;
