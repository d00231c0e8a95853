// Transport bar below the 3-D view: play, step, time slider, speed.

import { h, iconButton, iconSvg } from "../base/dom";
import { ICONS } from "../base/icons";
import { formatQuantity } from "../base/units";
import { isModal, type Scene } from "../scene/scene";
import { type Player, SPEEDS } from "./player";

export class TransportBar {
  readonly element: HTMLElement;
  private readonly playButton: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly readout = h("output", { class: "time", "aria-live": "off" });
  private readonly speed: HTMLSelectElement;
  private scene: Scene | null = null;

  constructor(private readonly player: Player) {
    this.playButton = iconButton("Play (space)", ICONS.play, () => player.toggle());
    this.playButton.classList.add("primary");
    this.slider = h("input", {
      type: "range",
      class: "time-slider",
      min: 0,
      step: "any",
      "aria-label": "time",
    });
    this.slider.addEventListener("input", () => {
      player.playing = false;
      player.goTo(Number(this.slider.value));
    });
    this.speed = h("select", { "aria-label": "speed", title: "Speed (+ and −)" });
    this.speed.append(...SPEEDS.map((s) => h("option", { value: s }, `${s}×`)));
    this.speed.addEventListener("change", () => {
      player.selectSpeed(Number(this.speed.value));
    });
    this.element = h(
      "div",
      { class: "transport", role: "group", "aria-label": "playback" },
      this.playButton,
      iconButton("Previous frame (←)", ICONS.previous, () => player.step(-1)),
      iconButton("Next frame (→)", ICONS.next, () => player.step(1)),
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
    this.playButton.disabled = this.player.end === 0 && !isModal(scene);
  }

  /** Shows the state of the player. */
  update(): void {
    const { player } = this;
    const name = player.playing ? "Pause (space)" : "Play (space)";
    if (this.playButton.title !== name) {
      this.playButton.innerHTML = iconSvg(player.playing ? ICONS.pause : ICONS.play);
      this.playButton.title = name;
      this.playButton.setAttribute("aria-label", name);
    }
    this.slider.value = String(player.position);
    this.slider.style.setProperty("--share", `${player.end > 0 ? (100 * player.position) / player.end : 0}%`);
    const caption = this.caption();
    this.slider.setAttribute("aria-valuetext", caption);
    if (this.readout.textContent !== caption) this.readout.textContent = caption;
    this.speed.value = String(player.speed);
  }

  /** Time, load factor, or label of the shape. */
  caption(): string {
    const { scene, player } = this;
    if (!scene || scene.frames.count === 0) return "no frames";
    const label = scene.frames.labels?.[Math.round(player.position)];
    if (label) return label;
    const { name, unit } = scene.abscissa;
    const quantity = name || (scene.analysis === "dynamics" ? "t" : "load factor");
    return `${quantity} = ${formatQuantity(player.time, unit, scene.frames.values[player.end])}`;
  }
}
