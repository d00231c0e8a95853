// Browser pages with a scene, and helpers to inspect them.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";
import { report } from "./container.mjs";

function chromium() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    const found = spawnSync("which", [name], { encoding: "utf8" }).stdout.trim();
    if (found) return found;
  }
  throw new Error("no Chromium found: install one, or set CHROMIUM to its path");
}

/** Temporary folder, removed by `close`. */
export const folder = mkdtempSync(join(tmpdir(), "ancf-viewer-"));

export async function launch() {
  return await puppeteer.launch({
    executablePath: chromium(),
    userDataDir: mkdtempSync(join(folder, "profile-")),
    protocolTimeout: 90_000,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars"],
  });
}

export async function close(browser) {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}

/** Viewports of the tests. */
export const DESKTOP = { width: 1400, height: 900 };
export const PHONE = { width: 400, height: 800 };
let pages = 0;

/**
 * Opens the page of a scene from disk; `before` runs in the page before its scripts.
 * Returns the tab, the errors and warnings of the console, and whether the scene was read.
 */
export async function open(browser, scene, options = {}) {
  const { viewport = DESKTOP, theme = "light", motion = "reduce", html, url, before } = options;
  const tab = await browser.newPage();
  const problems = [];
  tab.on("console", (m) => ["error", "warn"].includes(m.type()) && problems.push(m.text()));
  tab.on("pageerror", (e) => problems.push(String(e)));
  await tab.setViewport(viewport);
  await tab.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: theme },
    { name: "prefers-reduced-motion", value: motion },
  ]);
  if (before) await tab.evaluateOnNewDocument(before);
  let address = url;
  if (!address) {
    const file = join(folder, `page-${pages++}.html`);
    writeFileSync(file, html ?? report(scene));
    address = pathToFileURL(file).href;
  }
  await tab.goto(address);
  const shown = await tab.evaluate(() => window.ancf.ready);
  await settle(tab);
  return { tab, problems, shown };
}

/** Waits until pending changes are drawn. */
export async function settle(tab) {
  await tab.evaluate(
    () =>
      new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))),
  );
}

/** Screenshot of the 3-D view as base64. */
export async function screenshot(tab) {
  await settle(tab);
  const canvas = await tab.$("canvas[tabindex]");
  return Buffer.from(await canvas.screenshot({ type: "png" })).toString("base64");
}

/** Red, green, blue and opacity at points in space. */
export const pixels = (tab, points) =>
  tab.evaluate(
    (list) => window.ancf.pixels(list.map((point) => window.ancf.project(...point) ?? [-1, -1])),
    points,
  );

/** Checks on both sizes that the motion fills the free area of the view and stays within it. */
export async function assertFramed(browser, scene) {
  for (const viewport of [DESKTOP, PHONE]) {
    const { tab } = await open(browser, scene, { viewport });
    await settle(tab);
    const { free, motion } = await tab.evaluate(() => window.ancf.framing());
    const share = Math.max(
      (motion.right - motion.left) / (free.right - free.left),
      (motion.bottom - motion.top) / (free.bottom - free.top),
    );
    assert.ok(share > 0.7 && share < 1.01, `${viewport.width}: ${share}`);
    await tab.close();
  }
}

export const assertNear = (found, expected, tolerance, name) =>
  assert.ok(Math.abs(found - expected) <= tolerance, `${name}: ${found}, expected ${expected}`);
export const currentFrame = (tab) => tab.evaluate(() => window.ancf.frame);
export const currentTime = (tab) => tab.evaluate(() => window.ancf.time);
export const setTime = (tab, t) => tab.evaluate((x) => window.ancf.setTime(x), t);
export const stationPosition = (tab, body, index) =>
  tab.evaluate((b, i) => window.ancf.station(b, i), body, index);

/** Value of a column in the legend of the first chart. */
export const legendValue = (tab, label) =>
  tab.evaluate((name) => {
    const rows = [...document.querySelectorAll(".chart:first-child .u-series")];
    const row = rows.find((r) => r.querySelector(".u-label").textContent.startsWith(name));
    return Number(row.querySelector(".u-value").textContent.replace("−", "-").split(" ")[0]);
  }, label);

/** Plotting area of the first chart in page coordinates. */
export const plotArea = (tab) =>
  tab.evaluate(() => {
    const { left, top, width, height } = document.querySelector(".u-over").getBoundingClientRect();
    return { left, top, width, height };
  });
