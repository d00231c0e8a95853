// Accessibility by axe-core: no violations on both sizes, dark and light.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { close, launch, open, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { machine } from "./support/machine.mjs";
import { modelPage } from "./support/models.mjs";
import { frequencies } from "./support/shapes.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

/** Violations with their elements, as text. */
async function violations(tab) {
  await settle(tab);
  await tab.evaluate(AXE);
  return await tab.evaluate(async () => {
    const { violations, passes } = await window.axe.run(document);
    if (!passes.some((rule) => rule.id === "color-contrast")) return ["the contrast was not examined"];
    return violations.flatMap(({ id, nodes }) =>
      nodes.map((n) => `${id}: ${n.html.slice(0, 160)} ${n.any.map((c) => c.message).join(" ")}`),
    );
  });
}

const SIZES = [
  { width: 1400, height: 900 },
  { width: 400, height: 800 },
];

/** Name, page and actions after which the page is checked. */
const STATES = [
  ["charts", () => ({ scene: cantilever() }), [".chart-table summary", "#display-button"]],
  ["failed run", () => ({ scene: machine() }), ["#tab-Run", ".run summary"]],
  ["modes", () => ({ scene: frequencies() }), [".rigid-modes summary"]],
  ["statics", () => ({ html: modelPage("mooring") }), ["#tab-Reactions"]],
  ["constant charts", () => ({ html: modelPage("blade") }), [".constant summary"]],
];

for (const [name, source, clicks] of STATES) {
  test(`no violations: ${name}`, async () => {
    const { scene = null, html } = source();
    for (const viewport of SIZES) {
      for (const theme of ["light", "dark"]) {
        const { tab } = await open(browser, scene, { viewport, theme, ...(html ? { html } : {}) });
        assert.deepEqual(await violations(tab), [], `${viewport.width} px, ${theme}`);
        for (const selector of clicks) {
          await tab.click(selector);
          assert.deepEqual(await violations(tab), [], `${viewport.width} px, ${theme}, ${selector}`);
        }
        await tab.close();
      }
    }
  });
}

test("no violations: help dialog", async () => {
  const { tab } = await open(browser, cantilever());
  await tab.keyboard.press("?");
  assert.deepEqual(await violations(tab), []);
  await tab.close();
});

test("accessible names of buttons contain their visible text", async () => {
  const { tab } = await open(browser, cantilever());
  const wrong = await tab.$$eval("button[aria-label]", (all) =>
    all
      .filter((b) => !b.getAttribute("aria-label").toLowerCase().includes(b.textContent.trim().toLowerCase()))
      .map((b) => b.outerHTML),
  );
  assert.deepEqual(wrong, []);
  await tab.close();
});

test("headings descend by one level", async () => {
  const { tab } = await open(browser, cantilever());
  const levels = await tab.$$eval("h1, h2, h3, h4, h5, h6", (all) =>
    all.filter((e) => e.checkVisibility()).map((e) => Number(e.tagName[1])),
  );
  assert.equal(levels[0], 1);
  levels.slice(1).forEach((level, i) => {
    assert.ok(level <= levels[i] + 1, levels.join(" "));
  });
  await tab.close();
});
