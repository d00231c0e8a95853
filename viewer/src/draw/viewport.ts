// Viewport: renderer, camera and contents of the 3-D view. It is drawn on request only.

import * as THREE from "three";
import type { Settings } from "../base/settings";
import { isDark } from "../base/theme";
import type { FrameBlend } from "../scene/blend";
import { colourScale } from "../scene/fields";
import type { Scene } from "../scene/scene";
import { Camera, type Rectangle } from "../view/camera";
import { type Extent, extentOf, type Spheres } from "../view/extent";
import { BodyMeshes, SHADOW } from "./bodies";
import { groundGrid, groundLevel } from "./ground";
import { ObstacleMeshes } from "./obstacles";
import { PointTextures } from "./points";
import { linkMesh, loadMesh, markerMesh, reactionMesh, supportMesh } from "./symbols";
import { SharedUniforms } from "./uniforms";

/** Objects that are created again when the scene changes. */
interface Contents {
  scene: Scene;
  points: PointTextures;
  shared: SharedUniforms;
  bodies: BodyMeshes;
  obstacles: ObstacleMeshes;
  grid: THREE.Object3D;
  markers: THREE.Object3D;
  /** Supported edges and loads of shells. */
  supports: THREE.Object3D;
  reactions: THREE.Object3D;
}

/** Height at which shadows have faded to a third, relative to the size of the model. */
const FADING = 0.15;
/** Number of stations above which bodies have no shadows. */
const MAX_SHADOW_STATIONS = 50_000;

export class Viewport {
  readonly camera: Camera;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private contents: Contents | null = null;
  private readonly scratch = new THREE.Vector3();
  /** Points that the camera frames, computed when it is fitted. */
  private extent: Extent | null = null;
  private deformation = 1;
  private ghost = false;
  /** Size of the canvas in CSS pixels. */
  width = 1;
  height = 1;

  /** Throws if the browser has no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private scene: Scene,
    private readonly requestDraw: () => void,
  ) {
    const context = canvas.getContext("webgl2", {
      antialias: true,
      alpha: true,
      stencil: true,
      powerPreference: "high-performance",
    });
    if (!context) throw new Error("no WebGL 2");
    this.renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true });
    this.renderer.setClearAlpha(0);
    this.camera = new Camera(canvas, scene.up, () => this.framed(), requestDraw);
    canvas.addEventListener("webglcontextrestored", requestDraw);
  }

  /** Loads a scene without a change of the camera. Returns the reference positions of the points. */
  load(scene: Scene): Float32Array {
    this.clear();
    [this.scene, this.extent] = [scene, null];
    const points = new PointTextures(scene);
    const shared = new SharedUniforms(points);
    const extent = this.framed();
    const level = groundLevel(scene, extent);
    const ground = { up: scene.up, level, fading: FADING * scene.size };
    const bodies = new BodyMeshes(scene, points, shared, ground);
    const shadow = new THREE.MeshBasicMaterial({ color: 0, opacity: 0.25, ...SHADOW });
    const contents: Contents = {
      ...{ scene, points, shared, bodies },
      obstacles: new ObstacleMeshes(scene, extent, level, shadow),
      grid: groundGrid(scene, extent),
      markers: markerMesh(scene, points, shared),
      supports: new THREE.Group(),
      reactions: reactionMesh(scene, points, shared, extent.arrow),
    };
    this.contents = contents;
    this.world.add(contents.grid, bodies.ghost, bodies.group, contents.obstacles.group);
    this.world.add(bodies.shadows, contents.obstacles.shadows);
    if (scene.links.length > 0) this.world.add(linkMesh(scene, points, shared));
    if (scene.reactions.length > 0) this.world.add(contents.reactions);
    if (scene.markers.length > 0) this.world.add(contents.markers);
    if (scene.supports.length > 0) contents.supports.add(supportMesh(scene, shared));
    if (scene.loads.length > 0) contents.supports.add(loadMesh(scene, points, shared, extent.arrow));
    this.world.add(contents.supports);
    this.addLights(scene);
    this.camera.updateDepth();
    this.resize(this.width, this.height);
    return points.reference;
  }

  /** Lights of the obstacles; the shaders of all other objects have their own. */
  private addLights(scene: Scene): void {
    const light = new THREE.DirectionalLight(0xffffff, 1.6);
    light.position
      .set(...scene.up)
      .multiplyScalar(3)
      .add(new THREE.Vector3(1, 0.5, 2));
    this.world.add(new THREE.AmbientLight(0xffffff, 1.7), light);
  }

  private clear(): void {
    this.world.traverse((object) => {
      if (object instanceof THREE.Mesh || object instanceof THREE.LineSegments) {
        object.geometry.dispose();
        for (const material of [object.material].flat()) material.dispose();
      }
    });
    this.world.clear();
    this.contents?.bodies.dispose();
    this.contents?.points.dispose();
  }

  /** Points of the scene with the displayed deformation. */
  framed(): Extent {
    this.extent ??= extentOf(this.scene, this.deformation, this.ghost);
    return this.extent;
  }

  /** Applies the display options. */
  apply(settings: Settings): void {
    if (!this.contents) return;
    const { scene, bodies, obstacles, grid, markers, supports, reactions } = this.contents;
    if (this.deformation !== settings.deformation || this.ghost !== settings.ghost) this.extent = null;
    [this.deformation, this.ghost] = [settings.deformation, settings.ghost];
    const field = scene.fields.findIndex((f) => f.name === settings.field);
    bodies.colourBy(field, field < 0 ? null : colourScale(scene.fields[field], settings));
    bodies.thickness = settings.thickness;
    bodies.mesh = settings.mesh;
    bodies.ghost.visible = settings.ghost;
    grid.visible = settings.grid;
    const shadows = settings.shadows && scene.stations <= MAX_SHADOW_STATIONS;
    for (const group of [bodies.shadows, obstacles.shadows]) group.visible = shadows;
    markers.visible = settings.markers;
    supports.visible = settings.markers;
    reactions.visible = settings.reactions;
    this.requestDraw();
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    this.contents?.shared.setView(width, height, this.camera.camera.fov);
    this.requestDraw();
  }

  draw(blend: FrameBlend): void {
    if (!this.contents || this.contents.scene.frames.count === 0) return;
    this.contents.shared.blend = blend;
    this.contents.shared.dark = isDark();
    this.contents.obstacles.blend = blend;
    this.camera.updateDepth();
    this.renderer.render(this.world, this.camera.camera);
  }

  /** Position of a point on the canvas in CSS pixels; null if it is not between the near and far planes. */
  project(point: ArrayLike<number>): [number, number] | null {
    const v = this.scratch.set(point[0], point[1], point[2]).project(this.camera.camera);
    if (!(v.z > -1 && v.z < 1)) return null;
    return [0.5 * (1 + v.x) * this.width, 0.5 * (1 - v.y) * this.height];
  }

  /** Pixels per unit of length at a point. */
  pixelsPerUnit(point: ArrayLike<number>): number {
    const { camera } = this.camera;
    const depth = -this.scratch.set(point[0], point[1], point[2]).applyMatrix4(camera.matrixWorldInverse).z;
    return this.height / (2 * Math.tan((camera.fov * Math.PI) / 360) * Math.max(1e-20, depth));
  }

  /** Free area of the last fit, and the boxes around the projected motion and arrows of all frames. */
  framing(): { free: Rectangle; motion: Rectangle; arrows: Rectangle | null } {
    const { motion, arrows } = this.framed();
    return {
      free: this.camera.free,
      motion: this.projectedBox(motion),
      arrows: arrows.length > 0 ? this.projectedBox(arrows) : null,
    };
  }

  private projectedBox(points: Spheres): Rectangle {
    const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
    for (let i = 0; i < points.length; i += 4) {
      const point = points.subarray(i, i + 3);
      const [x, y] = this.project(point) ?? [Number.NaN, Number.NaN];
      const radius = points[i + 3] * this.pixelsPerUnit(point);
      box.left = Math.min(box.left, x - radius);
      box.right = Math.max(box.right, x + radius);
      box.top = Math.min(box.top, y - radius);
      box.bottom = Math.max(box.bottom, y + radius);
    }
    return box;
  }

  /** Red, green, blue and opacity (0 to 255) of the 3-D view at points in CSS pixels. */
  pixels(points: ReadonlyArray<readonly [number, number]>, blend: FrameBlend): number[][] {
    this.draw(blend);
    const gl = this.renderer.getContext();
    const factor = gl.drawingBufferHeight / Math.max(1, this.height);
    const colours = points.map(([x, y]) => {
      const bytes = new Uint8Array(4);
      const [column, row] = [Math.floor(x * factor), Math.floor((this.height - y) * factor)];
      gl.readPixels(column, row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return [...bytes];
    });
    this.requestDraw();
    return colours;
  }

  /** Share of the canvas (0 to 1) that objects other than grid and shadows cover. */
  coverage(blend: FrameBlend): number {
    if (!this.contents) return 0;
    const { visible } = this.contents.grid;
    const { shadows } = this.contents.bodies;
    const shadowed = shadows.visible;
    [this.contents.grid.visible, shadows.visible] = [false, false];
    this.draw(blend);
    [this.contents.grid.visible, shadows.visible] = [visible, shadowed];
    const gl = this.renderer.getContext();
    const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let covered = 0;
    for (let i = 3; i < bytes.length; i += 4) if (bytes[i] > 0) covered += 1;
    this.requestDraw();
    return (4 * covered) / Math.max(1, bytes.length);
  }
}
