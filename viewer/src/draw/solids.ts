// Spheres and cylinders of obstacles, with edges, and with marks that show their rotation.

import * as THREE from "three";

/** Colours of the wall, of the end faces and spheres, of spokes, of the spoke that marks the angle, of edges. */
const WALL = 0x717c87;
const FACE = 0xc3cad1;
const SPOKE = 0x8b959f;
const MARK = 0xd08700;
const EDGE = 0x3c444c;
/** Number of sides of a circle. */
const SIDES = 64;
const SPOKES = 6;
/** Radii of hub and rim, and half of the width of a spoke, relative to the radius. */
const HUB = 0.16;
const RIM = 0.88;
const HALF_WIDTH = 0.035;
/** Distance of spokes from the end face, relative to the radius. */
const OFFSET = 0.004;

function surface(colour: number, inside: boolean): THREE.MeshLambertMaterial {
  const transparency = inside ? { transparent: true, opacity: 0.25, depthWrite: false } : {};
  return new THREE.MeshLambertMaterial({ color: colour, side: THREE.DoubleSide, ...transparency });
}

function lines(points: number[]): THREE.LineSegments {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: EDGE }));
}

/** Segments of a circle about the x-axis. */
function circle(x: number, radius: number): number[] {
  return Array.from({ length: SIDES }, (_, i) => i).flatMap((i) =>
    [i, i + 1].flatMap((k) => {
      const angle = (2 * Math.PI * k) / SIDES;
      return [x, radius * Math.cos(angle), radius * Math.sin(angle)];
    }),
  );
}

/** Sphere; a moving one has two great circles. */
export function sphere(radius: number, moves: boolean, inside: boolean): THREE.Group {
  const ball = new THREE.Mesh(new THREE.SphereGeometry(radius, 48, 24), surface(FACE, inside));
  const group = new THREE.Group().add(ball);
  if (!moves) return group;
  const first = circle(0, 1.002 * radius);
  const second = Array.from({ length: first.length / 3 }, (_, i) => first.slice(3 * i, 3 * i + 3)).flatMap(
    ([x, y, z]) => [y, x, z],
  );
  return group.add(lines([...first, ...second]));
}

/** Cylinder along x with edges; a moving one has spokes on its end faces. */
export function cylinder(radius: number, length: number, moves: boolean, inside: boolean): THREE.Group {
  const geometry = new THREE.CylinderGeometry(radius, radius, length, SIDES, 1, inside).rotateZ(-Math.PI / 2);
  const materials = [surface(WALL, inside), surface(FACE, inside), surface(FACE, inside)];
  const group = new THREE.Group().add(new THREE.Mesh(geometry, materials));
  const half = 0.5 * length;
  group.add(lines([...circle(half, radius), ...circle(-half, radius)]));
  if (!moves || inside) return group;
  for (const x of [half + OFFSET * radius, -half - OFFSET * radius]) {
    for (let i = 0; i < SPOKES; i++)
      group.add(spoke(radius, x, (2 * Math.PI * i) / SPOKES, i === 0 ? MARK : SPOKE));
    group.add(lines([...circle(x, RIM * radius), ...circle(x, HUB * radius)]));
  }
  return group;
}

/** Flat spoke on the plane at `x` in the direction of `angle`. */
function spoke(radius: number, x: number, angle: number, colour: number): THREE.Mesh {
  const length = (RIM - HUB) * radius;
  const geometry = new THREE.PlaneGeometry(length, 2 * HALF_WIDTH * radius)
    .translate(HUB * radius + 0.5 * length, 0, 0)
    .rotateZ(angle);
  // The plane of the geometry is xy; that of the end face is yz.
  geometry.applyMatrix4(new THREE.Matrix4().set(0, 0, 1, x, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1));
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: colour, side: THREE.DoubleSide }));
}
