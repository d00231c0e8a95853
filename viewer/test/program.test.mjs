// Reports of runs of the program: the path in the variable ANCF, or the debug build.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { assertNear, close, launch, open, setTime, settle, stationPosition } from "./support/browser.mjs";
import { newFolder, program, root, runReport } from "./support/models.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => close(browser));

const columns = (dir) => {
  const [names, ...rows] = readFileSync(join(dir, "probes.csv"), "utf8").trim().split("\n");
  const table = rows.map((row) => row.split(",").map(Number));
  return (name) => table.map((row) => row[names.split(",").indexOf(name)]);
};

test("the drawn tip position equals the probe in the table", async () => {
  const { dir, html } = runReport("models/cantilever.toml");
  const { tab, problems } = await open(browser, null, { html });
  const [t, y] = ["t", "tip.y"].map(columns(dir));
  for (const row of [0, 500, 1000, 2000]) {
    await setTime(tab, t[row]);
    const last = await tab.evaluate(() => window.ancf.station(0, 80));
    // Frames are 0.01 s apart. The tip moves by at most 0.5 mm between them.
    assertNear(last[1], y[row], 5e-4, `tip.y at ${t[row]}`);
  }
  assert.deepEqual(problems, []);
  await tab.close();
});

test("reports of every analysis open without errors and are not empty", async () => {
  for (const name of ["bow", "belt", "slider_crank", "elastica", "lees_frame", "tuning_fork", "column"]) {
    const { html } = runReport(`models/${name}.toml`);
    const { tab, problems, shown } = await open(browser, null, { html });
    assert.equal(shown, true, name);
    const share = await tab.evaluate(() => window.ancf.coverage());
    assert.ok(share > 1e-3, `${name}: coverage ${share}`);
    assert.deepEqual(problems, [], name);
    await tab.close();
  }
});

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

async function waitUntil(condition, test) {
  for (let i = 0; i < 300; i++) {
    if (await test()) return;
    await sleep(100);
  }
  assert.fail(`${condition}: not within 30 s`);
}

/** First line of the output of a process. */
const firstLine = (child) =>
  new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", (data) => {
      text += data;
      if (text.includes("\n")) resolve(text.split("\n")[0]);
    });
    child.on("exit", (code) => reject(new Error(`exit code ${code}: ${text}`)));
  });

test("a run can be viewed while it is in progress", async () => {
  const dir = newFolder();
  const model = join(dir, "long.toml");
  const text = readFileSync(join(root, "models/cantilever.toml"), "utf8");
  writeFileSync(model, text.replace("duration = 2.0", "duration = 2000.0"));
  const out = join(dir, "out");
  const run = spawn(program, ["run", model, "-o", out, "--quiet"], { stdio: "ignore" });
  const ended = new Promise((done) => run.on("exit", done));
  const parts = join(out, "results.parquet.parts");
  await waitUntil(
    "rows",
    () => existsSync(parts) && readdirSync(parts).some((name) => name.endsWith(".parquet")),
  );
  const view = spawn(program, ["view", out]);
  try {
    const { tab, problems } = await open(browser, null, { url: await firstLine(view) });
    const end = () => tab.evaluate(() => Number(document.querySelector("input.time-slider").max));
    const badge = () => tab.$eval("header", (e) => e.textContent);
    assert.match(await badge(), /running/i);
    const first = await end();
    await waitUntil("new rows in the page", async () => (await end()) > first);
    run.kill("SIGINT");
    assert.equal(await ended, 130);
    await waitUntil("outcome in the page", async () => /stopped/i.test(await badge()));
    await settle(tab);
    assert.equal((await stationPosition(tab, 0, 0)).length, 3);
    assert.deepEqual(problems, []);
    await tab.close();
  } finally {
    run.kill("SIGKILL");
    view.kill("SIGINT");
  }
});
