// Application: connects the parts of the page, and updates them in `draw`.

import { h } from "../base/dom";
import { SettingsStore } from "../base/settings";
import { formatQuantity } from "../base/units";
import { Abscissa } from "../charts/abscissa";
import { Charts } from "../charts/charts";
import { gridSpacing } from "../draw/ground";
import { Triad } from "../draw/triad";
import { Viewport } from "../draw/viewport";
import { type Handle, type HandleListener, Handles } from "../overlay/handles";
import { Labels } from "../overlay/labels";
import { ColourLegend } from "../overlay/legend";
import { Tooltip } from "../overlay/tooltip";
import { SidePanel } from "../panel/panel";
import type { FrameBlend } from "../scene/blend";
import { defaultField, keepRanges } from "../scene/fields";
import { hasFailed, isModal, type Scene } from "../scene/scene";
import { frameLabels } from "../scene/shapes";
import type { Rectangle } from "../view/camera";
import { DisplayOptions } from "./display";
import { coveredAreas, freeAreas } from "./free_area";
import { PageLayout } from "./layout";
import { Player } from "./player";
import { TransportBar } from "./transport";

/** Number of stations above which there is no tooltip during playback. */
const MAX_PICKED_STATIONS = 20_000;

export class App {
  readonly settings = new SettingsStore();
  readonly player = new Player(() => this.requestDraw());
  readonly layout: PageLayout;
  viewport: Viewport | null = null;
  private currentScene: Scene | null = null;
  private readonly charts = new Charts((x) => this.goToAbscissa(x));
  private readonly panel = new SidePanel(
    this.charts,
    (frame) => this.selectShape(frame),
    () => this.requestDraw(),
  );
  private readonly transport = new TransportBar(this.player);
  private readonly display = new DisplayOptions(this.settings);
  private readonly legend = new ColourLegend();
  private readonly triad = new Triad();
  private readonly tooltip: Tooltip;
  /** Text with the spacing of the grid. */
  private readonly gridNote = h("div", { class: "grid-note" });
  private labels: Labels | null = null;
  private handles: Handles | null = null;
  private abscissa: Abscissa | null = null;
  /** Reference positions of the points of the viewport. */
  private reference: Float32Array = new Float32Array(0);
  private drawRequested = false;
  private coveredCache: Rectangle[] | null = null;

  constructor() {
    this.layout = new PageLayout(this.panel.element, this.transport.element, this.display.element);
    this.tooltip = new Tooltip(this.layout.canvas, () => this.requestDraw());
    this.layout.overlay.append(this.triad.element, this.gridNote, this.legend.element, this.tooltip.element);
    this.settings.listen((name) => {
      const { values } = this.settings;
      if (["field", "colourMap", "limits"].includes(name) && this.currentScene)
        this.legend.show(this.currentScene, values);
      this.viewport?.apply(values);
      this.player.repeat = values.repeat;
      this.gridNote.hidden = !values.grid;
    });
  }

  get scene(): Scene {
    if (!this.currentScene) throw new Error("the scene is not loaded");
    return this.currentScene;
  }

  get blend(): FrameBlend {
    return this.player.blend(this.settings.values.deformation);
  }

  get caption(): string {
    return this.transport.caption();
  }

  /** Loads a scene. Updates of a live run keep the time and the view. */
  load(scene: Scene): void {
    scene.frames.labels = frameLabels(scene);
    const update = this.currentScene !== null;
    if (!this.currentScene?.fields.length) this.settings.values.field = defaultField(scene);
    if (this.currentScene) keepRanges(scene, this.currentScene);
    this.currentScene = scene;
    this.player.load(scene, update);
    this.abscissa = new Abscissa(scene);
    this.layout.load(scene);
    this.panel.load(scene);
    this.charts.load(scene, this.abscissa);
    this.transport.load(scene);
    this.display.load(scene);
    this.legend.show(scene, this.settings.values);
    this.loadViewport(scene);
    this.requestDraw();
    const moves = scene.analysis !== "statics" && !scene.live && !hasFailed(scene);
    const autoplay = !update && moves && this.viewport !== null;
    if (autoplay && !prefersReducedMotion()) this.player.toggle();
  }

  private loadViewport(scene: Scene): void {
    if (scene.frames.count === 0 || (scene.stations === 0 && scene.obstacles.length === 0)) {
      this.layout.showPlaceholder("The run has nothing to draw.");
      return;
    }
    const update = this.viewport !== null;
    if (!update && !this.openViewport(scene)) return;
    this.layout.showPlaceholder("");
    this.gridNote.textContent = `grid ${formatQuantity(gridSpacing(scene), scene.units?.length ?? "")}`;
    this.reference = this.viewport?.load(scene) ?? this.reference;
    this.viewport?.apply(this.settings.values);
    if (update) this.viewport?.camera.keepFitted();
    else this.viewport?.camera.setInitialView();
  }

  /** Creates the viewport. Returns false if the browser has no WebGL 2. */
  private openViewport(scene: Scene): boolean {
    const { canvas } = this.layout;
    try {
      this.viewport = new Viewport(canvas, scene, () => this.requestDraw());
    } catch {
      this.layout.showPlaceholder(
        "The 3-D view requires WebGL 2, which this browser does not offer. Charts and summary are complete.",
      );
      return false;
    }
    const { viewport } = this;
    this.labels = new Labels(viewport, () => this.covered());
    this.handles = new Handles(viewport, () => this.requestDraw());
    this.layout.overlay.prepend(this.labels.element, this.handles.element);
    viewport.camera.freeAreas = () => freeAreas(viewport.width, viewport.height, this.covered());
    const resize = () => {
      this.coveredCache = null;
      viewport.resize(canvas.clientWidth, canvas.clientHeight);
    };
    resize();
    const observer = new ResizeObserver(resize);
    observer.observe(canvas);
    for (const element of [this.display.element, this.legend.element]) {
      new ResizeObserver(() => {
        this.coveredCache = null;
        this.requestDraw();
      }).observe(element);
    }
    return true;
  }

  /** Areas of the 3-D view under buttons and legends, until `coveredCache` is cleared. */
  private covered(): Rectangle[] {
    const { canvas, tools } = this.layout;
    const elements = [tools, this.display.element, this.legend.element, this.triad.element, this.gridNote];
    this.coveredCache ??= coveredAreas(canvas, elements);
    return this.coveredCache;
  }

  /** Requests a drawing in the next animation frame. Without requests nothing is drawn. */
  requestDraw(): void {
    if (this.drawRequested) return;
    this.drawRequested = true;
    requestAnimationFrame((now) => {
      this.drawRequested = false;
      this.player.tick(now / 1000);
      this.draw();
    });
  }

  private draw(): void {
    const { viewport, labels, reference, currentScene: scene, blend } = this;
    const settings = this.settings.values;
    this.transport.update();
    this.charts.show(this.abscissa?.at(this.player.position) ?? null);
    this.panel.show(Math.round(this.player.position), blend, this.caption);
    if (!viewport || !labels || !scene || scene.frames.count === 0) return;
    viewport.draw(blend);
    this.triad.draw(viewport.camera.camera);
    labels.draw({ scene, reference, settings, blend });
    this.handles?.draw();
    // Picking must not delay the frames of a large model during playback.
    if (this.player.playing && scene.stations > MAX_PICKED_STATIONS) this.tooltip.hide();
    else this.tooltip.update(viewport, scene, settings, blend);
  }

  /** Shows points of the model that the user drags, and the undeformed shape with them. */
  showHandles(handles: Handle[], moved: HandleListener): void {
    if (!this.handles || !this.currentScene) return;
    this.handles.show(handles, this.currentScene, moved);
    this.settings.set("ghost", handles.length > 0);
  }

  /** Moves to an abscissa of the charts. */
  private goToAbscissa(x: number): void {
    const frame = this.abscissa?.frame(x);
    if (frame === null || frame === undefined) return;
    if (!isModal(this.scene)) this.player.playing = false;
    this.player.goTo(frame);
  }

  private selectShape(frame: number): void {
    this.player.goTo(frame);
    if (!this.player.playing && !prefersReducedMotion()) this.player.toggle();
  }

  /** Adapts the charts to the colours of the theme. */
  applyTheme(): void {
    this.charts.rebuild();
    this.requestDraw();
  }

  /** Selects the next field of the list, after the last one none. */
  selectNextField(): void {
    const names = [...this.scene.fields.map((f) => f.name), ""];
    const next = (names.indexOf(this.settings.values.field) + 1) % names.length;
    this.settings.set("field", names[next]);
  }
}

function prefersReducedMotion(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
