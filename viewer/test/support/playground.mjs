// The built playground behind a web server, and helpers for its page.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { root } from "./models.mjs";

export const folder = join(root, "target/playground");

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

/** Starts a server of the folder; returns its address and `close`. */
export async function serve() {
  assert.ok(existsSync(join(folder, "index.html")), "no playground; run: cargo xtask playground");
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(folder, path === "/" ? "index.html" : path);
    if (!existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "text/plain" });
    response.end(readFileSync(file));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const close = () => {
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  return { address: `http://127.0.0.1:${server.address().port}/`, close };
}

/** Opens the page of a fragment and waits for the end of the first run. */
export async function openPlayground(browser, address, { fragment = "", viewport, theme = "light" } = {}) {
  const tab = await browser.newPage();
  const problems = [];
  tab.on("console", (m) => ["error", "warn"].includes(m.type()) && problems.push(m.text()));
  tab.on("pageerror", (e) => problems.push(String(e)));
  await tab.setViewport(viewport);
  await tab.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: theme },
    { name: "prefers-reduced-motion", value: "reduce" },
  ]);
  await tab.goto(`${address}${fragment}`);
  await ended(tab);
  return { tab, problems };
}

export const status = (tab) => tab.$eval("#status", (e) => e.textContent);

/** Waits for the end of a run, and returns the status. */
export async function ended(tab) {
  await tab.waitForFunction(() => !/loading|running/.test(document.getElementById("status").textContent), {
    timeout: 60_000,
  });
  return status(tab);
}

/** The window of the viewer. */
export async function viewerOf(tab) {
  const frame = await (await tab.waitForSelector("#stage iframe")).contentFrame();
  await frame.waitForFunction(() => window.ancf, { timeout: 30_000 });
  assert.equal(await frame.evaluate(() => window.ancf.ready), true);
  return frame;
}

/** Replaces the text of the editor. */
export const setText = (tab, text) =>
  tab.evaluate((value) => {
    window.playground.text = value;
  }, text);
export const getText = (tab) => tab.evaluate(() => window.playground.text);

/** Table of the last run. */
export const table = (tab) => tab.evaluate(() => window.playground.csv);
