// Charts, and what is saved.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { browse, close, goTo, legend, near, open, place, plotBox, settle, time } from "./browser.mjs";
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
