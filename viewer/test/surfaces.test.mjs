// Surfaces of rigid bodies: place, rotation, framing, damaged data.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertFramed, close, DESKTOP, launch, open, pixels, setTime, settle } from "./support/browser.mjs";
import { u32 } from "./support/container.mjs";
import { bracket } from "./support/surface.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** True for each point that the body covers. */
const covered = async (tab, points) => (await pixels(tab, points)).map((pixel) => pixel[3] > 200);

test("the surface turns with its body, in both themes", async () => {
  for (const theme of ["light", "dark"]) {
    const { tab, problems } = await open(browser, bracket(), { viewport: DESKTOP, theme });
    await settle(tab);
    // On the long bar, on the short bar, in the gap between them.
    const points = [
      [0.93, 0.13, 0],
      [0.13, 0.43, 0],
      [0.53, 0.43, 0],
    ];
    await setTime(tab, 0);
    assert.deepEqual(await covered(tab, points), [true, true, false]);
    await setTime(tab, 4);
    const turned = points.map(([x, y, z]) => [-y, x, z]);
    assert.deepEqual(await covered(tab, turned), [true, true, false]);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("edges of the surface are dark lines, its faces are plain", async () => {
  const { tab } = await open(browser, bracket(), { viewport: DESKTOP });
  await setTime(tab, 0);
  await settle(tab);
  const brightness = await tab.evaluate(() => {
    const at = (x, y) => window.ancf.pixels([window.ancf.project(x, y, 0)])[0].slice(0, 3);
    const sum = (colour) => colour.reduce((a, b) => a + b);
    // Across the long inner edge of the bracket, and across the diagonal between two of its triangles.
    const across = (x, y) => Math.min(...[-2, -1, 0, 1, 2].map((k) => sum(at(x, y + 0.0015 * k))));
    return { face: sum(at(0.5, 0.15)), edge: across(0.6, 0.198), diagonal: across(0.6, 0.12) };
  });
  assert.ok(brightness.edge < 0.75 * brightness.face, JSON.stringify(brightness));
  assert.ok(brightness.diagonal > 0.95 * brightness.face, JSON.stringify(brightness));
  await tab.close();
});

test("the camera frames the surface in all its positions", async () => {
  await assertFramed(browser, bracket());
});

test("a surface without some of its points is reported", async () => {
  const { tab } = await open(browser, bracket({ corners: u32([0, 1, 6]) }));
  const text = await tab.evaluate(() => document.body.textContent);
  assert.match(text, /the surface of bracket lacks points/);
});
