// Colours of fields: map and range by sign, range editor, choice of the map, units, ranges of live runs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { close, launch, open, screenshot, setTime, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { modelPage } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

const table = JSON.parse(
  readFileSync(new URL("../../crates/ancf-report/assets/colour_maps.json", import.meta.url), "utf8"),
);
/** Colour at the lower end of a map as CSS. */
const lowest = (map) => {
  const hex = table.maps[map].split(" ")[0];
  return `rgb(${[0, 2, 4].map((i) => Number.parseInt(hex.slice(i, i + 2), 16)).join(", ")})`;
};
const legend = (tab) =>
  tab.evaluate(() => ({
    name: document.querySelector(".legend .name").textContent,
    values: [...document.querySelectorAll(".legend li")].map((e) => Number(e.textContent.replace("−", "-"))),
    gradient: document.querySelector(".legend .bar").style.background,
  }));
/** Types a text into an input and leaves it. */
const type = async (tab, label, text) => {
  await tab.$eval(
    `input[aria-label="${label}"]`,
    (e, value) => {
      e.value = value;
      e.dispatchEvent(new Event("change"));
    },
    text,
  );
  await settle(tab);
};

test("a tension has the sequential map over its whole range, in kilonewtons", async () => {
  const { tab, problems } = await open(browser, null, { html: modelPage("mooring") });
  const { name, values, gradient } = await legend(tab);
  assert.equal(name, "axial force kN");
  assert.ok(values[4] >= 0 && values[0] > 20 && values[0] < 100, values.join(" "));
  assert.ok(gradient.includes(lowest("viridis")), gradient);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("a force of both signs has the diverging map, symmetric about zero", async () => {
  const { tab } = await open(browser, cantilever());
  const { values, gradient } = await legend(tab);
  assert.deepEqual(values, [75, 37.5, 0, -37.5, -75]);
  assert.ok(gradient.includes(lowest("coolwarm")), gradient);
  await tab.close();
});

test("a coil spring opens with the von Mises stress in megapascals", async () => {
  const { tab, problems } = await open(browser, null, { html: modelPage("spring") });
  const options = await tab.$$eval('select[aria-label="colour by"] option', (all) => all.map((e) => e.value));
  for (const name of ["von Mises stress", "shear stress"])
    assert.ok(options.includes(name), options.join(", "));
  const { name, values } = await legend(tab);
  assert.equal(name, "von Mises stress MPa");
  const stress = values[0];
  await tab.select('select[aria-label="colour by"]', "shear stress");
  await settle(tab);
  const shear = (await legend(tab)).values[0];
  // The wire is mainly twisted: the equivalent stress is √3 times the shear stress.
  assert.ok(stress / shear > 1.6 && stress / shear < 1.85, `${stress} and ${shear}`);
  assert.deepEqual(problems, []);
  await tab.close();
});

/** Colour of a beam at half of its length. */
async function bodyPixels(tab) {
  await settle(tab);
  return String(await tab.evaluate(() => window.ancf.pixels([window.ancf.canvasPosition(0, 20)])));
}

test("the range of the colours can be set and reset, and is fixed over time", async () => {
  const scene = cantilever();
  const { tab, problems } = await open(browser, scene);
  await setTime(tab, 0.5);
  for (const key of ["m", "l", "r", "d"]) await tab.keyboard.press(key);
  const before = await bodyPixels(tab);
  await type(tab, "minimum", "-20");
  await type(tab, "maximum", "10");
  assert.deepEqual((await legend(tab)).values, [10, 2.5, -5, -12.5, -20]);
  assert.notEqual(await bodyPixels(tab), before);
  await setTime(tab, 1.5);
  await settle(tab);
  assert.deepEqual((await legend(tab)).values, [10, 2.5, -5, -12.5, -20]);
  await setTime(tab, 0.5);
  await tab.click(".limits button");
  await settle(tab);
  assert.deepEqual((await legend(tab)).values, [75, 37.5, 0, -37.5, -75]);
  assert.equal(await bodyPixels(tab), before);
  await type(tab, "minimum", "5");
  await type(tab, "maximum", "1");
  assert.equal((await legend(tab)).values[4], 5, "a maximum below the minimum is not applied");
  assert.equal(await tab.$eval('input[aria-label="maximum"]', (e) => e.validity.valid), false);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("limits are in the unit of the legend", async () => {
  const { tab } = await open(browser, null, { html: modelPage("mooring") });
  await tab.click("#display-button");
  assert.match(await tab.$eval(".limits", (e) => e.textContent), /range kN/);
  await type(tab, "maximum", "30");
  assert.equal((await legend(tab)).values[0], 30);
  await tab.close();
});

test("the colour map can be selected", async () => {
  const { tab } = await open(browser, cantilever());
  const before = await screenshot(tab);
  const names = await tab.$$eval('select[aria-label="colour map"] option', (all) => all.map((e) => e.value));
  assert.deepEqual(names, ["", ...Object.keys(table.maps)]);
  await tab.select('select[aria-label="colour map"]', "plasma");
  await settle(tab);
  assert.ok((await legend(tab)).gradient.includes(lowest("plasma")));
  assert.notEqual(await screenshot(tab), before);
  await tab.close();
});

test("the range of a live run keeps earlier extremes", async () => {
  const entry = join(import.meta.dirname, "../src/scene/fields.ts");
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, format: "esm", write: false });
  const address = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  const { colourScale, keepRanges } = await import(address);
  const scene = (low, high) => ({
    fields: [{ name: "axial force", unit: "N", diverging: true, range: [low, high] }],
  });
  const settings = { colourMap: "", limits: {} };
  const [first, second, third] = [scene(-13, 41.8), scene(-2, 13.4), scene(-1, 12)];
  keepRanges(second, first);
  keepRanges(third, second);
  const { low, high } = colourScale(third.fields[0], settings);
  assert.deepEqual([low, high], [-41.8, 41.8]);
});
