// The clock of the picture, without a browser.

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
const player = () => new Player(() => {});

test("the speed grows with a run that is watched, until one is chosen", () => {
  const clock = player();
  clock.load(live(0.1), false);
  assert.equal(clock.speed, 0.01);
  clock.load(live(80), true);
  assert.equal(clock.speed, 10);
  clock.choose(0.5);
  clock.load(live(8000), true);
  assert.equal(clock.speed, 0.5);
  clock.faster(1);
  clock.load(scene(80), true);
  assert.equal(clock.speed, 1);
});

test("a run opens at its start, one that failed at its end", () => {
  const clock = player();
  clock.load(scene(2), false);
  assert.equal(clock.time, 0);
  clock.load(scene(2, { outcome: { kind: "failed", message: "no equilibrium" } }), false);
  assert.equal(clock.time, 2);
});

test("shapes open at the first that is not rigid", () => {
  const clock = player();
  const labels = ["mode 1: rigid", "mode 2: rigid", "mode 3: 1.5 Hz"];
  const frames = { count: 3, values: Float64Array.of(1, 2, 3), labels };
  clock.load(scene(1, { analysis: "modes", frames }), false);
  assert.equal(clock.position, 2);
});
