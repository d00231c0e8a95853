// Pixels of the 3-D view: edges, faces, spokes, floors and shadows.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, launch, open, pixels, setTime, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { f32 } from "./support/container.mjs";
import { machine } from "./support/machine.mjs";
import { modelPage } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** Opens a scene in the dark or light theme, without labels, markers and arrows. */
async function openBare(scene, options = {}) {
  const page = await open(browser, scene, { viewport: { width: 1400, height: 900 }, ...options });
  for (const key of ["l", "m", "r"]) await page.tab.keyboard.press(key);
  await settle(page.tab);
  return page;
}

/** Brightness of a colour from 0 to 1. */
const luminance = ([r, g, b]) => (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

test("end face and wall of a cylinder differ by at least 15 % in luminance", async () => {
  for (const theme of ["light", "dark"]) {
    const { tab } = await openBare(machine(), { theme });
    // The drum has its axis along y: centre (0.3, 0.6, 0.12), radius 0.12, length 0.6.
    const circle = Array.from({ length: 12 }, (_, i) => (2 * Math.PI * i) / 12);
    const face = circle.map((a) => [0.3 + 0.06 * Math.cos(a), 0.3, 0.12 + 0.06 * Math.sin(a)]);
    const wall = [0.35, 0.42, 0.5, 0.6].map((y) => [
      0.3 + 0.12 * Math.SQRT1_2,
      y,
      0.12 + 0.12 * Math.SQRT1_2,
    ]);
    const [of_face, of_wall] = [await pixels(tab, face), await pixels(tab, wall)].map((list) =>
      median(list.map(luminance)),
    );
    assert.ok(Math.abs(of_face / of_wall - 1) >= 0.15, `${theme}: ${of_face} and ${of_wall}`);
    await tab.close();
  }
});

test("edges of a rigid body are dark lines", async () => {
  const { tab } = await openBare(machine());
  await setTime(tab, 0);
  // The box is at height 0.7 with half edges 0.15, 0.1, 0.08; its front face has the normal -y.
  const [face, ...edge] = await pixels(tab, [
    [0.05, -0.1, 0.7],
    ...[-0.1, -0.05, 0.05, 0.1].map((x) => [x, -0.0995, 0.7795]),
  ]);
  const dark = Math.min(...edge.map(luminance));
  assert.ok(dark < 0.75 * luminance(face), `${dark} on ${luminance(face)}`);
  await tab.close();
});

test("spokes show the rotation of the pulley of the belt", async () => {
  const { tab, problems } = await open(browser, null, {
    html: modelPage("belt"),
    viewport: { width: 1400, height: 900 },
  });
  for (const key of ["l", "m", "r"]) await tab.keyboard.press(key);
  const sample = async (t) => {
    await setTime(tab, t);
    await settle(tab);
    const circle = Array.from({ length: 240 }, (_, i) => (2 * Math.PI * i) / 240);
    const found = await pixels(
      tab,
      circle.map((a) => [0.055 * Math.cos(a), -0.03, 0.055 * Math.sin(a)]),
    );
    return found.map(luminance);
  };
  const first = await sample(0);
  const bright = median(first);
  const spokes = first.filter((x, i) => x < 0.9 * bright && first.at(i - 1) >= 0.9 * bright);
  assert.equal(spokes.length, 6);
  const last = await sample(0.6);
  const changed = first.filter((x, i) => Math.abs(x - last[i]) > 0.05);
  assert.ok(changed.length > 8, `${changed.length} of 240 points changed`);
  assert.deepEqual(problems, []);
  await tab.close();
});

/** The machine with its bodies, markers and links moved along x, away from the origin of the floor. */
function distantMachine(shift) {
  const scene = machine();
  const moved = ({ data }) => f32([...data].map((x, i) => (i % 3 === 0 ? x + shift : x)));
  scene.centres = moved(scene.centres);
  scene.reference.centres = moved(scene.reference.centres);
  for (const marker of scene.markers) marker.at = moved(marker.at);
  for (const link of scene.links) link.ends = moved(link.ends);
  scene.bounds = scene.bounds.map(([x, y, z]) => [x + shift, y, z]);
  scene.obstacles = scene.obstacles.filter((o) => o.kind === "plane");
  return scene;
}

test("a floor covers the whole motion, and has no second grid below it", async () => {
  const shift = 6;
  const { tab } = await openBare(distantMachine(shift));
  await tab.keyboard.press("2");
  for (let i = 0; i < 3; i++) await tab.keyboard.press("x");
  await settle(tab);
  const corners = [
    [-0.15, -0.3],
    [0.75, -0.3],
    [0.75, 0.3],
    [-0.15, 0.3],
    [0.7, 0],
  ];
  const below = await pixels(
    tab,
    corners.map(([x, y]) => [x + shift, y, 0]),
  );
  for (const [i, colour] of below.entries()) assert.ok(colour[3] > 120, `${corners[i]}: ${colour}`);
  const outside = [
    [shift - 0.55, 0, 0],
    [shift + 0.3, -0.75, 0],
  ];
  for (const point of outside) {
    const [x, y] = await tab.evaluate((p) => window.ancf.project(...p), point);
    assert.ok(x > 0 && y > 0 && x < 980 && y < 800, `${point} is on the canvas`);
  }
  for (const colour of await pixels(tab, outside)) assert.equal(colour[3], 0);
  await tab.close();
});

test("bodies and obstacles have shadows on the floor", async () => {
  const { tab } = await openBare(machine());
  await setTime(tab, 0);
  const range = [-0.06, -0.03, 0.03, 0.06];
  const box = range.map((x) => [x, 0.04, 0]);
  const free = range.map((x) => [x - 0.25, -0.25, 0]);
  const brightness = async (points) =>
    median((await pixels(tab, points)).map((c) => luminance(c) / (c[3] / 255)));
  const shaded = await brightness(box);
  const lit = await brightness(free);
  assert.ok(shaded < 0.9 * lit, `${shaded} and ${lit}`);
  // The stone touches the floor at (-0.5, 0); its radius is 0.15.
  const stone = await brightness([-0.48, -0.46, -0.44, -0.42].map((x) => [x, -0.11, 0]));
  assert.ok(stone < 0.9 * lit, `${stone} and ${lit}`);
  await tab.keyboard.press("d");
  await tab.$$eval(".check", (all) => all.find((e) => e.textContent.startsWith("shadows")).click());
  await settle(tab);
  const without = await brightness(box);
  assert.ok(Math.abs(without / lit - 1) < 0.03, `${without} and ${lit}`);
  await tab.close();
});

test("shadows without a floor are on the grid below the motion", async () => {
  const { tab } = await openBare(cantilever());
  await tab.keyboard.press("4");
  await settle(tab);
  // Below the lowest point by 3 % of the diagonal; the radius of the beam is 0.029.
  const level = -0.25 - 0.029 - 0.03 * Math.hypot(1, 0.5);
  const opacity = async () =>
    Math.max(
      ...(
        await pixels(
          tab,
          [0.3, 0.35, 0.45, 0.55].map((x) => [x, level, 0]),
        )
      ).map((c) => c[3]),
    );
  assert.ok((await opacity()) > 20);
  await tab.keyboard.press("d");
  await tab.$$eval(".check", (all) => all.find((e) => e.textContent.startsWith("shadows")).click());
  await tab.$$eval(".check", (all) => all.find((e) => e.textContent.startsWith("grid")).click());
  await settle(tab);
  assert.equal(await opacity(), 0);
  await tab.close();
});

test("bodies in the darkest colour contrast with the background of both themes", async () => {
  for (const theme of ["light", "dark"]) {
    const { tab } = await openBare(cantilever(), { theme });
    await tab.select('select[aria-label="colour by"]', "speed");
    await tab.select('select[aria-label="colour map"]', "viridis");
    await setTime(tab, 0.5);
    await settle(tab);
    // At t = 0.5 s all speeds are zero.
    const [body] = await pixels(tab, [[0.2, -0.012, 0.02]]);
    const stage = await tab.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const hex = style.getPropertyValue("--stage").trim();
      return [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16));
    });
    const linear = (c) => (c <= 10 ? c / 3295 : ((c / 255 + 0.055) / 1.055) ** 2.4);
    const relative = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b) + 0.05;
    const [a, b] = [relative(body), relative(stage)];
    const contrast = Math.max(a / b, b / a);
    assert.ok(contrast >= 1.25, `${theme}: ${contrast.toFixed(2)} of ${body} on ${stage}`);
    await tab.close();
  }
});
