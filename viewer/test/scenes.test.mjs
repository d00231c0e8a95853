// Scenes of other analyses, with special contents, or with damaged data.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  assertNear,
  close,
  currentFrame,
  currentTime,
  launch,
  legendValue,
  open,
  plotArea,
  setTime,
  settle,
  stationPosition,
} from "./support/browser.mjs";
import { cantilever, tipDeflection } from "./support/cantilever.mjs";
import { page, report } from "./support/container.mjs";
import { machine } from "./support/machine.mjs";
import { frequencies, modes } from "./support/shapes.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

test("shapes are listed, selected and oscillate", async () => {
  const { tab, problems } = await open(browser, modes());
  const labels = await tab.$$eval(".shape-button", (all) => all.map((e) => e.textContent));
  assert.deepEqual(labels, ["mode 1: 12.3 Hz", "mode 2: 77.1 Hz", "mode 3: 216 Hz"]);
  const initial = await stationPosition(tab, 0, 40);
  assertNear(initial[0], 0.1, 1e-6, "first shape at its maximum");
  await tab.keyboard.press("Space");
  const seen = await tab.evaluate(async () => {
    const list = [];
    for (let i = 0; i < 60; i++) {
      await new Promise((done) => setTimeout(done, 40));
      list.push(window.ancf.station(0, 40)[0]);
    }
    return list;
  });
  assert.ok(Math.min(...seen) < -0.05 && Math.max(...seen) > 0.05, "both signs");
  await tab.keyboard.press("Space");
  const buttons = await tab.$$(".shape-button");
  await buttons[2].click();
  assert.equal(await currentFrame(tab), 2);
  await settle(tab);
  assert.equal(await buttons[2].evaluate((b) => b.getAttribute("aria-pressed")), "true");
  assert.deepEqual(problems, []);
  await tab.close();
});

test("shapes have six digits or are rigid, and are selected in the chart", async () => {
  const { tab, problems } = await open(browser, frequencies());
  const labels = await tab.$$eval(".shape-button", (all) => all.map((e) => e.textContent));
  assert.deepEqual(labels, ["mode 1: rigid", "mode 2: 77.1234 Hz", "mode 3: 216.001 Hz"]);
  assert.equal(await currentFrame(tab), 1, "first shape that is not rigid");
  await tab.click("#tab-Charts");
  await settle(tab);
  assertNear(await legendValue(tab, "frequency"), 77.12, 1e-9, "frequency");
  assert.equal(await tab.$eval(".time-line", (e) => e.hidden), false);
  const { left, top, width, height } = await plotArea(tab);
  await tab.mouse.click(left + 0.8 * width, top + height / 2);
  assert.equal(await currentFrame(tab), 2);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("the legend shows rounding noise as zero", async () => {
  const scene = cantilever();
  const [, speed] = scene.fields;
  scene.fields = [
    { ...speed, range: [1e-17, 0.8] },
    { ...speed, name: "drift", range: [0, 1e-15] },
  ];
  const { tab } = await open(browser, scene);
  const seen = () => tab.$$eval(".legend li", (all) => all.map((e) => e.textContent));
  assert.deepEqual(await seen(), ["0.8", "0.6", "0.4", "0.2", "0"]);
  await tab.keyboard.press("c");
  await settle(tab);
  assert.deepEqual(await seen(), ["0", "0", "0", "0", "0"]);
  await tab.close();
});

test("the summary names the program once", async () => {
  const scene = cantilever();
  scene.summary.push(["program", "ancf 0.1.0 on 8 cores"]);
  const { tab } = await open(browser, scene);
  const rows = await tab.$$eval(".run th", (all) => all.map((e) => e.textContent));
  assert.equal(rows.filter((name) => name === "program").length, 1);
  await tab.close();
});

test("a failed run shows its message; obstacles, links and rigid bodies are drawn", async () => {
  const { tab, problems } = await open(browser, machine());
  assert.match(await tab.$eval(".banner", (e) => e.textContent), /no equilibrium at t = 1 s/);
  assert.equal(await currentTime(tab), 1, "last frame");
  assert.equal(await tab.evaluate(() => window.ancf.playing), false);
  await tab.click("#tab-Run");
  assert.match(await tab.$eval(".messages", (e) => e.textContent), /touches the floor/);
  assert.ok((await tab.evaluate(() => window.ancf.coverage())) > 0.2);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("a single frame and no frames", async () => {
  const one = await open(browser, cantilever({ frames: 1 }));
  assert.ok((await one.tab.evaluate(() => window.ancf.coverage())) > 0.01);
  assert.equal(await one.tab.$eval(".primary", (e) => e.disabled), true);
  assert.deepEqual(one.problems, []);
  await one.tab.close();
  const none = await open(browser, { ...machine(), ...withoutFrames() });
  assert.match(await none.tab.$eval(".placeholder", (e) => e.textContent), /nothing to draw/);
  assert.deepEqual(none.problems, []);
  await none.tab.close();
});

test("truncated, foreign and missing data give a message", async () => {
  const complete = report(cantilever());
  const data = complete.match(/id="scene">([^<]*)</)[1];
  const cases = [data.slice(0, data.length >> 1), Buffer.from("a text").toString("base64"), "@@@", ""];
  for (const text of cases) {
    const { tab, problems, shown } = await open(browser, null, { html: page(text) });
    assert.equal(shown, false);
    assert.match(
      await tab.$eval(".banner", (e) => e.textContent),
      /^(The data of this page|This page holds)/,
    );
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("without WebGL 2 the charts are shown with a message", async () => {
  const before = () => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
      return kind === "webgl2" ? null : get.call(this, kind, ...more);
    };
  };
  const { tab, problems } = await open(browser, cantilever(), { before });
  assert.match(await tab.$eval(".placeholder", (e) => e.textContent), /WebGL 2/);
  await setTime(tab, 0.5);
  await settle(tab);
  assertNear(await legendValue(tab, "y"), tipDeflection(0.5), 1e-3, "y");
  assert.deepEqual(problems, []);
  await tab.close();
});

function withoutFrames() {
  const none = cantilever({ frames: 0 });
  return {
    frames: none.frames,
    centres: none.centres,
    directors: none.directors,
    markers: [],
    links: [],
    charts: [],
  };
}
