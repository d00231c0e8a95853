// Charts and exported files.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import {
  assertNear,
  close,
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
import { chartScene } from "./support/charts.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

describe("exported files", () => {
  /** Records the blobs that the page saves. */
  const before = () => {
    window.saved = [];
    URL.createObjectURL = (blob) => {
      window.saved.push([blob.type, blob.size]);
      return "data:,";
    };
    HTMLAnchorElement.prototype.click = () => {};
  };
  const saved = async (tab, click) => {
    await click();
    await tab.waitForFunction(() => window.saved.length > 0, { timeout: 20_000 });
    return await tab.evaluate(() => window.saved[0]);
  };

  test("image and text of the model", async () => {
    const { tab, problems } = await open(browser, cantilever(), { before });
    const [type, size] = await saved(tab, () => tab.click('[aria-label="Save image"]'));
    assert.equal(type, "image/png");
    assert.ok(size > 10_000, `${size} bytes`);
    await tab.evaluate(() => {
      window.saved = [];
    });
    await tab.click("#tab-Run");
    await tab.click(".run summary");
    const { text } = cantilever();
    assert.equal(await tab.$eval("pre", (e) => e.textContent), text);
    const save = await tab.waitForSelector(".buttons button:nth-child(2)");
    assert.deepEqual(await saved(tab, () => save.click()), ["application/toml", text.length]);
    assert.deepEqual(problems, []);
    await tab.close();
  });

  test("video of the whole run", async () => {
    const { tab, problems } = await open(browser, cantilever({ frames: 6, until: 0.5 }), { before });
    for (let i = 0; i < 3; i++) await tab.keyboard.press("+");
    const [type, size] = await saved(tab, () => tab.click('[aria-label="Save video"]'));
    assert.match(type, /^video\//);
    assert.ok(size > 1000, `${size} bytes`);
    assert.equal(await currentTime(tab), 0.5);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});

describe("charts", () => {
  test("the legend shows the values at the pointer", async () => {
    const { tab } = await open(browser, cantilever());
    const { left, top, width, height } = await plotArea(tab);
    await tab.mouse.move(left + 0.375 * width, top + height / 2);
    await settle(tab);
    assertNear(await legendValue(tab, "y"), tipDeflection(0.75), 5e-3, "y");
    assertNear(await legendValue(tab, "z"), 0.075, 2e-3, "z");
    await tab.close();
  });

  test("a click or a drag sets the time", async () => {
    const { tab } = await open(browser, cantilever());
    const { left, top, width, height } = await plotArea(tab);
    await tab.mouse.click(left + 0.25 * width, top + height / 2);
    assertNear(await currentTime(tab), 0.5, 0.01, "time");
    assertNear((await stationPosition(tab, 0, 40))[1], tipDeflection(0.5), 1e-3, "tip");
    await tab.mouse.down();
    await tab.mouse.move(left + 0.75 * width, top + height / 2, { steps: 4 });
    await tab.mouse.up();
    assertNear(await currentTime(tab), 1.5, 0.01, "time");
    await tab.close();
  });

  test("the legend shows the values at the current time", async () => {
    const { tab } = await open(browser, cantilever());
    await setTime(tab, 1.25);
    await settle(tab);
    assertNear(await legendValue(tab, "y"), tipDeflection(1.25), 1e-3, "y");
    await setTime(tab, 1.75);
    await settle(tab);
    assert.ok(Number.isNaN(await legendValue(tab, "z")), "NaN is not shown as a value");
    await tab.close();
  });

  test("estimated errors are bands, where they are known", async () => {
    const rows = [0, 1, 2, 3, 4];
    const own = ["y", "m", rows.map((k) => k), [0.5, 0.5, Number.NaN, 0.5, 0.5]];
    const fills = () => {
      window.fills = 0;
      const { fill } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.fill = function (...rest) {
        if (this.globalAlpha < 0.5) window.fills += 1;
        return fill.apply(this, rest);
      };
    };
    const with_errors = chartScene([{ title: "position", columns: [own] }]);
    const { tab, problems } = await open(browser, with_errors, { before: fills });
    assert.match(await tab.$eval(".chart", (e) => e.textContent), /± estimated error/);
    // A band on each side of the row without an error, in each drawing.
    const count = await tab.evaluate(() => window.fills);
    assert.ok(count >= 2 && count % 2 === 0, `${count} bands`);
    assert.deepEqual(problems, []);
    await tab.close();
    const { tab: plain } = await open(
      browser,
      chartScene([{ title: "position", columns: [own.slice(0, 3)] }]),
    );
    assert.doesNotMatch(await plain.$eval(".chart", (e) => e.textContent), /estimated error/);
    await plain.close();
  });

  test("charts have groups and logarithmic axes", async () => {
    const { tab, problems } = await open(browser, cantilever());
    await tab.click('[data-group="solver"]');
    const titles = await tab.$$eval(".chart h2", (all) => all.map((e) => e.firstChild.textContent));
    assert.deepEqual(titles, ["step size", "iterations"]);
    assert.match(await tab.$eval(".chart", (e) => e.textContent), /logarithmic/);
    await setTime(tab, 0.5);
    await tab.click('[data-group="energy"]');
    await settle(tab);
    assertNear(await legendValue(tab, "strain"), 9, 1e-3, "the values at the current time are shown at once");
    assert.equal(await tab.$eval(".time-line", (e) => e.hidden), false);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});

/** Records the labels that the charts draw on their canvases. */
const recordLabels = () => {
  window.labels = [];
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
    window.labels.push(text);
    return fillText.call(this, text, ...more);
  };
};
const drawnLabels = (tab) => tab.evaluate(() => window.labels);
/** True if the first chart has pixels in the colour of its first curve. */
const hasCurve = (tab) =>
  tab.evaluate(() => {
    const canvas = document.querySelector(".chart canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    for (let i = 0; i < data.length; i += 4) {
      if (Math.abs(data[i] - 63) + Math.abs(data[i + 1] - 134) + Math.abs(data[i + 2] - 208) < 12)
        return true;
    }
    return false;
  });

describe("charts of extreme values", () => {
  test("logarithmic charts accept all numbers", { timeout: 30_000 }, async () => {
    const tiny = [1e-3, 1e-9, 0, 1e-300, Number.NaN, 1e-21, 1e-4, Number.POSITIVE_INFINITY, 1e-5];
    const log = (values) => chartScene([{ title: "residual", log: true, columns: [["r", "", values]] }]);
    const { tab, problems } = await open(browser, log(tiny), { before: recordLabels });
    assert.equal(await hasCurve(tab), true);
    const ticks = new Set((await drawnLabels(tab)).filter((t) => /^1e−|^0\.0/.test(t)));
    assert.ok(ticks.size >= 3 && ticks.size <= 8, [...ticks].join(" "));
    for (const [row, value] of [
      [0, 1e-3],
      [3, 1e-300],
      [2, 0],
      [8, 1e-5],
    ]) {
      await setTime(tab, (2 * row) / 8);
      await settle(tab);
      assert.equal(await legendValue(tab, "r"), value);
    }
    assert.deepEqual(problems, []);
    await tab.close();
    for (const values of [
      [1e-300, 1e300],
      [1e-300, 2e-300],
      [0, 0],
      [Number.NaN, -1],
      [1e-22],
      [5e-324, 1],
    ]) {
      const { tab, problems } = await open(browser, log(values));
      assert.equal(await tab.$$eval(".chart", (all) => all.length), 1);
      assert.deepEqual(problems, [], String(values));
      await tab.close();
    }
  });

  test("constant values and single rows are visible and labelled", async () => {
    for (const [values, expected, unexpected] of [
      [[7, 7, 7], "7", "100"],
      [[7], "7", "100"],
      [[0, 0, 0], "−1", "100"],
      [[1e-30, 1e-30], "1e−30", "100"],
      [[3e200, -3e200], "2e200", "100"],
    ]) {
      const scene = chartScene([{ title: "tip: position", columns: [["x", "m", values]] }]);
      const { tab, problems } = await open(browser, scene, { before: recordLabels });
      const found = await drawnLabels(tab);
      assert.ok(found.includes(expected), `${values}: ${found.join(" ")}`);
      assert.ok(!found.includes(unexpected), `${values}: ${found.join(" ")}`);
      assert.equal(await hasCurve(tab), true, String(values));
      assert.deepEqual(problems, []);
      await tab.close();
    }
  });

  test("rounding noise is shown as zero", async () => {
    const scene = chartScene([
      { title: "root: velocity", columns: [["vx", "m/s", [1e-26, -3e-26, 2e-26]]] },
      { title: "tip: velocity", columns: [["vx", "m/s", [0, 1, 0.5]]] },
    ]);
    const { tab, problems } = await open(browser, scene, { before: recordLabels });
    assert.equal(await tab.$eval(".constant li", (e) => e.textContent), "root: velocity: vx 0 m/s");
    const found = await drawnLabels(tab);
    assert.ok(!found.some((t) => /e−/.test(t)), found.join(" "));
    assert.deepEqual(problems, []);
    await tab.close();
  });
});
