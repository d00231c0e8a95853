// Complex shapes of damped modes: points of a whirl move on circles.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { close, launch, open, settle } from "./support/browser.mjs";
import { pack } from "./support/container.mjs";
import { whirls } from "./support/shapes.mjs";

const source = (name) => JSON.stringify(join(import.meta.dirname, "../src", name));
const TIP = 40;
let modules;
let browser;
before(async () => {
  const contents = ["ui/player", "scene/blend", "scene/container", "scene/scene", "view/extent"]
    .map((name) => `export * from ${source(name)};`)
    .join("\n");
  const stdin = { contents, resolveDir: import.meta.dirname };
  const { outputFiles } = await build({ stdin, bundle: true, format: "esm", write: false });
  const address = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  modules = await import(address);
  browser = await launch();
});
after(() => close(browser));

function decoded(scene) {
  const bytes = pack(scene);
  return modules.decodeScene(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/** Positions of the tip of the mast over a period of a shape. */
function path(scene, shape, deformation = 1) {
  const player = new modules.Player(() => {});
  player.load(scene, false);
  player.goTo(shape);
  player.toggle();
  player.tick(0);
  const points = [];
  for (let i = 0; i < 20; i++) {
    points.push(modules.stationPosition(scene, TIP, player.blend(deformation)));
    player.tick(0.1 * (i + 1));
  }
  return points;
}

test("a point of a whirl moves on a circle, forward or backward", () => {
  const scene = decoded(whirls());
  for (const [shape, sense] of [
    [0, 1],
    [1, -1],
  ]) {
    const points = path(scene, shape);
    const radius = Math.abs(points[0][0]);
    assert.ok(radius > 0.05 && Math.abs(points[0][1]) < 1e-9, "the shape starts with its real part");
    points.forEach(([x, y, z], i) => {
      assert.ok(Math.abs(Math.hypot(x, y) / radius - 1) < 1e-6, `radius ${Math.hypot(x, y)} not ${radius}`);
      assert.ok(Math.abs(z - 1) < 1e-6);
      const [u, v] = points[(i + 1) % points.length];
      const turn = Math.atan2(x * v - y * u, x * u + y * v);
      assert.ok(Math.abs(turn - (sense * 2 * Math.PI) / points.length) < 1e-6, `turn by ${turn}`);
    });
  }
});

test("a real shape among complex ones moves along a line, and a scale applies to both parts", () => {
  const scene = decoded(whirls());
  assert.ok(path(scene, 2).every(([, y]) => y === 0));
  const [one, two] = [path(scene, 0), path(scene, 0, 2)];
  one.forEach((point, i) => {
    for (const k of [0, 1]) assert.ok(Math.abs(two[i][k] - 2 * point[k]) < 1e-6);
  });
});

test("the whole circle is framed", () => {
  const { box } = modules.extentOf(decoded(whirls()), 1, false);
  const tips = [0, 1].map((shape) => Math.abs(path(decoded(whirls()), shape)[0][0]));
  const radius = Math.max(...tips);
  for (const k of [0, 1]) {
    assert.ok(box[0][k] < -0.99 * radius && box[1][k] > 0.99 * radius, `${box}`);
  }
});

test("scenes without a frame of an imaginary part are damaged", () => {
  const scene = whirls();
  scene.frames.imaginary = [3, 9, null];
  assert.throws(() => decoded(scene), /imaginary part/);
});

test("the mast is drawn where its stations are during a whirl", async () => {
  const { tab, problems } = await open(browser, whirls());
  const drawn = () =>
    tab.evaluate((index) => {
      const at = window.ancf.canvasPosition(0, index);
      return {
        position: window.ancf.station(0, index),
        colour: window.ancf.pixels([at])[0],
        playing: window.ancf.playing,
      };
    }, TIP - 4);
  const angles = new Set();
  for (let i = 0; i < 6; i++) {
    await tab.keyboard.press("Space");
    await new Promise((resolve) => setTimeout(resolve, 230));
    await tab.keyboard.press("Space");
    await settle(tab);
    const { position, colour, playing } = await drawn();
    assert.equal(playing, false);
    assert.ok(colour[3] > 200, `${position}: ${colour}`);
    angles.add(Math.round(Math.atan2(position[1], position[0]) * 10));
  }
  assert.ok(angles.size > 3, `${[...angles]}`);
  assert.deepEqual(problems, []);
  await tab.close();
});
