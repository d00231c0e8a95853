// Shells: faces, colours, edges of elements, supports and loads, picking, framing, damaged data.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertFramed, close, DESKTOP, launch, open, pixels, setTime, settle } from "./support/browser.mjs";
import { plate } from "./support/shell.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

const sum = (colour) => colour.slice(0, 3).reduce((a, b) => a + b);

test("the surface follows the motion, in both themes", async () => {
  for (const theme of ["light", "dark"]) {
    const { tab, problems } = await open(browser, plate(), { viewport: DESKTOP, theme });
    // In the middle of elements, away from symbols.
    const flat = [0.25, 0.58, 0.92].map((x) => [x, 0.08, 0]);
    await setTime(tab, 0);
    await settle(tab);
    assert.ok((await pixels(tab, flat)).every((colour) => colour[3] > 200));
    await setTime(tab, 10);
    await settle(tab);
    const bent = flat.map(([x, y]) => [x, y, 0.5 * x * x]);
    assert.ok((await pixels(tab, bent)).every((colour) => colour[3] > 200));
    assert.equal((await pixels(tab, flat.slice(2)))[0][3] > 200, false, "the tip has left its place");
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("colours are those of the field at the stations", async () => {
  const { tab } = await open(browser, plate(), { viewport: DESKTOP });
  await setTime(tab, 0);
  await settle(tab);
  const [start, end] = await pixels(tab, [
    [0.08, 0.08, 0],
    [0.92, 0.08, 0],
  ]);
  assert.ok(Math.hypot(...start.slice(0, 3).map((c, k) => c - end[k])) > 60, `${start} ${end}`);
  await tab.close();
});

test("edges of elements are faint lines that a key hides", async () => {
  const { tab } = await open(browser, plate(), { viewport: DESKTOP });
  await setTime(tab, 0);
  await tab.keyboard.press("m");
  const darkest = async () => {
    await settle(tab);
    // Across the edge between two elements, and within an element.
    const across = Array.from({ length: 9 }, (_, k) => [0.5 + 0.0008 * (k - 4), 0.08, 0.01]);
    const [line, face] = [await pixels(tab, across), await pixels(tab, [[0.51, 0.08, 0.01]])];
    return Math.min(...line.map(sum)) / sum(face[0]);
  };
  assert.ok((await darkest()) < 0.93, "line");
  await tab.keyboard.press("e");
  assert.ok((await darkest()) > 0.95, "no line");
  await tab.close();
});

test("supported edges and loads are drawn, and hidden with the other symbols", async () => {
  const { tab } = await open(browser, plate(), { viewport: DESKTOP });
  await setTime(tab, 0);
  await settle(tab);
  // On the supported edge, and on the arrow of the pressure above the plate.
  const places = [
    [-0.003, 0.3, 0.0133],
    [0.5, 0.25, 0.03],
  ];
  const before = await pixels(tab, places);
  assert.ok(before[0][0] > 1.5 * before[0][2], `orange edge: ${before[0]}`);
  await tab.keyboard.press("m");
  await settle(tab);
  const after = await pixels(tab, places);
  for (const k of [0, 1]) assert.notDeepEqual(before[k], after[k], `object ${k}`);
  await tab.close();
});

test("the tooltip has the parameters of the station", async () => {
  const { tab } = await open(browser, plate(), { viewport: DESKTOP });
  await setTime(tab, 10);
  await settle(tab);
  const [x, y] = await tab.evaluate(() => window.ancf.project(0.75, 0.125, 0.5 * 0.75 ** 2));
  const box = await (await tab.$("canvas[tabindex]")).boundingBox();
  await tab.mouse.move(box.x + x, box.y + y);
  await settle(tab);
  const text = await tab.$eval(".tooltip", (e) => e.textContent);
  assert.match(text, /plate/);
  assert.match(text, /u = 0.75, v = 0.25/);
  assert.match(text, /von Mises stress: 0.75/);
  await tab.close();
});

test("the camera frames the plate in all its positions", async () => {
  await assertFramed(browser, plate());
});

test("a grid without some of its stations is reported", async () => {
  const { tab } = await open(
    browser,
    plate({ body: { grid: { patches: 1, counts: [7, 3], parts: 4, half: 0.01 } } }),
  );
  const text = await tab.evaluate(() => document.body.textContent);
  assert.match(text, /the grid of the body plate lacks stations/);
});
