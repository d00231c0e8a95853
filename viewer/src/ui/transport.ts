// The bar under the picture: play, step, scrub, speed.

import { h, icon, iconButton, quantity } from "../base/dom";
import { ICONS } from "../base/icons";
import { isModal, type Scene } from "../scene/scene";
import { type Player, SPEEDS } from "./player";

export class Transport {
  readonly element: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly readout = h("output", { class: "time", "aria-live": "off" });
  private readonly speed: HTMLSelectElement;
  private scene: Scene | null = null;

  constructor(private readonly player: Player) {
    this.play = iconButton("Play (space)", ICONS.play, () => player.toggle());
    this.play.classList.add("primary");
    this.slider = h("input", { type: "range", class: "scrub", min: 0, step: "any", "aria-label": "time" });
    this.slider.addEventListener("input", () => {
      player.playing = false;
      player.go(Number(this.slider.value));
    });
    this.speed = h("select", { "aria-label": "speed", title: "speed (+ and −)" });
    this.speed.append(...SPEEDS.map((s) => h("option", { value: s }, `${s}×`)));
    this.speed.addEventListener("change", () => {
      player.choose(Number(this.speed.value));
    });
    this.element = h(
      "div",
      { class: "transport", role: "group", "aria-label": "player" },
      this.play,
      iconButton("One frame back (←)", ICONS.back, () => player.step(-1)),
      iconButton("One frame on (→)", ICONS.next, () => player.step(1)),
      this.slider,
      this.readout,
      this.speed,
    );
  }

  load(scene: Scene): void {
    this.scene = scene;
    this.slider.max = String(this.player.end);
    this.slider.step = isModal(scene) ? "1" : "any";
    this.slider.setAttribute("aria-label", isModal(scene) ? "shape" : scene.abscissa.name || "time");
    this.slider.disabled = this.player.end === 0;
    this.play.disabled = this.player.end === 0 && !isModal(scene);
  }

  show(): void {
    const { player } = this;
    const name = player.playing ? "Pause (space)" : "Play (space)";
    if (this.play.title !== name) {
      this.play.innerHTML = icon(player.playing ? ICONS.pause : ICONS.play);
      this.play.title = name;
      this.play.setAttribute("aria-label", name);
    }
    this.slider.value = String(player.position);
    this.slider.style.setProperty("--share", `${player.end > 0 ? (100 * player.position) / player.end : 0}%`);
    const text = this.caption();
    this.slider.setAttribute("aria-valuetext", text);
    if (this.readout.textContent !== text) this.readout.textContent = text;
    this.speed.value = String(player.speed);
  }

  /** The time, the load factor or the name of the shape. */
  caption(): string {
    const { scene, player } = this;
    if (!scene || scene.frames.count === 0) return "no frames";
    const label = scene.frames.labels?.[Math.round(player.position)];
    if (label) return label;
    const { name, unit } = scene.abscissa;
    const what = name || (scene.analysis === "dynamics" ? "t" : "load factor");
    return `${what} = ${quantity(player.time, unit)}`;
  }
}
