// Selection, order and axes of the charts; switches, export and text alternatives.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { close, DESKTOP, launch, open, PHONE, plotArea, settle } from "./support/browser.mjs";
import { chartScene } from "./support/charts.mjs";
import { modelPage } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

const titles = (tab) => tab.$$eval(".chart h2", (all) => all.map((e) => e.firstChild.textContent));
const leftEdges = (tab) => tab.$$eval(".u-over", (all) => all.map((e) => e.getBoundingClientRect().left));
/** Numbers of `count` rows. */
const rows = (count, value) => Array.from({ length: count }, (_, i) => value(i / (count - 1)));

/** Labels of the vertical axis of the first chart, largest first. */
const recordTicks = () => {
  window.ticks = new Map();
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
    const list = window.ticks.get(this.canvas) ?? [];
    window.ticks.set(this.canvas, [...list, text]);
    return fillText.call(this, text, ...more);
  };
};
const firstTicks = (tab) =>
  tab.evaluate(() =>
    window.ticks.get(document.querySelector(".chart canvas")).map((t) => t.replace("−", "-")),
  );

test("the first charts of the blade vary, those of its root are listed as constant", async () => {
  const html = modelPage("blade");
  for (const [viewport, theme] of [
    [DESKTOP, "light"],
    [PHONE, "dark"],
  ]) {
    const { tab, problems } = await open(browser, null, { html, viewport, theme });
    const found = await titles(tab);
    assert.match(found[0], /^tip: /);
    assert.ok(!found.some((t) => /^root: (position|velocity|acceleration)/.test(t)), found.join(", "));
    assert.match(await tab.$eval(".constant", (e) => e.textContent), /root: position/);
    const edges = await leftEdges(tab);
    assert.ok(edges.length >= 3);
    assert.ok(Math.max(...edges) - Math.min(...edges) < 1, edges.join(" "));
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("left edges are equal for labels of different length", async () => {
  const charts = ["a", "b", "c"].map((name, i) => ({
    title: `${name}: position`,
    columns: [
      ["x", ["rad", "1/s", "kg"][i], rows(50, (s) => [1, 12345.678, 1e-7][i] * (s + [0, 100, 0][i]))],
    ],
  }));
  const { tab } = await open(browser, chartScene(charts));
  const edges = await leftEdges(tab);
  assert.equal(edges.length, 3);
  assert.ok(Math.max(...edges) - Math.min(...edges) < 1, edges.join(" "));
  await tab.close();
});

test("columns without variation are not drawn but listed", async () => {
  const columns = [
    ["x", "m", rows(50, (s) => Math.sin(6 * s))],
    ["y", "m", rows(50, () => 0.25)],
    ["z", "m", rows(50, (s) => 1e-9 * (1 + s))],
    ["w", "m", rows(50, () => Number.NaN)],
  ];
  const { tab } = await open(browser, chartScene([{ title: "tip: position", columns }]));
  const legend = await tab.$$eval(".u-series .u-label", (all) => all.map((e) => e.textContent));
  assert.deepEqual(legend, ["t", "x"]);
  assert.match(await tab.$eval(".chart", (e) => e.textContent), /constant: y 0\.25 m, z 0 mTable/);
  await tab.close();
});

test("a curve that would be flat has axes of its own", async () => {
  const columns = [
    ["x", "m", rows(50, (s) => Math.sin(6 * s))],
    ["y", "m", rows(50, (s) => Math.cos(6 * s))],
    ["z", "m", rows(50, (s) => 0.002 * s)],
  ];
  const { tab } = await open(browser, chartScene([{ title: "tip: position", columns }]));
  const panels = await tab.$$eval(".plot", (all) =>
    all.map((p) => [
      p.querySelector(".panel-unit").textContent,
      [...p.querySelectorAll(".u-series .u-label")].map((e) => e.textContent).join(" "),
    ]),
  );
  assert.deepEqual(panels, [
    ["m", "t x y"],
    ["mm", "t z"],
  ]);
  await tab.close();
  const energies = await open(browser, chartScene([{ title: "energy", group: "energy", columns }]));
  assert.equal((await energies.tab.$$(".plot")).length, 1, "energies are compared on common axes");
  await energies.tab.close();
});

test("a spike at the start does not set the range", async () => {
  const values = rows(400, (s) => (s < 0.01 ? 50 : 3 * Math.sin(9 * s)));
  const scene = chartScene([{ title: "tip: acceleration", columns: [["ax", "m/s²", values]] }]);
  const { tab } = await open(browser, scene, { before: recordTicks });
  const largest = (ticks) => Math.max(...ticks.map(Number).filter(Number.isFinite));
  assert.ok(largest(await firstTicks(tab)) < 10, (await firstTicks(tab)).join(" "));
  assert.match(await tab.$eval(".chart", (e) => e.textContent), /spike at the start/);
  const button = await tab.waitForSelector("button.small ::-p-text(Full range)");
  await button.click();
  await settle(tab);
  assert.ok(largest(await firstTicks(tab)) >= 40, (await firstTicks(tab)).join(" "));
  assert.equal(await tab.evaluate(() => document.activeElement.textContent), "Full range");
  assert.equal(await tab.evaluate(() => document.activeElement.getAttribute("aria-pressed")), "true");
  await tab.close();
});

test("the logarithmic switch draws magnitudes", async () => {
  const values = rows(100, (s) => 10 ** (-4 * s) * (s < 0.5 ? 1 : -1));
  const scene = chartScene([{ title: "drift", columns: [["d", "m", values]] }]);
  const { tab } = await open(browser, scene, { before: recordTicks });
  const button = await tab.waitForSelector("button.small ::-p-text(Log)");
  await button.click();
  await settle(tab);
  assert.match(await tab.$eval(".chart", (e) => e.textContent), /logarithm of magnitudes/);
  const ticks = await firstTicks(tab);
  for (const text of ["0.01", "0.1"]) assert.ok(ticks.includes(text), ticks.join(" "));
  await tab.close();
});

test("a chart is saved as CSV", async () => {
  const before = () => {
    URL.createObjectURL = (blob) => {
      blob.text().then((text) => {
        window.csv = text;
      });
      return "data:,";
    };
    HTMLAnchorElement.prototype.click = function () {
      window.file = this.download;
    };
  };
  const columns = [
    ["tip.x", "m", [1, 2, 4]],
    ["tip.y", "m", [5, 5, 5]],
  ];
  const { tab } = await open(browser, chartScene([{ title: "tip: position", columns }]), { before });
  const button = await tab.waitForSelector("button.small ::-p-text(CSV)");
  await button.click();
  await tab.waitForFunction(() => window.csv);
  assert.equal(await tab.evaluate(() => window.csv), "t [s],tip.x [m],tip.y [m]\n0,1,5\n1,2,5\n2,4,5\n");
  assert.equal(await tab.evaluate(() => window.file), "tip_position.csv");
  await tab.close();
});

test("charts have a description and a table", async () => {
  const columns = [["x", "m", [0, 0.5, -0.25]]];
  const { tab } = await open(browser, chartScene([{ title: "tip: position", columns }]));
  assert.equal(
    await tab.$eval(".chart canvas", (e) => `${e.getAttribute("role")} ${e.getAttribute("aria-label")}`),
    "img tip: position: x from −0.25 m to 0.5 m",
  );
  await tab.click(".chart-table summary");
  await tab.waitForSelector(".chart-table tbody tr");
  assert.deepEqual(await tab.$$eval(".chart-table tbody tr > *", (all) => all.map((e) => e.textContent)), [
    "x",
    "0 m",
    "−0.25 m",
    "−0.25 m t = 2 s",
    "0.5 m t = 1 s",
  ]);
  await tab.close();
});

test("the cursors of all charts are at the same abscissa", async () => {
  const chart = (name, factor) => ({
    title: `${name}: position`,
    columns: [["x", "rad", rows(50, (s) => factor * Math.sin(6 * s))]],
  });
  const { tab } = await open(browser, chartScene([chart("a", 1), chart("b", 98765)]));
  const { left, top, width, height } = await plotArea(tab);
  await tab.mouse.move(left + 0.4 * width, top + 0.5 * height);
  await settle(tab);
  const cursors = await tab.$$eval(".u-cursor-x", (all) =>
    all.map((e) => [e.classList.contains("u-off"), e.getBoundingClientRect().left]),
  );
  assert.equal(cursors.length, 2);
  for (const [off, at] of cursors) {
    assert.equal(off, false);
    assert.ok(Math.abs(at - left - 0.4 * width) <= 1.5, `${at}`);
  }
  await tab.close();
});

test("axes have SI prefixes", async () => {
  const columns = [["kinetic", "J", rows(50, (s) => 4e4 * s)]];
  const { tab } = await open(browser, chartScene([{ title: "energy", group: "energy", columns }]), {
    before: recordTicks,
  });
  assert.equal(await tab.$eval(".chart h2", (e) => e.textContent), "energy kJ");
  assert.ok((await firstTicks(tab)).includes("20"), (await firstTicks(tab)).join(" "));
  await tab.close();
});

test("colours of curves are distinct", async () => {
  const entry = join(import.meta.dirname, "../src/base/colours.ts");
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, format: "esm", write: false });
  const address = `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`;
  const { PALETTE } = await import(address);
  const lab = PALETTE.map(oklab);
  for (const [i, a] of lab.entries()) {
    for (const [j, b] of lab.slice(0, i).entries()) {
      const difference = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      assert.ok(difference > 0.1, `colours ${j} and ${i}: ${difference.toFixed(3)}`);
    }
  }
});

/** OKLab coordinates of a colour (Ottosson, 2020). */
function oklab(rgb) {
  const [r, g, b] = rgb.map((c) => (c <= 10 ? c / 3295 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}
