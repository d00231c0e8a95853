// The picture: renderer, camera and what stands in the scene; drawn on demand.

import * as THREE from "three";
import type { Settings } from "../base/settings";
import type { Instant } from "../scene/blend";
import type { Scene } from "../scene/scene";
import { Bodies } from "./bodies";
import { Camera } from "./camera";
import { grid, Obstacles } from "./obstacles";
import { Points } from "./points";
import { links, markers, reactions } from "./symbols";
import { Shared } from "./uniforms";

/** Everything that is made anew when the scene changes. */
interface Contents {
  scene: Scene;
  points: Points;
  shared: Shared;
  bodies: Bodies;
  obstacles: Obstacles;
  grid: THREE.Object3D;
  markers: THREE.Object3D;
  reactions: THREE.Object3D;
}

export class Stage {
  readonly camera: Camera;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private contents: Contents | null = null;
  private readonly spot = new THREE.Vector3();
  width = 1;
  height = 1;

  /** Throws if the browser has no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    scene: Scene,
    private readonly wanted: () => void,
  ) {
    const context = canvas.getContext("webgl2", {
      antialias: true,
      alpha: true,
      powerPreference: "high-performance",
    });
    if (!context) throw new Error("no WebGL 2");
    this.renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true });
    this.renderer.setClearAlpha(0);
    this.camera = new Camera(canvas, scene, wanted);
    canvas.addEventListener("webglcontextrestored", wanted);
  }

  /** Puts another scene on the stage; the camera stays where it is. Gives the points' reference positions. */
  load(scene: Scene): Float32Array {
    this.clear();
    const points = new Points(scene);
    const shared = new Shared(points);
    const bodies = new Bodies(scene, points, shared);
    const contents: Contents = {
      ...{ scene, points, shared, bodies },
      obstacles: new Obstacles(scene),
      grid: grid(scene),
      markers: markers(scene, points, shared),
      reactions: reactions(scene, points, shared),
    };
    this.contents = contents;
    this.world.add(contents.grid, bodies.ghost, bodies.group, contents.obstacles.group);
    if (scene.links.length > 0) this.world.add(links(scene, points, shared));
    if (scene.reactions.length > 0) this.world.add(contents.reactions);
    if (scene.markers.length > 0) this.world.add(contents.markers);
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position
      .set(...scene.up)
      .multiplyScalar(3)
      .add(new THREE.Vector3(1, 0.5, 2));
    this.world.add(new THREE.AmbientLight(0xffffff, 1.7), sun);
    this.camera.extent = scene;
    this.camera.depth();
    this.resize(this.width, this.height);
    return points.reference;
  }

  private clear(): void {
    this.world.traverse((object) => {
      if (object instanceof THREE.Mesh || object instanceof THREE.LineSegments) {
        object.geometry.dispose();
        object.material.dispose();
      }
    });
    this.world.clear();
    this.contents?.bodies.dispose();
    this.contents?.points.dispose();
  }

  apply(settings: Settings): void {
    if (!this.contents) return;
    const { scene, bodies, grid, markers, reactions } = this.contents;
    const field = scene.fields.findIndex((f) => f.name === settings.field);
    bodies.colourBy(field < 0 ? null : field);
    bodies.thickness = settings.thickness;
    bodies.ghost.visible = settings.ghost;
    grid.visible = settings.grid;
    markers.visible = settings.markers;
    reactions.visible = settings.reactions;
    this.wanted();
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    // On a phone the buttons go all across the upper edge.
    this.camera.resize(width, height, width < 560 ? 60 : 0);
    this.contents?.shared.look(width, height, this.camera.camera.fov);
    this.wanted();
  }

  draw(now: Instant): void {
    if (!this.contents || this.contents.scene.frames.count === 0) return;
    this.contents.shared.instant = now;
    this.contents.obstacles.instant = now;
    this.camera.depth();
    this.renderer.render(this.world, this.camera.camera);
  }

  /** Where a point stands on the canvas (pixels, depth from -1 to 1); null: behind the camera. */
  project(point: ArrayLike<number>): [number, number] | null {
    const v = this.spot.set(point[0], point[1], point[2]).project(this.camera.camera);
    if (!(v.z > -1 && v.z < 1)) return null;
    return [0.5 * (1 + v.x) * this.width, 0.5 * (1 - v.y) * this.height];
  }

  /** Pixels of length one at a point. */
  magnification(point: ArrayLike<number>): number {
    const { camera } = this.camera;
    const depth = -this.spot.set(point[0], point[1], point[2]).applyMatrix4(camera.matrixWorldInverse).z;
    return this.height / (2 * Math.tan((camera.fov * Math.PI) / 360) * Math.max(1e-20, depth));
  }

  /** Share of the canvas that something other than the grid covers. */
  pixels(now: Instant): number {
    if (!this.contents) return 0;
    const { visible } = this.contents.grid;
    this.contents.grid.visible = false;
    this.draw(now);
    this.contents.grid.visible = visible;
    const gl = this.renderer.getContext();
    const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let covered = 0;
    for (let i = 3; i < bytes.length; i += 4) if (bytes[i] > 0) covered += 1;
    this.wanted();
    return (4 * covered) / Math.max(1, bytes.length);
  }
}
