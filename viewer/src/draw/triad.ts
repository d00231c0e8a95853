// The axes x y z in a corner of the picture.

import * as THREE from "three";

const AXES: [string, THREE.Vector3][] = [
  ["x", new THREE.Vector3(1, 0, 0)],
  ["y", new THREE.Vector3(0, 1, 0)],
  ["z", new THREE.Vector3(0, 0, 1)],
];
const SVG = "http://www.w3.org/2000/svg";

function svg(name: string, attributes: Record<string, string>): SVGElement {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

export class Triad {
  readonly element = svg("svg", {
    class: "triad",
    viewBox: "-40 -40 80 80",
    role: "img",
    "aria-label": "axes",
  });
  private readonly parts = AXES.map(([name]) => {
    const group = svg("g", { class: `axis-${name}` });
    const line = svg("line", { x1: "0", y1: "0" });
    const text = svg("text", { "text-anchor": "middle", "dominant-baseline": "central" });
    text.textContent = name;
    group.append(line, text);
    return { group, line, text };
  });

  draw(camera: THREE.Camera): void {
    const ends = AXES.map(([, axis], i) => ({
      at: axis.clone().transformDirection(camera.matrixWorldInverse),
      part: this.parts[i],
    }));
    ends.sort((a, b) => a.at.z - b.at.z);
    for (const { at, part } of ends) {
      part.line.setAttribute("x2", (26 * at.x).toFixed(1));
      part.line.setAttribute("y2", (-26 * at.y).toFixed(1));
      part.text.setAttribute("x", (34 * at.x).toFixed(1));
      part.text.setAttribute("y", (-34 * at.y).toFixed(1));
    }
    this.element.replaceChildren(...ends.map((e) => e.part.group));
  }
}
