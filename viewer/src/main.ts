// Entry: builds the viewer into the page that holds the scene.

import "uplot/dist/uPlot.min.css";
import "./styles/page.css";
import "./styles/stage.css";
import "./styles/overlay.css";
import "./styles/panel.css";
import "./styles/phone.css";
import { iconButton, save } from "./base/dom";
import { ICONS } from "./base/icons";
import { Theme } from "./base/theme";
import { VIEWS } from "./draw/camera";
import { SceneError } from "./scene/scene";
import { follow } from "./scene/source";
import { api } from "./ui/api";
import { App } from "./ui/app";
import { compose, Film, filmable } from "./ui/export";
import { help, type Key, listen } from "./ui/keyboard";

function keys(app: App, theme: Theme, ask: () => void): Key[] {
  const { player, choice } = app;
  const step = (way: number) => (e: KeyboardEvent) => player.step(way * (e.shiftKey ? 10 : 1));
  const camera = () => app.stage?.camera;
  return [
    [[" "], "play, pause", () => player.toggle()],
    [["ArrowLeft"], "one frame back (with shift: ten)", step(-1)],
    [["ArrowRight"], "one frame on (with shift: ten)", step(1)],
    [["Home"], "to the start", () => player.go(0)],
    [["End"], "to the end", () => player.go(player.end)],
    [["+", "="], "faster", () => player.faster(1)],
    [["-", "−"], "slower", () => player.faster(-1)],
    ...VIEWS.map((view, i): Key => [[String(i + 1)], `${view} view`, () => camera()?.view(view)]),
    [[","], "turn left", () => camera()?.move(Math.PI / 18, 1)],
    [["."], "turn right", () => camera()?.move(-Math.PI / 18, 1)],
    [["z"], "closer", () => camera()?.move(0, 0.85)],
    [["x"], "farther", () => camera()?.move(0, 1 / 0.85)],
    [["f"], "everything into the picture", () => camera()?.fit()],
    [["c"], "colour by the next field", () => app.nextField()],
    [["g"], "ghost of the reference shape", () => choice.toggle("ghost")],
    [["l"], "names", () => choice.toggle("labels")],
    [["n"], "node numbers", () => choice.toggle("nodes")],
    [["r"], "reactions", () => choice.toggle("reactions")],
    [["m"], "joints and probes", () => choice.toggle("markers")],
    [["o"], "repeat the film", () => choice.toggle("repeat")],
    [["d"], "what to see", () => app.layout.unfold()],
    [["t"], "dark or light", () => theme.toggle()],
    [["?"], "this list", ask],
  ];
}

function name(app: App): string {
  return app.scene.title.replace(/[^\w-]+/g, "_") || "ancf";
}

function savePicture(app: App): void {
  if (!app.stage) return;
  app.stage.draw(app.instant);
  const page = compose(app.layout.canvas, app.scene, app.caption, app.choice.values.field);
  page.toBlob((blob) => blob && save(`${name(app)}.png`, blob));
}

/** Plays from the start to the end (a mode: two swings) and saves what was seen. */
function saveFilm(app: App, button: HTMLButtonElement): void {
  const { player } = app;
  const film = new Film(app.layout.canvas);
  const { repeat } = player;
  player.repeat = false;
  button.setAttribute("aria-pressed", "true");
  button.disabled = true;
  player.playing = false;
  if (player.end > 0 && player.timed) player.go(0);
  player.toggle();
  const began = performance.now();
  const timer = setInterval(async () => {
    const long = performance.now() - began;
    const swung = !player.timed && long > 4000 / player.speed;
    if (player.playing && !swung && long < 120_000) return;
    clearInterval(timer);
    if (player.playing) player.toggle();
    player.repeat = repeat;
    const blob = await film.stop();
    save(`${name(app)}.${blob.type.includes("mp4") ? "mp4" : "webm"}`, blob);
    button.disabled = false;
    button.setAttribute("aria-pressed", "false");
  }, 100);
}

function buttons(app: App, theme: Theme, ask: () => void): void {
  const { tools, actions } = app.layout;
  for (const [i, view] of VIEWS.entries()) {
    const button = iconButton(`${view} view (${i + 1})`, "", () => app.stage?.camera.view(view));
    button.textContent = { front: "Front", top: "Top", side: "Side", oblique: "3-D" }[view];
    button.className = "word";
    tools.append(button);
  }
  tools.append(iconButton("Fit (f)", ICONS.fit, () => app.stage?.camera.fit()));
  actions.append(iconButton("Save picture", ICONS.picture, () => savePicture(app)));
  if (filmable()) {
    const film = iconButton("Save film", ICONS.film, () => saveFilm(app, film));
    actions.append(film);
  }
  actions.append(
    iconButton("Dark or light (t)", ICONS.theme, () => theme.toggle()),
    iconButton("Keys (?)", ICONS.help, ask),
  );
}

function start(): void {
  const app = new App();
  const theme = new Theme(() => app.repaint());
  const ask = () => dialog.showModal();
  const list = keys(app, theme, ask);
  const dialog = help(list);
  document.body.append(dialog);
  buttons(app, theme, ask);
  listen(list);
  const listener = {
    scene: (scene: Parameters<App["show"]>[0]) => app.show(scene),
    trouble: (sentence: string | null) => app.layout.trouble(sentence),
  };
  const ready = follow(document, listener).then(
    () => true,
    (error: unknown) => {
      const known = error instanceof SceneError;
      app.fail(known ? error.message : `The data of this page are damaged (${String(error)}).`);
      return false;
    },
  );
  Object.assign(window, { ancf: api(app, ready) });
}

start();
