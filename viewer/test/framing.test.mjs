// Framing of the motion and of the arrows in the free area of the 3-D view, for all models of the repository.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, DESKTOP, launch, open, PHONE, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { f32 } from "./support/container.mjs";
import { modelNames, modelPage } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** Smallest share of the free area that the longer side of the motion covers. */
const SHARE = 0.7;
/** Models whose motion or structure is not in one plane. */
const SPATIAL = [
  "annulus",
  "arc",
  "banner",
  "bracket",
  "cloth",
  "column",
  "hanging_rope",
  "roof",
  "rope",
  "rotor",
  "spring",
  "tent",
  "tuning_fork",
];

/** Rectangles of the elements over the 3-D view, relative to the canvas. */
const coveredAreas = (tab) =>
  tab.evaluate(() => {
    const origin = document.querySelector("canvas[tabindex]").getBoundingClientRect();
    return [...document.querySelectorAll(".tools, .legend:not([hidden]), .triad, .grid-note")].map((e) => {
      const { left, top, right, bottom } = e.getBoundingClientRect();
      const [x, y] = [origin.left, origin.top];
      return { left: left - x, top: top - y, right: right - x, bottom: bottom - y, name: e.className };
    });
  });

/** Box around the projected stations of all bodies in evenly spaced frames. */
const projectedStations = (tab) =>
  tab.evaluate(async () => {
    const slider = document.querySelector("input.time-slider");
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i <= 12; i++) {
      slider.value = String((Number(slider.max) * i) / 12);
      slider.dispatchEvent(new Event("input"));
      for (const [body, count] of window.ancf.stations().entries()) {
        for (let k = 0; k < count; k += 1) {
          const [x, y] = window.ancf.canvasPosition(body, k) ?? [Number.NaN, Number.NaN];
          box[0] = Math.min(box[0], x);
          box[1] = Math.min(box[1], y);
          box[2] = Math.max(box[2], x);
          box[3] = Math.max(box[3], y);
        }
      }
    }
    const [left, top, right, bottom] = box;
    return { left, top, right, bottom };
  });

const inside = (a, b) =>
  a.left >= b.left - 0.5 && a.top >= b.top - 0.5 && a.right <= b.right + 0.5 && a.bottom <= b.bottom + 0.5;
const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

async function checkFraming(tab, name) {
  const { free, motion, arrows } = await tab.evaluate(() => window.ancf.framing());
  const stations = await projectedStations(tab);
  const text = JSON.stringify({ free, motion, arrows, stations });
  assert.ok(inside(motion, free), `${name}: motion outside the free area: ${text}`);
  assert.ok(inside(stations, motion), `${name}: station outside the motion: ${text}`);
  if (arrows) assert.ok(inside(arrows, free), `${name}: arrow clipped: ${text}`);
  const share = Math.max(
    (motion.right - motion.left) / (free.right - free.left),
    (motion.bottom - motion.top) / (free.bottom - free.top),
  );
  assert.ok(share >= SHARE, `${name}: the motion covers ${share.toFixed(2)} of the free area: ${text}`);
  for (const area of await coveredAreas(tab)) {
    assert.ok(!overlap(area, free), `${name}: the free area is under ${area.name}: ${text}`);
  }
}

for (const name of modelNames) {
  test(`${name} fills the free area`, async () => {
    const html = modelPage(name);
    for (const viewport of [DESKTOP, PHONE]) {
      const { tab, problems } = await open(browser, null, { html, viewport });
      await checkFraming(tab, `${name}, ${viewport.width} px`);
      if (viewport === DESKTOP) {
        const oblique = await tab.evaluate(() => window.ancf.direction.every((x) => Math.abs(x) > 0.05));
        assert.equal(oblique, SPATIAL.includes(name), `${name}: oblique view`);
      }
      assert.deepEqual(problems, []);
      await tab.close();
    }
  });
}

test("all standard views fit the motion", async () => {
  const { tab } = await open(browser, cantilever());
  for (const key of ["1", "2", "3", "4", "f"]) {
    await tab.keyboard.press(key);
    await settle(tab);
    const { free, motion, arrows } = await tab.evaluate(() => window.ancf.framing());
    assert.ok(inside(motion, free) && inside(arrows, free), key);
  }
  await tab.close();
});

test("a motion in a tilted plane is seen along its normal", async () => {
  const scene = cantilever();
  const s = Math.SQRT1_2;
  const rotate = ({ data }) => {
    const turned = [];
    for (let i = 0; i < data.length; i += 3) turned.push(s * data[i], data[i + 1], s * data[i]);
    return f32(turned);
  };
  scene.centres = rotate(scene.centres);
  scene.reference.centres = rotate(scene.reference.centres);
  scene.markers = [];
  scene.reactions = [];
  const { tab } = await open(browser, scene);
  const [x, y, z] = await tab.evaluate(() => window.ancf.direction);
  assert.ok(Math.abs(Math.abs(x) - s) < 1e-3 && Math.abs(y) < 1e-3 && x * z < 0, `${[x, y, z]}`);
  await tab.close();
});

test("a view that was not moved is fitted after a change of size", async () => {
  const { tab } = await open(browser, cantilever(), { viewport: DESKTOP });
  await tab.setViewport(PHONE);
  await settle(tab);
  await checkFraming(tab, "after the change");
  await tab.close();
});
