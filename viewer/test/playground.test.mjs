// The playground: models run in the browser with the results of the program.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import axe from "axe-core";
import { close, DESKTOP, launch, PHONE, settle } from "./support/browser.mjs";
import { ancf, modelNames, newFolder, root } from "./support/models.mjs";
import {
  ended,
  folder,
  getText,
  openPlayground,
  serve,
  setText,
  table,
  viewerOf,
} from "./support/playground.mjs";

let browser;
let server;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await close(browser);
  await server.close();
});

const open = (options = {}) => openPlayground(browser, server.address, { viewport: DESKTOP, ...options });
const model = (name) => readFileSync(join(root, "models", `${name}.toml`), "utf8");
const rows = (csv) =>
  csv
    .trim()
    .split("\n")
    .slice(1)
    .map((row) => row.split(",").map(Number));

/** Largest difference of a column, relative to its largest value. */
function difference(found, expected, column) {
  const scale = Math.max(...expected.map((row) => Math.abs(row[column])));
  const worst = Math.max(...expected.map((row, k) => Math.abs(row[column] - found[k][column])));
  return scale > 0 ? worst / scale : worst;
}

/** Columns to compare: the signs of mode shapes are arbitrary. */
const COMPARED = { cantilever: /^t$|\.[xyz]$/, elastica: /\.[xyz]$/, tuning_fork: /^frequency$/ };

test("a run has the rows of the program", async () => {
  for (const name of Object.keys(COMPARED)) {
    const { tab, problems } = await open({ fragment: `#example=${name}` });
    const dir = newFolder();
    ancf("run", `models/${name}.toml`, "-o", dir, "--quiet");
    const native = readFileSync(join(dir, "probes.csv"), "utf8");
    const csv = await table(tab);
    assert.equal(csv.split("\n")[0], native.split("\n")[0]);
    const [found, expected] = [rows(csv), rows(native)];
    assert.equal(found.length, expected.length);
    const position = native
      .split("\n")[0]
      .split(",")
      .map((column, k) => (COMPARED[name].test(column) ? k : -1))
      .filter((k) => k >= 0);
    assert.ok(position.length > 0);
    // Vector instructions without fused products round otherwise.
    for (const k of position) assert.ok(difference(found, expected, k) < 1e-8, `${name}, column ${k}`);
    const viewer = await viewerOf(tab);
    assert.ok((await viewer.evaluate(() => window.ancf.coverage())) > 0.001, `${name} is drawn`);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test("errors are marked at their lines", async () => {
  const { tab } = await open({ fragment: "#example=cantilever" });
  const text = model("cantilever").replace(/^duration = .*$/m, "duration = -1");
  assert.notEqual(text, model("cantilever"));
  const line = text.split("\n").findIndex((one) => one.startsWith("duration")) + 1;
  await setText(tab, text);
  await tab.waitForSelector("#problems .error");
  const message = await tab.$eval("#problems .error", (e) => e.textContent);
  assert.match(message, new RegExp(`^line ${line}: analysis.duration: found -1`));
  await tab.waitForSelector(".cm-lintRange-error");
  await tab.click("#run");
  assert.equal(await ended(tab), "The model has errors.");
  await tab.close();
});

test("keys and values are completed", async () => {
  const { tab } = await open({ fragment: "#example=cantilever" });
  const labels = async (text, awaited) => {
    await setText(tab, "");
    await tab.focus(".cm-content");
    await tab.keyboard.type(text);
    await tab.keyboard.down("Control");
    await tab.keyboard.press("Space");
    await tab.keyboard.up("Control");
    // A list of completions while typing may be open.
    await tab.waitForFunction(
      (awaited) =>
        [...document.querySelectorAll(".cm-tooltip-autocomplete .cm-completionLabel")].some(
          (one) => one.textContent === awaited,
        ),
      {},
      awaited,
    );
    const found = await tab.$$eval(".cm-tooltip-autocomplete .cm-completionLabel", (all) =>
      all.map((one) => one.textContent),
    );
    await tab.keyboard.press("Escape");
    return found;
  };
  const kinds = await labels("[[bodies]]\nkind = ", '"beam"');
  for (const kind of ['"beam"', '"cable"', '"rigid"']) assert.ok(kinds.includes(kind), kinds.join());
  const keys = await labels('[[bodies]]\nkind = "mass"\nce', "center");
  assert.ok(keys.includes("center"), keys.join());
  assert.ok(!keys.includes("elements"));
  const inline = await labels('[[joints]]\nkind = "clamp"\na = { bo', "body");
  assert.ok(inline.includes("body"), inline.join());
  await tab.close();
});

test("a link holds the model", async () => {
  const { tab } = await open({ fragment: "#example=cantilever" });
  const text = `# α ≤ 1\n${model("cantilever")}`;
  await setText(tab, text);
  await tab.click("#share");
  await tab.waitForFunction(() => window.location.hash.startsWith("#model="));
  const { hash } = new URL(tab.url());
  await tab.close();
  const { tab: other, problems } = await open({ fragment: hash });
  assert.equal(await getText(other), text);
  assert.deepEqual(problems, []);
  const { tab: damaged } = await open({ fragment: "#model=AAAA" });
  assert.match(await getText(damaged), /\[analysis\]/);
  await other.close();
  await damaged.close();
});

test("a run is shown while it proceeds, and can be stopped", async () => {
  const { tab } = await open({ fragment: "#example=cantilever" });
  await setText(tab, model("cantilever").replace(/^duration = .*$/m, "duration = 5000"));
  await tab.click("#run");
  await tab.waitForFunction(() => !document.getElementById("stop").disabled);
  const viewer = await viewerOf(tab);
  const first = await viewer.evaluate(() => window.ancf.time);
  await viewer.waitForFunction((time) => window.ancf.time > time, {}, first);
  await tab.keyboard.press("Escape");
  assert.equal(await ended(tab), "stopped");
  await setText(tab, model("cantilever"));
  await tab.click("#run");
  assert.match(await ended(tab), /steps in/);
  await tab.close();
});

/** Box of a handle on the page, after it is drawn. */
async function handleBox(viewer, selector) {
  const handle = await viewer.waitForSelector(selector);
  await viewer.waitForFunction((one) => document.querySelector(one)?.style.transform !== "", {}, selector);
  await settle(viewer);
  return handle.boundingBox();
}

/** Drags a handle by a distance in pixels, and waits for the end of the run. */
async function drag(tab, viewer, selector, [dx, dy]) {
  const box = await handleBox(viewer, selector);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const before = await getText(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + dx / 2, y + dy / 2);
  await tab.mouse.move(x + dx, y + dy);
  await tab.mouse.up();
  await tab.waitForFunction((text) => window.playground.text !== text, {}, before);
  assert.match(await ended(tab), /steps in/);
}

/** Vectors of the keys of a text, in their order. */
const vectors = (text, key) =>
  [...text.matchAll(new RegExp(`^${key} = (\\[.*?\\])`, "gm"))].map((found) => JSON.parse(found[1]));

test("a dragged joint takes the bodies along", async () => {
  const { tab, problems } = await open({ fragment: "#example=double_pendulum" });
  await tab.click("#drag");
  const viewer = await viewerOf(tab);
  const selector = '.handle.joint[aria-label*="elbow"]';
  await viewer.waitForSelector(selector);
  const before = await getText(tab);
  await drag(tab, viewer, selector, [0, -40]);
  const after = await getText(tab);
  assert.equal(after.split("\n").length, before.split("\n").length);
  const moved = (key) =>
    vectors(after, key).filter((vector, k) => String(vector) !== String(vectors(before, key)[k]));
  const all = [...moved("from"), ...moved("to")];
  assert.equal(all.length, 2, after);
  // Up on the screen is up in the model, and all ends at the joint move together.
  assert.deepEqual(all[0], all[1]);
  assert.ok(all[0][1] > 0.01 && all[0][2] === 0, `${all[0]}`);
  assert.deepEqual(problems, []);
  await tab.close();
});

const PULLED = `
materials.rubber = { density = 1000, young = 1e6 }
sections.square = { kind = "rectangle", height = 0.1, width = 0.1 }
bodies = [{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "square", material = "rubber" }]
joints = [{ kind = "clamp", name = "wall", a = { body = "rod", at = "start" } }]
probes = [{ name = "tip", on = { body = "rod", at = "end" } }]

[[loads]]
kind = "force"
on = { body = "rod", at = "end" }
force = [0, 0.5, 0]

[analysis]
kind = "statics"
`;

test("a dragged force bends a beam the other way", async () => {
  const { tab, problems } = await open({ fragment: "#example=cantilever" });
  await setText(tab, PULLED);
  await tab.click("#run");
  assert.match(await ended(tab), /steps in/);
  const deflection = async () => {
    const csv = await table(tab);
    const column = csv.split("\n")[0].split(",").indexOf("tip.y");
    return rows(csv).at(-1)[column];
  };
  const up = await deflection();
  assert.ok(up > 0.01, `${up}`);
  await tab.click("#drag");
  const viewer = await viewerOf(tab);
  const [arrow, start] = [await handleBox(viewer, ".handle.force"), await handleBox(viewer, ".handle.joint")];
  // Mirror the arrow of the force about the axis of the beam.
  await drag(tab, viewer, ".handle.force", [0, 2 * (start.y - arrow.y)]);
  const [force] = vectors(await getText(tab), "force");
  assert.ok(Math.abs(force[1] + 0.5) < 0.02 && Math.abs(force[2]) < 0.01, `${force}`);
  const down = await deflection();
  assert.ok(Math.abs(down + up) < 0.05 * up, `${down}`);
  // The arrow keys move a handle too.
  await viewer.focus(".handle.force");
  const before = await getText(tab);
  await tab.keyboard.press("ArrowUp");
  await tab.waitForFunction((text) => window.playground.text !== text, {}, before);
  assert.ok(vectors(await getText(tab), "force")[0][1] > force[1]);
  assert.match(await ended(tab), /steps in/);
  assert.deepEqual(problems, []);
  await tab.click("#drag");
  await viewer.waitForFunction(() => document.querySelectorAll(".handle").length === 0);
  await tab.close();
});

test("the page works without a network after the first visit", async () => {
  // A server that is gone: the protocol of the browser for a missing network differs between versions.
  const own = await serve();
  const options = { fragment: "#example=cantilever", viewport: DESKTOP };
  const { tab } = await openPlayground(browser, own.address, options);
  await tab.evaluate(() => navigator.serviceWorker.ready);
  await tab.waitForFunction(async () => (await caches.keys()).length > 0);
  await own.close();
  await tab.reload();
  assert.match(await ended(tab), /steps in/);
  await tab.close();
});

test("all models without a mesh file are examples", async () => {
  const { tab } = await open({ fragment: "#example=cantilever" });
  const names = await tab.$$eval("#example option", (all) => all.map((one) => one.value));
  const isAlone = (name) => !model(name).includes('.msh"');
  assert.deepEqual([...names].sort(), modelNames.filter(isAlone).sort());
  assert.ok(names.length >= 25);
  await tab.close();
});

test("the page has no accessibility violations", async () => {
  for (const viewport of [DESKTOP, PHONE]) {
    for (const theme of ["light", "dark"]) {
      const { tab } = await open({ fragment: "#example=cantilever", viewport, theme });
      await tab.evaluate(axe.source);
      const found = await tab.evaluate(() => window.axe.run({ iframes: false }));
      assert.deepEqual(
        found.violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ")}`),
        [],
        `${theme}, ${viewport.width} px`,
      );
      await tab.close();
    }
  }
});

test("the compressed module has at most 3 MB", () => {
  const bytes = gzipSync(readFileSync(join(folder, "ancf_web_bg.wasm"))).length;
  assert.ok(bytes <= 3e6, `${bytes} bytes`);
});
