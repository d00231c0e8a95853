// Coordinate triad in a corner of the view.

import * as THREE from "three";

const AXES: [string, THREE.Vector3][] = [
  ["x", new THREE.Vector3(1, 0, 0)],
  ["y", new THREE.Vector3(0, 1, 0)],
  ["z", new THREE.Vector3(0, 0, 1)],
];
const SVG = "http://www.w3.org/2000/svg";

function svgElement(name: string, attributes: Record<string, string>): SVGElement {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

export class Triad {
  readonly element = svgElement("svg", {
    class: "triad",
    viewBox: "-40 -40 80 80",
    role: "img",
    "aria-label": "axes",
  });
  private readonly parts = AXES.map(([name]) => {
    const group = svgElement("g", { class: `axis-${name}` });
    const line = svgElement("line", { x1: "0", y1: "0" });
    const text = svgElement("text", { "text-anchor": "middle", "dominant-baseline": "central" });
    text.textContent = name;
    group.append(line, text);
    return { group, line, text };
  });

  /** Draws the axes as seen by the camera, the nearest on top. */
  draw(camera: THREE.Camera): void {
    const ends = AXES.map(([, axis], i) => ({
      direction: axis.clone().transformDirection(camera.matrixWorldInverse),
      part: this.parts[i],
    }));
    ends.sort((a, b) => a.direction.z - b.direction.z);
    for (const { direction, part } of ends) {
      part.line.setAttribute("x2", (26 * direction.x).toFixed(1));
      part.line.setAttribute("y2", (-26 * direction.y).toFixed(1));
      part.text.setAttribute("x", (34 * direction.x).toFixed(1));
      part.text.setAttribute("y", (-34 * direction.y).toFixed(1));
    }
    this.element.replaceChildren(...ends.map((e) => e.part.group));
  }
}
