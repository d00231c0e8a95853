// Consistency of a scene: lengths of arrays and indices. The drawing code relies on them.

import { type Numbers, type Scene, SceneError, storedFrames } from "./scene";

/** Error of damaged data; `detail` states what was found. */
export function damaged(detail: string): SceneError {
  return new SceneError(`The data of this page are damaged: ${detail}. Create the page again.`);
}

function checkLength(found: Numbers, expected: number, name: string): void {
  if (ArrayBuffer.isView(found) && found.length === expected) return;
  const count = ArrayBuffer.isView(found) ? found.length : "no";
  throw damaged(`${name} has ${count} numbers, expected ${expected}`);
}

/** Checks the length of every array that is indexed by frame or station, and the indices. */
export function checkArrays(scene: Scene): void {
  const frames = storedFrames(scene);
  const { stations } = scene;
  checkLength(scene.frames.values, scene.frames.count, "frames");
  if (!(scene.frames.imaginary ?? []).every((index) => index === null || (index >= 0 && index < frames))) {
    throw damaged("the imaginary part of a shape is missing");
  }
  checkLength(scene.centres, 3 * frames * stations, "centres");
  checkLength(scene.directors, 9 * frames * stations, "directors");
  checkLength(scene.reference.centres, 3 * stations, "centres of the reference configuration");
  checkLength(scene.reference.directors, 9 * stations, "directors of the reference configuration");
  for (const field of scene.fields) checkLength(field.values, frames * stations, field.name);
  for (const marker of scene.markers) checkLength(marker.at, 3 * frames, marker.name);
  for (const link of scene.links) checkLength(link.ends, 6 * frames, link.name);
  for (const reaction of scene.reactions) {
    checkLength(reaction.force, 3 * frames, `force of ${reaction.name}`);
    checkLength(reaction.moment, 3 * frames, `moment of ${reaction.name}`);
    if (!scene.markers[reaction.marker]) throw damaged(`the reaction ${reaction.name} has no marker`);
  }
  for (const load of scene.loads) checkLength(load.vectors, 3 * frames * load.stations.length, load.kind);
  for (const { stations: own } of [...scene.loads, ...scene.supports]) {
    if (!own.every((k) => k >= 0 && k < stations))
      throw damaged("the stations of a load or a support are missing");
  }
  for (const body of scene.bodies) {
    if (!(body.first >= 0 && body.first + body.count <= stations)) {
      throw damaged(`the stations of the body ${body.name} are missing`);
    }
    if (body.grid && body.grid.patches * body.grid.counts[0] * body.grid.counts[1] !== body.count) {
      throw damaged(`the grid of the body ${body.name} lacks stations`);
    }
    if (body.scale) checkLength(body.scale, 2 * body.count, `scale of ${body.name}`);
    if (body.bore) checkLength(body.bore, body.count, `bore of ${body.name}`);
    if (body.surface) {
      const { points, normals, corners } = body.surface;
      checkLength(normals, points.length, `surface of ${body.name}`);
      if (!corners.every((corner) => 3 * corner < points.length)) {
        throw damaged(`the surface of ${body.name} lacks points`);
      }
    }
  }
}
