// GLSL for the positions of points. They are read from textures (see ../points.ts), so a frame needs no upload.

/** Width of the textures in texels. */
export const TEXTURE_WIDTH = 2048;

/**
 * Position of a point: interpolation between two frames, then scaling of the displacement from the reference. In a complex shape, the
 * second frame is its imaginary part.
 * The formulas are those of scene/blend.ts.
 */
export const POINT_GLSL = /* glsl */ `
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
uniform float imaginary;  // scale of the second frame, which is added
uniform float pixel;      // height of a pixel at unit distance

ivec2 texel(int i) { return ivec2(i % ${TEXTURE_WIDTH}, i / ${TEXTURE_WIDTH}); }

vec3 interpolated(int i) {
  vec3 a = texelFetch(centres, texel(frames.x * points + i), 0).xyz;
  vec3 b = texelFetch(centres, texel(frames.y * points + i), 0).xyz;
  return mix(a, b, weight);
}

vec3 point(int i) {
  vec3 x = interpolated(i);
  vec3 b = texelFetch(centres, texel(frames.y * points + i), 0).xyz;
  vec4 r = texelFetch(referenceCentres, texel(i), 0);
  vec3 scaled = r.xyz + scale * (x - r.xyz) + imaginary * (b - r.xyz);
  return mix(x, scaled, r.w);      // w = 0: the point has no reference and is not scaled
}

float pixelSize(vec3 world) {
  return pixel * max(1e-20, -(viewMatrix * vec4(world, 1.0)).z);
}

// Two unit vectors perpendicular to n.
void perpendicular(vec3 n, out vec3 u, out vec3 v) {
  vec3 other = abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  u = normalize(cross(n, other));
  v = cross(n, u);
}
`;
