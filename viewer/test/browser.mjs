// A browser with a page of a scene, and everything it complained about.

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
  throw new Error("no Chromium: set CHROMIUM to its path");
}

export const folder = mkdtempSync(join(tmpdir(), "ancf-viewer-"));

export async function browse() {
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

const DESKTOP = { width: 1280, height: 800 };
let pages = 0;

/** Opens the page of a scene from disk; `before` runs in the page before its scripts. */
export async function open(browser, scene, options = {}) {
  const { viewport = DESKTOP, theme = "light", motion = "reduce", html, url, before } = options;
  const tab = await browser.newPage();
  const complaints = [];
  tab.on("console", (m) => ["error", "warn"].includes(m.type()) && complaints.push(m.text()));
  tab.on("pageerror", (e) => complaints.push(String(e)));
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
  return { tab, complaints, shown };
}

/** Waits until what was asked for is drawn. */
export async function settle(tab) {
  await tab.evaluate(
    () =>
      new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))),
  );
}

/** The picture as it is on the screen, in bytes of a PNG. */
export async function picture(tab) {
  await settle(tab);
  const stage = await tab.$("canvas[tabindex]");
  return Buffer.from(await stage.screenshot({ type: "png" })).toString("base64");
}

export const near = (found, wanted, by, what) =>
  assert.ok(Math.abs(found - wanted) <= by, `${what}: ${found}, not ${wanted}`);
export const frame = (tab) => tab.evaluate(() => window.ancf.frame);
export const time = (tab) => tab.evaluate(() => window.ancf.time);
export const goTo = (tab, t) => tab.evaluate((x) => window.ancf.setTime(x), t);
export const place = (tab, body, index) => tab.evaluate((b, i) => window.ancf.station(b, i), body, index);

/** Value that the legend of the first chart shows for a column. */
export const legend = (tab, label) =>
  tab.evaluate((name) => {
    const rows = [...document.querySelectorAll(".chart:first-child .u-series")];
    const row = rows.find((r) => r.querySelector(".u-label").textContent.startsWith(name));
    return Number(row.querySelector(".u-value").textContent.replace("−", "-").split(" ")[0]);
  }, label);

export const plotBox = (tab) =>
  tab.evaluate(() => {
    const { left, top, width, height } = document.querySelector(".u-over").getBoundingClientRect();
    return { left, top, width, height };
  });
