// Statics and modes: initial state, reactions, list of the modes.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, currentTime, launch, open, settle } from "./support/browser.mjs";
import { modelPage } from "./support/models.mjs";
import { frequencies } from "./support/shapes.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

test("statics open at the last state with a table of its reactions", async () => {
  const html = modelPage("mooring");
  for (const motion of ["reduce", "no-preference"]) {
    const viewport = motion === "reduce" ? { width: 400, height: 800 } : { width: 1400, height: 900 };
    const { tab, problems } = await open(browser, null, { html, motion, viewport });
    assert.equal(await currentTime(tab), 1, motion);
    assert.equal(await tab.evaluate(() => window.ancf.playing), false, motion);
    const rows = await tab.$$eval(".reactions tbody tr", (all) =>
      all.map((row) => [...row.children].map((e) => e.textContent.replace("−", "-"))),
    );
    assert.deepEqual(
      rows.map(([name]) => name),
      ["anchor", "fairlead"],
    );
    for (const [, size, x, y, z] of rows) {
      const sum = Math.hypot(Number(x), Number(y), Number(z));
      assert.ok(Math.abs(sum / Number(size) - 1) < 1e-3, `${size} of ${[x, y, z]}`);
    }
    assert.equal(await tab.$eval(".reactions h2", (e) => e.textContent), "Forces kN");
    const label = await tab.$$eval(".labels > div", (all) => all.map((e) => e.textContent).join("\n"));
    assert.ok(label.includes(`fairleadF ${rows[1][1]} kN`), label);
    assert.match(await tab.$eval(".reactions", (e) => e.textContent), /load = 1/);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("the table of reactions follows the state", async () => {
  const { tab } = await open(browser, null, { html: modelPage("robot_arm") });
  await tab.click("#tab-Reactions");
  await settle(tab);
  const cell = () => tab.$eval(".reactions tbody td", (e) => e.textContent);
  const first = await cell();
  assert.notEqual(first, "");
  await tab.evaluate(() => window.ancf.setTime(1));
  await settle(tab);
  assert.notEqual(await cell(), first);
  await tab.close();
});

test("rigid-body modes are folded, and selected by their own buttons", async () => {
  const { tab } = await open(browser, frequencies());
  assert.equal(await tab.$eval(".rigid-modes", (e) => e.open), false);
  assert.match(await tab.$eval(".rigid-modes summary", (e) => e.textContent), /^1 rigid-body mode$/);
  const pressed = () => tab.$eval('.shape-button[aria-pressed="true"]', (e) => e.textContent);
  assert.match(await pressed(), /^mode 2/);
  await tab.click(".rigid-modes summary");
  await tab.click(".rigid-modes button");
  await settle(tab);
  assert.match(await pressed(), /^mode 1: rigid/);
  await tab.click(".rigid-modes summary");
  await tab.keyboard.press("End");
  await settle(tab);
  await tab.keyboard.press("Home");
  await settle(tab);
  assert.equal(await tab.$eval(".rigid-modes", (e) => e.open), true, "the list of the current mode is open");
  await tab.close();
});

test("displacements of modes have no unit", async () => {
  const { tab } = await open(browser, null, { html: modelPage("tuning_fork") });
  assert.equal(await tab.$eval(".legend .name", (e) => e.textContent.trim()), "relative displacement");
  assert.match(await tab.$eval(".rigid-modes summary", (e) => e.textContent), /6 rigid-body modes/);
  await tab.close();
});
