// Labels over the 3-D view: names with values, without overlaps, outside buttons and legend.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, DESKTOP, launch, open, PHONE, setTime, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { f32 } from "./support/container.mjs";
import { modelPage } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** Visible labels with their rectangles, and the rectangles of the elements over the 3-D view. */
const labelLayout = (tab) =>
  tab.evaluate(() => {
    const rectangle = (e) => {
      const { left, top, right, bottom } = e.getBoundingClientRect();
      return { left, top, right, bottom };
    };
    const boxes = [...document.querySelectorAll(".labels > div:not([hidden])")];
    return {
      labels: boxes.map((e) => ({
        ...rectangle(e),
        name: e.querySelector("b").textContent,
        values: e.querySelector("span").textContent,
        clipped: e.scrollWidth > Math.ceil(e.getBoundingClientRect().width),
      })),
      lines: document.querySelectorAll(".labels path:not([hidden])").length,
      stage: rectangle(document.querySelector(".stage")),
      covered: [...document.querySelectorAll(".tools, .legend:not([hidden]), .triad, .grid-note")].map(
        rectangle,
      ),
    };
  });

const overlap = (a, b) =>
  a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;

function checkLayout({ labels, stage, covered }, name) {
  for (const [i, a] of labels.entries()) {
    const text = `${name}: ${a.name} ${a.values}`;
    assert.ok(a.values === "" || a.name !== "", `${text} has a value without a name`);
    assert.doesNotMatch(a.values, /e−/, text);
    for (const b of labels.slice(i + 1)) assert.ok(!overlap(a, b), `${text} overlaps ${b.name} ${b.values}`);
    for (const area of covered) assert.ok(!overlap(a, area), `${text} is under ${JSON.stringify(area)}`);
    const inside =
      a.left >= stage.left && a.right <= stage.right && a.top >= stage.top && a.bottom <= stage.bottom;
    assert.ok(inside, `${text} is clipped`);
  }
}

for (const [model, joints] of [
  ["belt", ["on", "off", "motor", "anchor", "hook"]],
  ["bow", ["grip", "nock", "rest", "loop"]],
  ["slider_crank", ["motor", "crank_pin", "block_pin", "guide"]],
  ["tuning_fork", []],
]) {
  test(`labels of ${model} have names, do not overlap and are not covered`, async () => {
    const html = modelPage(model);
    for (const viewport of [DESKTOP, PHONE]) {
      const { tab, problems } = await open(browser, null, { html, viewport });
      for (const share of [0, 0.1, 0.41, 0.77, 1]) {
        await tab.$eval(
          "input.time-slider",
          (e, x) => {
            e.value = String(Number(e.max) * x);
            e.dispatchEvent(new Event("input"));
          },
          share,
        );
        await settle(tab);
        const layout = await labelLayout(tab);
        checkLayout(layout, `${viewport.width} px, ${share}`);
        const names = layout.labels.map((l) => l.name);
        for (const joint of joints) assert.ok(names.includes(joint), `${joint} is not in ${names}`);
      }
      assert.deepEqual(problems, []);
      await tab.close();
    }
  });
}

test("reactions at one point have labels of their own; noise is omitted", async () => {
  const scene = cantilever();
  const [root] = scene.markers;
  const [reaction] = scene.reactions;
  scene.markers.push({ ...root, name: "second" });
  // 1e-6 of the largest reaction is noise.
  const noise = f32(new Array(3 * 41).fill(4e-6));
  scene.reactions.push({ ...reaction, name: "second", marker: 2 });
  scene.markers.push({ ...root, name: "third" });
  scene.reactions.push({ name: "third", marker: 3, force: noise, moment: noise });
  const { tab, problems } = await open(browser, scene);
  await setTime(tab, 0.5);
  await settle(tab);
  const { labels } = await labelLayout(tab);
  const values = (name) => labels.find((l) => l.name === name)?.values;
  assert.equal(values("root"), "F 10 N, M 75 N m");
  assert.equal(values("second"), "F 10 N, M 75 N m");
  assert.equal(values("third"), "");
  assert.deepEqual(problems, []);
  await tab.close();
});

test("displaced labels have lines to their points", async () => {
  const scene = cantilever();
  const tip = scene.markers[1];
  for (let i = 0; i < 12; i++) scene.markers.push({ ...tip, name: `probe ${i}` });
  const { tab } = await open(browser, scene);
  const layout = await labelLayout(tab);
  checkLayout(layout, "crowd");
  assert.ok(layout.labels.filter((l) => l.name.startsWith("probe")).length >= 10, "most labels are shown");
  assert.ok(layout.lines >= 4, `${layout.lines} lines`);
  await tab.close();
});

test("labels keep their side while the bodies move a little", async () => {
  const { tab } = await open(browser, cantilever());
  const offsets = [];
  for (const t of [0.5, 0.52, 0.54, 0.56]) {
    await setTime(tab, t);
    await settle(tab);
    const { labels } = await labelLayout(tab);
    const tip = labels.find((l) => l.name === "tip");
    const origin = await tab.$eval("canvas[tabindex]", (e) => e.getBoundingClientRect().toJSON());
    const [x, y] = await tab.evaluate(() => window.ancf.canvasPosition(0, 40));
    offsets.push([tip.left - origin.left - x, tip.top - origin.top - y].map(Math.round).join(" "));
  }
  const [x, y] = offsets[0].split(" ").map(Number);
  for (const other of offsets) {
    const [a, b] = other.split(" ").map(Number);
    assert.ok(Math.abs(a - x) <= 2 && Math.abs(b - y) <= 2, offsets.join("; "));
  }
  await tab.close();
});
