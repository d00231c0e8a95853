// Playback, without a browser.

import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";
import { build } from "esbuild";

let Player;
before(async () => {
  const entry = join(import.meta.dirname, "../src/ui/player.ts");
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, format: "esm", write: false });
  const address = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  ({ Player } = await import(address));
});

const scene = (until, more = {}) => ({
  ...{ analysis: "dynamics", live: false, outcome: { kind: "finished", message: "" } },
  frames: { count: 11, values: Float64Array.from({ length: 11 }, (_, i) => (until * i) / 10), labels: null },
  ...more,
});
const live = (until) => scene(until, { live: true, outcome: { kind: "running", message: "" } });
const newPlayer = () => new Player(() => {});

test("the default speed follows the duration of a live run until the user selects one", () => {
  const player = newPlayer();
  player.load(live(0.1), false);
  assert.equal(player.speed, 0.01);
  player.load(live(80), true);
  assert.equal(player.speed, 10);
  player.selectSpeed(0.5);
  player.load(live(8000), true);
  assert.equal(player.speed, 0.5);
  player.changeSpeed(1);
  player.load(scene(80), true);
  assert.equal(player.speed, 1);
});

test("a run opens at its start, a failed run at its end", () => {
  const player = newPlayer();
  player.load(scene(2), false);
  assert.equal(player.time, 0);
  player.load(scene(2, { outcome: { kind: "failed", message: "no equilibrium" } }), false);
  assert.equal(player.time, 2);
});

test("statics open at the last state", () => {
  const player = newPlayer();
  player.load(scene(1, { analysis: "statics" }), false);
  assert.equal(player.time, 1);
  player.load(scene(1, { analysis: "path" }), false);
  assert.equal(player.time, 0);
});

test("shapes open at the first one that is not rigid", () => {
  const player = newPlayer();
  const labels = ["mode 1: rigid", "mode 2: rigid", "mode 3: 1.5 Hz"];
  const frames = { count: 3, values: Float64Array.of(1, 2, 3), labels };
  player.load(scene(1, { analysis: "modes", frames }), false);
  assert.equal(player.position, 2);
});
