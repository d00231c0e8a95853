// Surfaces of rigid bodies: place, rotation, framing, damaged data.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, DESKTOP, launch, open, PHONE, setTime, settle } from "./support/browser.mjs";
import { u32 } from "./support/container.mjs";
import { bracket } from "./support/surface.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** True for each point that the body covers. */
const covered = (tab, points) =>
  tab.evaluate(
    (list) => list.map((point) => window.ancf.pixel(...(window.ancf.project(...point) ?? [-1, -1]))[3] > 200),
    points,
  );

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

test("the camera frames the surface in all its positions", async () => {
  for (const viewport of [DESKTOP, PHONE]) {
    const { tab } = await open(browser, bracket(), { viewport });
    await settle(tab);
    const { free, motion } = await tab.evaluate(() => window.ancf.framing());
    const share = Math.max(
      (motion.right - motion.left) / (free.right - free.left),
      (motion.bottom - motion.top) / (free.bottom - free.top),
    );
    assert.ok(share > 0.7 && share < 1.01, `${viewport.width}: ${share}`);
    await tab.close();
  }
});

test("a surface without some of its points is reported", async () => {
  const { tab } = await open(browser, bracket({ corners: u32([0, 1, 6]) }));
  const text = await tab.evaluate(() => document.body.textContent);
  assert.match(text, /the surface of bracket lacks points/);
});
