// Reports of real runs, made by the program: `ANCF` is its path, or that of a debug build.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { browse, close, folder, goTo, near, open, place, settle } from "./browser.mjs";

const root = resolve(import.meta.dirname, "../..");
const program = process.env.ANCF ?? join(root, "target/debug/ancf");

let browser;
before(async () => {
  browser = await browse();
});
after(() => close(browser));

function ancf(...words) {
  const done = spawnSync(program, words, { cwd: root, encoding: "utf8" });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout;
}

const fresh = () => mkdtempSync(join(folder, "run-"));

/** A run of a model and the text of its report. */
function reported(model) {
  const dir = fresh();
  ancf("run", model, "-o", dir, "--quiet");
  const file = ancf("report", dir).trim();
  return { dir, html: readFileSync(file, "utf8") };
}

const columns = (dir) => {
  const [names, ...rows] = readFileSync(join(dir, "probes.csv"), "utf8").trim().split("\n");
  const table = rows.map((row) => row.split(",").map(Number));
  return (name) => table.map((row) => row[names.split(",").indexOf(name)]);
};

test("the tip in the picture is the probe in the table", async () => {
  const { dir, html } = reported("models/cantilever.toml");
  const { tab, complaints } = await open(browser, null, { html });
  const [t, y] = ["t", "tip.y"].map(columns(dir));
  for (const row of [0, 500, 1000, 2000]) {
    await goTo(tab, t[row]);
    const last = await tab.evaluate(() => window.ancf.station(0, 80));
    // Frames are 0.01 s apart, in which the tip goes by half a millimetre at most.
    near(last[1], y[row], 5e-4, `tip.y at ${t[row]}`);
  }
  assert.deepEqual(complaints, []);
  await tab.close();
});

test("reports of every kind of analysis open without a complaint and show something", async () => {
  for (const name of ["bow", "belt", "slider_crank", "elastica", "lees_frame", "tuning_fork", "column"]) {
    const { html } = reported(`models/${name}.toml`);
    const { tab, complaints, shown } = await open(browser, null, { html });
    assert.equal(shown, true, name);
    const share = await tab.evaluate(() => window.ancf.pixels());
    assert.ok(share > 1e-3, `${name}: ${share} of the picture`);
    assert.deepEqual(complaints, [], name);
    await tab.close();
  }
});

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

async function until(what, test) {
  for (let i = 0; i < 300; i++) {
    if (await test()) return;
    await sleep(100);
  }
  assert.fail(`${what}: not within half a minute`);
}

/** The first line that a process prints. */
const line = (child) =>
  new Promise((done, failed) => {
    let text = "";
    child.stdout.on("data", (data) => {
      text += data;
      if (text.includes("\n")) done(text.split("\n")[0]);
    });
    child.on("exit", (code) => failed(new Error(`it ended with ${code}: ${text}`)));
  });

test("a run can be watched while it goes on", async () => {
  const dir = fresh();
  const model = join(dir, "long.toml");
  const text = readFileSync(join(root, "models/cantilever.toml"), "utf8");
  writeFileSync(model, text.replace("duration = 2.0", "duration = 2000.0"));
  const out = join(dir, "out");
  const run = spawn(program, ["run", model, "-o", out, "--quiet"], { stdio: "ignore" });
  const ended = new Promise((done) => run.on("exit", done));
  const parts = join(out, "results.parquet.parts");
  await until(
    "rows",
    () => existsSync(parts) && readdirSync(parts).some((name) => name.endsWith(".parquet")),
  );
  const view = spawn(program, ["view", out]);
  try {
    const { tab, complaints } = await open(browser, null, { url: await line(view) });
    const end = () => tab.evaluate(() => Number(document.querySelector("input.scrub").max));
    const badge = () => tab.$eval("header", (e) => e.textContent);
    assert.match(await badge(), /running/i);
    const first = await end();
    await until("new rows in the page", async () => (await end()) > first);
    run.kill("SIGINT");
    assert.equal(await ended, 130);
    await until("the end in the page", async () => /stopped/i.test(await badge()));
    await settle(tab);
    assert.equal((await place(tab, 0, 0)).length, 3);
    assert.deepEqual(complaints, []);
    await tab.close();
  } finally {
    run.kill("SIGKILL");
    view.kill("SIGINT");
  }
});
