// Themes, small screens, large models, live runs, and the committed bundle.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { manyBeams } from "./support/beams.mjs";
import { close, folder, launch, open, screenshot, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { pack, page } from "./support/container.mjs";
import { machine } from "./support/machine.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

const background = (tab) => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
const isBright = (colour) =>
  colour
    .match(/\d+/g)
    .map(Number)
    .reduce((a, b) => a + b) > 380;

test("the theme is that of the system, and the button changes it", async () => {
  for (const theme of ["dark", "light"]) {
    const { tab, problems } = await open(browser, cantilever(), { theme });
    assert.equal(isBright(await background(tab)), theme === "light", theme);
    await tab.click('[aria-label^="Dark or light"]');
    assert.equal(isBright(await background(tab)), theme !== "light", `not ${theme}`);
    await tab.evaluate(() => localStorage.clear());
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("the page fits a phone, with buttons of at least 40 px", async () => {
  const viewport = { width: 390, height: 844, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
  const { tab } = await open(browser, machine(), { viewport });
  const wide = await tab.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(wide[0] <= wide[1], `${wide}`);
  await tab.click("#display-button");
  const small = await tab.$$eval("button, select", (all) =>
    all
      .filter((e) => e.offsetParent && e.getBoundingClientRect().height < 40)
      .map((e) => e.getAttribute("aria-label") ?? e.textContent),
  );
  assert.deepEqual(small, []);
  await tab.close();
});

test("every control has an accessible name", async () => {
  const { tab } = await open(browser, machine());
  const nameless = await tab.$$eval("button, select, input, canvas[tabindex]", (all) =>
    all
      .filter(
        (e) => !e.getAttribute("aria-label") && !e.textContent.trim() && !e.labels?.[0]?.textContent.trim(),
      )
      .map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
  await tab.close();
});

test("a frame of 100 000 stations uploads no data", async () => {
  const before = () => {
    window.bytes = 0;
    window.spent = [];
    const size = (list) => {
      for (const a of list) {
        if (ArrayBuffer.isView(a) || a instanceof ArrayBuffer) window.bytes += a.byteLength;
      }
    };
    for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D", "texImage3D"]) {
      const original = WebGL2RenderingContext.prototype[name];
      WebGL2RenderingContext.prototype[name] = function (...a) {
        size(a);
        return original.apply(this, a);
      };
    }
    window.draws = 0;
    const draw = WebGL2RenderingContext.prototype.drawElementsInstanced;
    WebGL2RenderingContext.prototype.drawElementsInstanced = function (...a) {
      window.draws += 1;
      return draw.apply(this, a);
    };
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) =>
      request.call(window, (now) => {
        const [start, drawn] = [performance.now(), window.draws];
        callback(now);
        if (window.draws > drawn) window.spent.push(performance.now() - start);
      });
  };
  const { tab, problems } = await open(browser, manyBeams(100, 1000), { before });
  const uploaded = await tab.evaluate(() => window.bytes);
  assert.ok(uploaded > 3 * 100_000 * 16, `${uploaded} bytes at the start`);
  const first = await screenshot(tab);
  await tab.evaluate(() => {
    window.bytes = 0;
    window.spent = [];
  });
  for (const t of [0.3, 0.7, 1.1, 1.6, 2]) {
    await tab.evaluate((x) => window.ancf.setTime(x), t);
    await settle(tab);
  }
  assert.notEqual(await screenshot(tab), first);
  const [bytes, spent] = await tab.evaluate(() => [window.bytes, window.spent]);
  assert.equal(bytes, 0);
  spent.sort((a, b) => a - b);
  console.log(
    `    CPU time of a frame: median ${spent[spent.length >> 1].toFixed(2)} ms, ${spent.length} frames`,
  );
  assert.deepEqual(problems, []);
  await tab.close();
});

test("a frame of 100 000 vertices has few draw calls and changes of the page, and reads no layout", async () => {
  const before = () => {
    window.counts = { draws: 0, bytes: 0, layouts: 0, changes: 0, frames: 0 };
    const { counts } = window;
    const count = (prototype, name, key) => {
      const original = prototype[name];
      prototype[name] = function (...a) {
        counts[key] += key === "bytes" ? a.reduce((sum, x) => sum + (x?.byteLength ?? 0), 0) : 1;
        return original.apply(this, a);
      };
    };
    for (const name of ["drawElements", "drawElementsInstanced", "drawArrays"])
      count(WebGL2RenderingContext.prototype, name, "draws");
    for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D"])
      count(WebGL2RenderingContext.prototype, name, "bytes");
    count(Element.prototype, "getBoundingClientRect", "layouts");
  };
  // 100 beams with 40 stations and 24 corners of the section.
  const { tab, problems } = await open(browser, manyBeams(100, 40, 30), { before });
  await tab.evaluate(() => {
    Object.assign(window.counts, { draws: 0, bytes: 0, layouts: 0, changes: 0 });
    const observer = new MutationObserver((records) => {
      window.counts.changes += records.length;
    });
    const all = { subtree: true, childList: true, attributes: true, characterData: true };
    observer.observe(document.body, all);
  });
  const frames = 10;
  for (let i = 0; i < frames; i++) {
    await tab.evaluate((x) => window.ancf.setTime(x), (29 * (i + 0.5)) / frames);
    await settle(tab);
  }
  const { draws, bytes, layouts, changes } = await tab.evaluate(() => window.counts);
  assert.equal(bytes, 0);
  assert.equal(layouts, 0);
  assert.ok(draws > 0 && draws <= 12 * frames, `${draws / frames} draw calls per frame`);
  assert.ok(changes <= 60 * frames, `${changes / frames} changes of the page per frame`);
  assert.deepEqual(problems, []);
  await tab.close();
});

test("a live run is followed, at the end if the time was at the end", async () => {
  let scene = cantilever({ frames: 11, until: 0.5, live: true });
  let [version, answers, unchanged] = [1, 0, 0];
  const server = createServer((request, response) => {
    if (request.url !== "/scene") {
      response.setHeader("Content-Type", "text/html");
      return response.end(page("", "/scene"));
    }
    answers += 1;
    const tag = `"${version}"`;
    response.setHeader("ETag", tag);
    if (request.headers["if-none-match"] === tag) {
      unchanged += 1;
      response.statusCode = 304;
      return response.end();
    }
    return response.end(gzipSync(pack(scene)));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const url = `http://127.0.0.1:${server.address().port}/`;
  const { tab, problems } = await open(browser, null, { url });
  assert.equal(await tab.evaluate(() => window.ancf.time), 0.5);
  assert.match(await tab.$eval(".outcome", (e) => e.textContent), /running/);
  await new Promise((done) => setTimeout(done, 2500));
  assert.ok(unchanged >= 1 && answers <= 4, `${answers} requests, ${unchanged} unchanged`);
  [scene, version] = [cantilever({ frames: 21, until: 1, live: true }), 2];
  await tab.waitForFunction(() => window.ancf.time === 1, { timeout: 8000 });
  await settle(tab);
  const { free, motion } = await tab.evaluate(() => window.ancf.framing());
  const fits = motion.left >= free.left && motion.right <= free.right && motion.bottom <= free.bottom;
  assert.ok(fits, `the new motion is framed: ${JSON.stringify({ free, motion })}`);
  await tab.evaluate(() => window.ancf.setTime(0.25));
  await tab.keyboard.press("g");
  [scene, version] = [cantilever(), 3];
  await tab.waitForFunction(() => document.querySelector(".outcome").textContent === "finished", {
    timeout: 8000,
  });
  const now = await tab.evaluate(() => window.ancf.time);
  assert.ok(Math.abs(now - 0.25) < 1e-9, `the time is kept: ${now}`);
  const before = answers;
  await new Promise((done) => setTimeout(done, 1500));
  assert.equal(answers, before, "no requests after the end of the run");
  assert.ok((await tab.evaluate(() => window.ancf.coverage())) > 0.01);
  assert.deepEqual(problems, []);
  await tab.close();
  server.closeAllConnections();
  server.close();
});

test("the committed bundle equals a fresh build", () => {
  const out = mkdtempSync(join(folder, "bundle-"));
  const build = fileURLToPath(new URL("../build.mjs", import.meta.url));
  const run = spawnSync(process.execPath, [build, out], { encoding: "utf8" });
  assert.equal(run.status, 0, run.stderr);
  for (const name of ["viewer.js", "viewer.css"]) {
    const committed = readFileSync(
      new URL(`../../crates/ancf-report/assets/${name}`, import.meta.url),
      "utf8",
    );
    assert.ok(readFileSync(join(out, name), "utf8") === committed, `${name} is outdated: run npm run build`);
    assert.ok(!/<\/script|<!--/i.test(committed), `${name} would end its HTML element`);
    assert.match(committed, /uplot .*\(MIT\)/i);
  }
});
