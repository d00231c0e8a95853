// Charts, and what is saved.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { browse, close, goTo, legend, near, open, place, plotBox, settle, time } from "./browser.mjs";
import { f64 } from "./container.mjs";
import { cantilever, tip } from "./scenes.mjs";

let browser;
before(async () => {
  browser = await browse();
});
after(() => close(browser));

describe("what is saved", () => {
  /** Blobs that the page would hand to the browser to save. */
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

  test("a picture, and the model's text", async () => {
    const { tab, complaints } = await open(browser, cantilever(), { before });
    const [type, size] = await saved(tab, () => tab.click('[aria-label="Save picture"]'));
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
    assert.deepEqual(complaints, []);
    await tab.close();
  });

  test("a film of the whole run", async () => {
    const { tab, complaints } = await open(browser, cantilever({ frames: 6, until: 0.5 }), { before });
    for (let i = 0; i < 3; i++) await tab.keyboard.press("+");
    const [type, size] = await saved(tab, () => tab.click('[aria-label="Save film"]'));
    assert.match(type, /^video\//);
    assert.ok(size > 1000, `${size} bytes`);
    assert.equal(await time(tab), 0.5);
    assert.deepEqual(complaints, []);
    await tab.close();
  });
});

describe("charts", () => {
  test("answer to the pointer with the values there", async () => {
    const { tab } = await open(browser, cantilever());
    const { left, top, width, height } = await plotBox(tab);
    await tab.mouse.move(left + 0.375 * width, top + height / 2);
    await settle(tab);
    near(await legend(tab, "y"), tip(0.75), 5e-3, "y");
    near(await legend(tab, "z"), 0.075, 2e-3, "z");
    await tab.close();
  });

  test("a click sets the time, a drag goes on setting it", async () => {
    const { tab } = await open(browser, cantilever());
    const { left, top, width, height } = await plotBox(tab);
    await tab.mouse.click(left + 0.25 * width, top + height / 2);
    near(await time(tab), 0.5, 0.01, "time");
    near((await place(tab, 0, 40))[1], tip(0.5), 1e-3, "tip");
    await tab.mouse.down();
    await tab.mouse.move(left + 0.75 * width, top + height / 2, { steps: 4 });
    await tab.mouse.up();
    near(await time(tab), 1.5, 0.01, "time");
    await tab.close();
  });

  test("show the values of the time that the picture shows", async () => {
    const { tab } = await open(browser, cantilever());
    await goTo(tab, 1.25);
    await settle(tab);
    near(await legend(tab, "y"), tip(1.25), 1e-3, "y");
    await goTo(tab, 1.75);
    await settle(tab);
    assert.ok(Number.isNaN(await legend(tab, "z")), "no number, no value");
    await tab.close();
  });

  test("come in groups, with a logarithmic axis where asked", async () => {
    const { tab, complaints } = await open(browser, cantilever());
    await tab.click('[data-group="solver"]');
    const titles = await tab.$$eval(".chart h3", (all) => all.map((e) => e.firstChild.textContent));
    assert.deepEqual(titles, ["step size", "iterations"]);
    assert.match(await tab.$eval(".chart", (e) => e.textContent), /logarithmic/);
    await goTo(tab, 0.5);
    await tab.click('[data-group="energy"]');
    await settle(tab);
    near(await legend(tab, "strain"), 9, 1e-3, "the values of the time are there at once");
    assert.equal(await tab.$eval(".now", (e) => e.hidden), false);
    assert.deepEqual(complaints, []);
    await tab.close();
  });
});

/** A run with a few rows whose charts have these columns, [label, unit, numbers]. */
function rows(charts) {
  const count = charts[0].columns[0][2].length;
  const times = Array.from({ length: count }, (_, i) => (count > 1 ? (2 * i) / (count - 1) : 0));
  return {
    ...cantilever({ frames: 3 }),
    abscissa: { name: "t", unit: "s", values: f64(times) },
    charts: charts.map(({ title, columns, log = false }) => ({
      ...{ title, group: "probes", log },
      columns: columns.map(([label, unit, values]) => ({ name: label, label, unit, values: f64(values) })),
    })),
  };
}

/** What is written at the axes of charts: the page's canvases tell it as they write. */
const written = () => {
  window.written = [];
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
    window.written.push(text);
    return fillText.call(this, text, ...more);
  };
};
const texts = (tab) => tab.evaluate(() => window.written);
/** Whether the first chart has ink of its first colour. */
const inked = (tab) =>
  tab.evaluate(() => {
    const canvas = document.querySelector(".chart canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    for (let i = 0; i < data.length; i += 4) {
      if (Math.abs(data[i] - 63) + Math.abs(data[i + 1] - 134) + Math.abs(data[i + 2] - 208) < 12)
        return true;
    }
    return false;
  });

describe("charts of numbers that are hard to draw", () => {
  test("logarithmic ones of any numbers", { timeout: 30_000 }, async () => {
    const tiny = [1e-3, 1e-9, 0, 1e-300, Number.NaN, 1e-21, 1e-4, Number.POSITIVE_INFINITY, 1e-5];
    const log = (values) => rows([{ title: "residual", log: true, columns: [["r", "", values]] }]);
    const { tab, complaints } = await open(browser, log(tiny), { before: written });
    assert.equal(await inked(tab), true);
    const ticks = new Set((await texts(tab)).filter((t) => /^1e−|^0\.0/.test(t)));
    assert.ok(ticks.size >= 3 && ticks.size <= 8, [...ticks].join(" "));
    for (const [row, value] of [
      [0, 1e-3],
      [3, 1e-300],
      [2, 0],
      [8, 1e-5],
    ]) {
      await goTo(tab, (2 * row) / 8);
      await settle(tab);
      assert.equal(await legend(tab, "r"), value);
    }
    assert.deepEqual(complaints, []);
    await tab.close();
    for (const values of [
      [1e-300, 1e300],
      [1e-300, 2e-300],
      [0, 0],
      [Number.NaN, -1],
      [1e-22],
      [5e-324, 1],
    ]) {
      const { tab, complaints } = await open(browser, log(values));
      assert.equal(await tab.$$eval(".chart", (all) => all.length), 1);
      assert.deepEqual(complaints, [], String(values));
      await tab.close();
    }
  });

  test("constant ones and ones of one row show where the value is", async () => {
    for (const [values, wanted, foreign] of [
      [[7, 7, 7], "7", "100"],
      [[7], "7", "100"],
      [[0, 0, 0], "−1", "100"],
      [[1e-30, 1e-30], "1e−30", "100"],
      [[3e200, -3e200], "2e200", "100"],
    ]) {
      const scene = rows([{ title: "tip: position", columns: [["x", "m", values]] }]);
      const { tab, complaints } = await open(browser, scene, { before: written });
      const found = await texts(tab);
      assert.ok(found.includes(wanted), `${values}: ${found.join(" ")}`);
      assert.ok(!found.includes(foreign), `${values}: ${found.join(" ")}`);
      assert.equal(await inked(tab), true, String(values));
      assert.deepEqual(complaints, []);
      await tab.close();
    }
  });

  test("rounding noise is zero beside numbers of its kind", async () => {
    const scene = rows([
      { title: "root: velocity", columns: [["vx", "m/s", [1e-26, -3e-26, 2e-26]]] },
      { title: "tip: velocity", columns: [["vx", "m/s", [0, 1, 0.5]]] },
    ]);
    const { tab, complaints } = await open(browser, scene, { before: written });
    await goTo(tab, 1);
    await settle(tab);
    assert.equal(await legend(tab, "vx"), 0);
    const found = await texts(tab);
    assert.ok(!found.some((t) => /e−/.test(t)), found.join(" "));
    assert.deepEqual(complaints, []);
    await tab.close();
  });
});
