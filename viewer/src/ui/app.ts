// The viewer: puts the parts on the page, and everything that changes through one door: `draw`.

import { h, quantity } from "../base/dom";
import { Choice } from "../base/settings";
import { Abscissa } from "../charts/abscissa";
import { Charts } from "../charts/charts";
import { mesh } from "../draw/obstacles";
import { Triad } from "../draw/triad";
import { Stage } from "../draw/viewport";
import { Labels } from "../overlay/labels";
import { Legend } from "../overlay/legend";
import { describe, pick, Tip } from "../overlay/picking";
import type { Instant } from "../scene/blend";
import { failed, isModal, type Scene } from "../scene/scene";
import { names } from "../scene/shapes";
import { Display } from "./display";
import { Layout } from "./layout";
import { Panel } from "./panel";
import { Player } from "./player";
import { Transport } from "./transport";

const MOST_HOVERED = 20_000;

export class App {
  readonly choice = new Choice();
  readonly player = new Player(() => this.wake());
  readonly layout: Layout;
  stage: Stage | null = null;
  private scene_: Scene | null = null;
  private readonly charts = new Charts((x) => this.pickTime(x));
  private readonly panel = new Panel(this.charts, (frame) => this.choose(frame));
  private readonly transport = new Transport(this.player);
  private readonly display = new Display(this.choice);
  private readonly legend = new Legend();
  private readonly triad = new Triad();
  private readonly tip = new Tip();
  /** How wide the squares of the grid are. */
  private readonly scale = h("div", { class: "mesh" });
  private labels: Labels | null = null;
  private abscissa: Abscissa | null = null;
  private reference: Float32Array = new Float32Array(0);
  private asleep = true;
  private pointer: [number, number] | null = null;

  constructor() {
    this.layout = new Layout(this.panel.element, this.transport.element, this.display.element);
    this.layout.overlay.append(this.triad.element, this.scale, this.legend.element, this.tip.element);
    this.choice.listen((name) => {
      if (name === "field" && this.scene_) this.legend.show(this.scene_, this.choice.values.field);
      this.stage?.apply(this.choice.values);
      this.player.repeat = this.choice.values.repeat;
      this.scale.hidden = !this.choice.values.grid;
    });
    this.hover();
  }

  get scene(): Scene {
    if (!this.scene_) throw new Error("no scene yet");
    return this.scene_;
  }

  get instant(): Instant {
    return this.player.instant(this.choice.values.deformation);
  }

  get caption(): string {
    return this.transport.caption();
  }

  /** Shows a scene: the first one from the beginning, later ones where the user is. */
  show(scene: Scene): void {
    scene.frames.labels = names(scene);
    const again = this.scene_ !== null;
    if (!this.scene_?.fields.length) this.choice.values.field = scene.fields[0]?.name ?? "";
    this.scene_ = scene;
    this.player.load(scene, again);
    this.abscissa = new Abscissa(scene);
    this.layout.load(scene);
    this.panel.load(scene);
    this.charts.load(scene, this.abscissa);
    this.transport.load(scene);
    this.display.load(scene);
    this.legend.show(scene, this.choice.values.field);
    this.setStage(scene);
    this.wake();
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!again && !calm && !scene.live && !failed(scene) && this.stage) this.player.toggle();
  }

  private setStage(scene: Scene): void {
    if (scene.frames.count === 0 || (scene.stations === 0 && scene.obstacles.length === 0)) {
      this.layout.say("There is nothing to draw.");
      return;
    }
    const again = this.stage !== null;
    if (!again && !this.open(scene)) return;
    this.layout.say("");
    this.scale.textContent = `grid ${quantity(mesh(scene), scene.units?.length ?? "")}`;
    this.reference = this.stage?.load(scene) ?? this.reference;
    this.stage?.apply(this.choice.values);
    if (!again) this.stage?.camera.view(flat(scene) ? "front" : "oblique");
  }

  private open(scene: Scene): boolean {
    const { canvas } = this.layout;
    try {
      this.stage = new Stage(canvas, scene, () => this.wake());
    } catch {
      this.layout.say(
        "There is no picture: this browser offers no WebGL 2. Charts and summary are complete.",
      );
      return false;
    }
    this.labels = new Labels(this.stage);
    this.layout.overlay.prepend(this.labels.element);
    const resize = () => this.stage?.resize(canvas.clientWidth, canvas.clientHeight);
    resize();
    new ResizeObserver(resize).observe(canvas);
    return true;
  }

  /** Asks for a picture; while nothing changes there is none. */
  wake(): void {
    if (!this.asleep) return;
    this.asleep = false;
    requestAnimationFrame((now) => {
      this.asleep = true;
      this.player.tick(now / 1000);
      this.draw();
    });
  }

  private draw(): void {
    const { stage, labels, scene_: scene, instant } = this;
    this.transport.show();
    this.charts.show(this.abscissa?.at(this.player.position) ?? null);
    this.panel.mark(Math.round(this.player.position));
    if (!stage || !labels || !scene || scene.frames.count === 0) return;
    stage.draw(instant);
    this.triad.draw(stage.camera.camera);
    labels.draw(scene, this.reference, this.choice.values, instant);
    this.showTip();
  }

  /** Goes to a place of the charts' axis. */
  private pickTime(x: number): void {
    const frame = this.abscissa?.frame(x);
    if (frame === null || frame === undefined) return;
    if (!isModal(this.scene)) this.player.playing = false;
    this.player.go(frame);
  }

  private choose(frame: number): void {
    this.player.go(frame);
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!this.player.playing && !calm) this.player.toggle();
  }

  private hover(): void {
    const { canvas } = this.layout;
    const set = (event: PointerEvent) => {
      const box = canvas.getBoundingClientRect();
      this.pointer = event.buttons > 0 ? null : [event.clientX - box.left, event.clientY - box.top];
      this.wake();
    };
    canvas.addEventListener("pointermove", set);
    canvas.addEventListener("pointerup", (event) => set(event));
    canvas.addEventListener("pointerleave", (event) => {
      if (event.pointerType === "touch") return;
      this.pointer = null;
      this.wake();
    });
  }

  private showTip(): void {
    const { stage, pointer, instant } = this;
    const { values } = this.choice;
    const [x, y] = pointer ?? [0, 0];
    // While a large model plays, its frames must not wait for what is under the pointer.
    const busy = this.player.playing && this.scene.stations > MOST_HOVERED;
    const hit = stage && pointer && !busy ? pick(stage, this.scene, values, instant, x, y) : null;
    this.tip.show(hit && describe(this.scene, values, instant, hit), x, y, stage?.width ?? 0);
  }

  /** Colours of the theme have changed. */
  repaint(): void {
    this.charts.rebuild();
    this.wake();
  }

  /** The next field of the list, then none. */
  nextField(): void {
    const names = [...this.scene.fields.map((f) => f.name), ""];
    this.choice.set("field", names[(names.indexOf(this.choice.values.field) + 1) % names.length]);
  }

  /** Something that went wrong for good, as a sentence. */
  fail(sentence: string): void {
    this.layout.element.classList.add("failed");
    this.layout.banner.replaceChildren(h("p", { class: "banner failed", role: "alert" }, sentence));
  }
}

/** All of it in one plane across the front view's direction. */
function flat(scene: Scene): boolean {
  const [low, high] = scene.bounds;
  const size = low.map((x, k) => high[k] - x);
  const thin = size.indexOf(Math.min(...size));
  const upward = scene.up.map(Math.abs).indexOf(1);
  return !isModal(scene) && size[thin] < 0.02 * Math.max(...size) && thin === (upward === 2 ? 1 : 2);
}
