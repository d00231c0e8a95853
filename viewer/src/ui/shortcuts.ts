// List of the keyboard shortcuts.

import type { Theme } from "../base/theme";
import { STANDARD_VIEWS } from "../view/camera";
import type { App } from "./app";
import type { Shortcut } from "./keyboard";

/** Rotation per key press in radians. */
const ROTATION = Math.PI / 18;
/** Factor of the camera distance per key press. */
const ZOOM = 0.85;

export function shortcuts(app: App, theme: Theme, showHelp: () => void): Shortcut[] {
  const { player, settings } = app;
  const step = (direction: number) => (e: KeyboardEvent) => player.step(direction * (e.shiftKey ? 10 : 1));
  const camera = () => app.viewport?.camera;
  return [
    [[" "], "play, pause", () => player.toggle()],
    [["ArrowLeft"], "previous frame (with shift: ten)", step(-1)],
    [["ArrowRight"], "next frame (with shift: ten)", step(1)],
    [["Home"], "first frame", () => player.goTo(0)],
    [["End"], "last frame", () => player.goTo(player.end)],
    [["+", "="], "faster", () => player.changeSpeed(1)],
    [["-", "−"], "slower", () => player.changeSpeed(-1)],
    ...STANDARD_VIEWS.map(
      (view, i): Shortcut => [[String(i + 1)], `${view} view`, () => camera()?.setView(view)],
    ),
    [[","], "rotate left", () => camera()?.orbit(ROTATION, 1)],
    [["."], "rotate right", () => camera()?.orbit(-ROTATION, 1)],
    [["z"], "zoom in", () => camera()?.orbit(0, ZOOM)],
    [["x"], "zoom out", () => camera()?.orbit(0, 1 / ZOOM)],
    [["f"], "fit the model into the view", () => camera()?.fit()],
    [["c"], "colour by the next field", () => app.selectNextField()],
    [["g"], "reference configuration", () => settings.toggle("ghost")],
    [["l"], "names", () => settings.toggle("labels")],
    [["n"], "node numbers", () => settings.toggle("nodes")],
    [["e"], "edges of shell elements", () => settings.toggle("mesh")],
    [["r"], "reactions", () => settings.toggle("reactions")],
    [["m"], "joints, probes, loads", () => settings.toggle("markers")],
    [["o"], "repeat", () => settings.toggle("repeat")],
    [["d"], "display options", () => app.layout.toggleDisplayOptions()],
    [["t"], "dark or light theme", () => theme.toggle()],
    [["?"], "this list", showHelp],
  ];
}
