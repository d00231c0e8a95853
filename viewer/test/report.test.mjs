// Report of a run: playback, keys, views, display options, tooltip.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  assertNear,
  close,
  currentFrame,
  currentTime,
  launch,
  open,
  screenshot,
  setTime,
  settle,
  stationPosition,
} from "./support/browser.mjs";
import { cantilever, deflection, tipDeflection } from "./support/cantilever.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

test("the page opens without errors and shows the body", async () => {
  const { tab, problems, shown } = await open(browser, cantilever());
  assert.equal(shown, true);
  assert.deepEqual(problems, []);
  assert.equal(await tab.$eval("h1", (e) => e.textContent), "cantilever");
  const share = await tab.evaluate(() => window.ancf.coverage());
  assert.ok(share > 0.01 && share < 0.9, `coverage ${share}`);
  await tab.close();
});

test("positions of stations are exact at frames and interpolated between them", async () => {
  const { tab } = await open(browser, cantilever());
  for (const t of [0, 0.5, 0.775]) {
    await setTime(tab, t);
    const [x, y] = await stationPosition(tab, 0, 20);
    assertNear(x, 0.5, 1e-6, "x");
    // Error bound of linear interpolation between frames 0.05 s apart: (0.05 π)² / 8 of the amplitude.
    assertNear(y, deflection(0.5, tipDeflection(t)), 0.25 * ((0.05 * Math.PI) ** 2 / 8), "y");
  }
  await tab.close();
});

test("the body is drawn at the position that `station` returns", async () => {
  const { tab } = await open(browser, cantilever());
  await tab.keyboard.press("m");
  await tab.keyboard.press("l");
  const shots = [];
  for (const t of [0.5, 1.5]) {
    await setTime(tab, t);
    await settle(tab);
    const [x, y] = await tab.evaluate(() => window.ancf.canvasPosition(0, 38));
    const box = await (await tab.$("canvas[tabindex]")).boundingBox();
    const clip = { x: Math.round(box.x + x) - 3, y: Math.round(box.y + y) - 3, width: 6, height: 6 };
    shots.push([clip, Buffer.from(await tab.screenshot({ clip })).toString("base64")]);
    if (shots.length === 2) {
      // The previous position now shows the background.
      const [old, body] = shots[0];
      assert.notEqual(Buffer.from(await tab.screenshot({ clip: old })).toString("base64"), body);
    }
  }
  await tab.close();
});

test("playback moves the tip, the 3-D view and the line in the charts", async () => {
  const { tab, problems } = await open(browser, cantilever());
  const [first, start] = [await screenshot(tab), await stationPosition(tab, 0, 40)];
  const line = () => tab.$eval(".time-line", (e) => e.style.transform);
  const before = await line();
  await tab.keyboard.press("Space");
  await tab.waitForFunction(() => window.ancf.time > 0.2);
  assert.equal(await tab.evaluate(() => window.ancf.playing), true);
  await tab.keyboard.press("Space");
  assert.equal(await tab.evaluate(() => window.ancf.playing), false);
  const tipNow = await stationPosition(tab, 0, 40);
  assertNear(tipNow[1], tipDeflection(await currentTime(tab)), 2e-3, "tip");
  assert.notEqual(tipNow[1], start[1]);
  assert.notEqual(await screenshot(tab), first);
  assert.notEqual(await line(), before);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("playback starts at once unless the user prefers reduced motion", async () => {
  const reduced = await open(browser, cantilever());
  assert.equal(await reduced.tab.evaluate(() => window.ancf.playing), false);
  await reduced.tab.close();
  const normal = await open(browser, cantilever(), { motion: "no-preference" });
  assert.equal(await normal.tab.evaluate(() => window.ancf.playing), true);
  await normal.tab.close();
});

test("nothing is drawn without a change", async () => {
  const before = () => {
    window.draws = 0;
    const draw = WebGL2RenderingContext.prototype.drawElementsInstanced;
    WebGL2RenderingContext.prototype.drawElementsInstanced = function (...a) {
      window.draws += 1;
      return draw.apply(this, a);
    };
  };
  const { tab } = await open(browser, cantilever(), { before });
  await settle(tab);
  const drawn = await tab.evaluate(() => window.draws);
  await new Promise((done) => setTimeout(done, 400));
  assert.ok(drawn > 0);
  assert.equal(await tab.evaluate(() => window.draws), drawn);
  await tab.close();
});

test("keys control the playback and the help", async () => {
  const { tab } = await open(browser, cantilever());
  const press = async (key, expected) => {
    await tab.keyboard.press(key);
    assert.equal(await currentFrame(tab), expected, key);
  };
  await press("ArrowRight", 1);
  await press("ArrowRight", 2);
  await press("ArrowLeft", 1);
  await tab.keyboard.down("Shift");
  await press("ArrowRight", 11);
  await tab.keyboard.up("Shift");
  await press("End", 40);
  await press("Home", 0);
  const speed = async () => {
    await settle(tab);
    return await tab.$eval(".transport select", (e) => Number(e.value));
  };
  const before = await speed();
  await tab.keyboard.press("+");
  assert.ok((await speed()) > before);
  await tab.keyboard.press("-");
  assert.equal(await speed(), before);
  await tab.keyboard.press("?");
  assert.ok(await tab.$("dialog[open]"));
  await tab.keyboard.press("Escape");
  assert.equal(await tab.$("dialog[open]"), null);
  await tab.close();
});

test("views and display options change the 3-D view", async () => {
  const { tab } = await open(browser, cantilever());
  await setTime(tab, 0.5);
  const seen = new Set([await screenshot(tab)]);
  for (const key of ["1", "2", "3", "4", ",", "z", "g", "r", "l", "n"]) {
    await tab.keyboard.press(key);
    seen.add(await screenshot(tab));
  }
  // One of the standard views is the initial view.
  assert.ok(seen.size >= 10, `${seen.size} different screenshots`);
  await tab.close();
});

test("the animation repeats if requested", async () => {
  const { tab } = await open(browser, cantilever({ frames: 11, until: 0.5 }));
  await setTime(tab, 0.45);
  await tab.keyboard.press("o");
  await tab.keyboard.press("Space");
  await tab.waitForFunction(() => window.ancf.time < 0.3, { timeout: 20_000 });
  assert.equal(await tab.evaluate(() => window.ancf.playing), true);
  await tab.close();
});

test("the slider sets the time", async () => {
  const { tab } = await open(browser, cantilever());
  const { x, y, width, height } = await (await tab.$(".time-slider")).boundingBox();
  await tab.mouse.click(x + width / 2, y + height / 2);
  assertNear(await currentTime(tab), 1, 0.02, "time");
  await tab.close();
});

test("displacements are scaled from the reference configuration", async () => {
  const { tab } = await open(browser, cantilever());
  await setTime(tab, 0.5);
  await tab.keyboard.press("d");
  const slider = 'input[aria-label="deformation"]';
  await tab.$eval(slider, (e) => {
    e.value = "1";
    e.dispatchEvent(new Event("input"));
  });
  const [x, y] = await stationPosition(tab, 0, 40);
  assertNear(x, 1, 1e-6, "x");
  assertNear(y, 10 * tipDeflection(0.5), 1e-5, "y");
  await tab.close();
});

test("the selected field sets the colours and the legend", async () => {
  const { tab } = await open(browser, cantilever());
  await setTime(tab, 0.25);
  const seen = [await screenshot(tab)];
  assert.match(await tab.$eval(".legend", (e) => e.textContent), /bending moment\s*N m.*75.*0.*−75/);
  await tab.keyboard.press("c");
  seen.push(await screenshot(tab));
  assert.match(await tab.$eval(".legend", (e) => e.textContent), /speed\s*m\/s.*0\.8/);
  await tab.keyboard.press("c");
  seen.push(await screenshot(tab));
  assert.equal(await tab.$eval(".legend", (e) => e.hidden), true);
  assert.equal(new Set(seen).size, 3);
  await tab.close();
});

test("a field with NaN values colours the other stations", async () => {
  const seen = [];
  for (const nan of [false, true]) {
    const { tab, problems } = await open(browser, cantilever({ nan }));
    await setTime(tab, 0.5);
    seen.push(await screenshot(tab));
    assert.deepEqual(problems, []);
    await tab.close();
  }
  assert.notEqual(seen[0], seen[1]);
});

test("the tooltip shows body, arc length and field value", async () => {
  const { tab } = await open(browser, cantilever());
  await setTime(tab, 0.5);
  await settle(tab);
  const box = await (await tab.$("canvas[tabindex]")).boundingBox();
  const [x, y] = await tab.evaluate(() => window.ancf.canvasPosition(0, 20));
  await tab.mouse.move(box.x + x, box.y + y);
  await settle(tab);
  const text = await tab.$eval(".tooltip", (e) => (e.hidden ? "" : e.textContent));
  assert.match(text, /rod/);
  assert.match(text, /s = 0\.5 m of 1 m/);
  assert.match(text, /bending moment: −37\.5 N m/);
  await tab.mouse.move(box.x + 5, box.y + box.height - 5);
  await settle(tab);
  assert.equal(await tab.$eval(".tooltip", (e) => e.hidden), true);
  await tab.close();
});
