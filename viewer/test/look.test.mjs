// Dark, light, on a phone; very many points; a run that goes on; the bundle.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { browse, close, folder, open, picture, settle } from "./browser.mjs";
import { pack, page } from "./container.mjs";
import { cantilever, machine, many } from "./scenes.mjs";

let browser;
before(async () => {
  browser = await browse();
});
after(() => close(browser));

const back = (tab) => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
const bright = (colour) =>
  colour
    .match(/\d+/g)
    .map(Number)
    .reduce((a, b) => a + b) > 380;

test("is dark or light as the system says, and as the button says", async () => {
  for (const theme of ["dark", "light"]) {
    const { tab, complaints } = await open(browser, cantilever(), { theme });
    assert.equal(bright(await back(tab)), theme === "light", theme);
    await tab.click('[aria-label^="Dark or light"]');
    assert.equal(bright(await back(tab)), theme !== "light", `not ${theme}`);
    await tab.evaluate(() => localStorage.clear());
    assert.deepEqual(complaints, []);
    await tab.close();
  }
});

test("fits a phone: nothing beside the screen, buttons large enough for a finger", async () => {
  const viewport = { width: 390, height: 844, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
  const { tab } = await open(browser, machine(), { viewport });
  const wide = await tab.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(wide[0] <= wide[1], `${wide}`);
  await tab.click("#unfold");
  const small = await tab.$$eval("button, select", (all) =>
    all
      .filter((e) => e.offsetParent && e.getBoundingClientRect().height < 40)
      .map((e) => e.getAttribute("aria-label") ?? e.textContent),
  );
  assert.deepEqual(small, []);
  await tab.close();
});

test("every control has a name", async () => {
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

test("a frame of 100 000 stations uploads nothing and costs little of our time", async () => {
  const before = () => {
    window.bytes = 0;
    window.spent = [];
    const size = (list) => {
      for (const a of list) {
        if (ArrayBuffer.isView(a) || a instanceof ArrayBuffer) window.bytes += a.byteLength;
      }
    };
    for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D", "texImage3D"]) {
      const old = WebGL2RenderingContext.prototype[name];
      WebGL2RenderingContext.prototype[name] = function (...a) {
        size(a);
        return old.apply(this, a);
      };
    }
    window.draws = 0;
    const draw = WebGL2RenderingContext.prototype.drawElementsInstanced;
    WebGL2RenderingContext.prototype.drawElementsInstanced = function (...a) {
      window.draws += 1;
      return draw.apply(this, a);
    };
    const ask = window.requestAnimationFrame;
    window.requestAnimationFrame = (act) =>
      ask.call(window, (now) => {
        const [start, drawn] = [performance.now(), window.draws];
        act(now);
        if (window.draws > drawn) window.spent.push(performance.now() - start);
      });
  };
  const { tab, complaints } = await open(browser, many(100, 1000), { before });
  const uploaded = await tab.evaluate(() => window.bytes);
  assert.ok(uploaded > 3 * 100_000 * 16, `${uploaded} bytes at the start`);
  const first = await picture(tab);
  await tab.evaluate(() => {
    window.bytes = 0;
    window.spent = [];
  });
  for (const t of [0.3, 0.7, 1.1, 1.6, 2]) {
    await tab.evaluate((x) => window.ancf.setTime(x), t);
    await settle(tab);
  }
  assert.notEqual(await picture(tab), first);
  const [bytes, spent] = await tab.evaluate(() => [window.bytes, window.spent]);
  assert.equal(bytes, 0);
  spent.sort((a, b) => a - b);
  console.log(
    `    CPU time of a frame: median ${spent[spent.length >> 1].toFixed(2)} ms, ${spent.length} frames`,
  );
  assert.deepEqual(complaints, []);
  await tab.close();
});

test("follows a run that goes on, at the end if it was at the end", async () => {
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
  const { tab, complaints } = await open(browser, null, { url });
  assert.equal(await tab.evaluate(() => window.ancf.time), 0.5);
  assert.match(await tab.$eval(".outcome", (e) => e.textContent), /running/);
  await new Promise((done) => setTimeout(done, 2500));
  assert.ok(unchanged >= 1 && answers <= 4, `${answers} questions, ${unchanged} without news`);
  [scene, version] = [cantilever({ frames: 21, until: 1, live: true }), 2];
  await tab.waitForFunction(() => window.ancf.time === 1, { timeout: 8000 });
  await tab.evaluate(() => window.ancf.setTime(0.25));
  await tab.keyboard.press("g");
  [scene, version] = [cantilever(), 3];
  await tab.waitForFunction(() => document.querySelector(".outcome").textContent === "finished", {
    timeout: 8000,
  });
  const now = await tab.evaluate(() => window.ancf.time);
  assert.ok(Math.abs(now - 0.25) < 1e-9, `the time stays: ${now}`);
  const before = answers;
  await new Promise((done) => setTimeout(done, 1500));
  assert.equal(answers, before, "no questions after the end");
  assert.ok((await tab.evaluate(() => window.ancf.pixels())) > 0.01);
  assert.deepEqual(complaints, []);
  await tab.close();
  server.closeAllConnections();
  server.close();
});

test("the bundle in the repository is what the sources give", () => {
  const out = mkdtempSync(join(folder, "bundle-"));
  const build = fileURLToPath(new URL("../build.mjs", import.meta.url));
  const run = spawnSync(process.execPath, [build, out], { encoding: "utf8" });
  assert.equal(run.status, 0, run.stderr);
  for (const name of ["viewer.js", "viewer.css"]) {
    const kept = readFileSync(new URL(`../../crates/ancf-report/assets/${name}`, import.meta.url), "utf8");
    assert.ok(readFileSync(join(out, name), "utf8") === kept, `${name}: run npm run build`);
    assert.ok(!/<\/script|<!--/i.test(kept), `${name} would end the element it stands in`);
    assert.match(kept, /uplot .*\(MIT\)/i);
  }
});
