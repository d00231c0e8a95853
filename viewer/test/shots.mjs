// Screenshots of the viewer in several states and of all models, for visual inspection: `node test/shots.mjs DIR [NAMES]`.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { manyBeams } from "./support/beams.mjs";
import { close, DESKTOP, launch, open, PHONE, settle } from "./support/browser.mjs";
import { cantilever } from "./support/cantilever.mjs";
import { machine } from "./support/machine.mjs";
import { modelNames, modelPage } from "./support/models.mjs";
import { frequencies, modes } from "./support/shapes.mjs";

const folder = process.argv[2] ?? "shots";
mkdirSync(folder, { recursive: true });
const TOUCH = { width: 390, height: 844, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
const press = (keys) => async (tab) => {
  for (const key of keys) await tab.keyboard.press(key);
};
const at =
  (time, keys = []) =>
  async (tab) => {
    await tab.evaluate((t) => window.ancf.setTime(t), time);
    await press(keys)(tab);
  };
const solver = async (tab) => {
  await at(0.5, ["g"])(tab);
  await tab.click('[data-group="solver"]');
};
const run = (tab) => tab.click("#tab-Run");

const SHOTS = [
  ["light", cantilever(), {}, at(0.5, ["g"])],
  ["dark", cantilever(), { theme: "dark" }, at(1.4, ["g", "4", "d", "n"])],
  ["solver", cantilever(), {}, solver],
  ["phone", cantilever(), { viewport: TOUCH }, at(0.5, ["g"])],
  ["phone-dark", modes(), { viewport: TOUCH, theme: "dark" }, at(2, ["g"])],
  ["modes", modes(), {}, at(2, ["g"])],
  ["frequencies", frequencies(), {}, (tab) => tab.click("#tab-Charts")],
  ["machine", machine(), {}, at(0.3)],
  ["machine-run", machine(), { theme: "dark" }, run],
  ["help", machine(), {}, press(["?"])],
  ["many", manyBeams(100, 1000), {}, at(2)],
  ["empty", cantilever({ frames: 1 }), {}, press([])],
];

const middle = (tab) =>
  tab.$eval("input.time-slider", (e) => {
    e.value = String(0.37 * Number(e.max));
    e.dispatchEvent(new Event("input"));
  });
for (const name of modelNames) {
  const html = () => modelPage(name);
  SHOTS.push([name, null, { viewport: DESKTOP, html }, middle]);
  SHOTS.push([`${name}-dark`, null, { viewport: DESKTOP, theme: "dark", html }, middle]);
  SHOTS.push([`${name}-phone`, null, { viewport: PHONE, html }, middle]);
}

const browser = await launch();
for (const [name, scene, options, act] of SHOTS) {
  if (process.argv[3] && !process.argv[3].split(",").includes(name)) continue;
  const { html } = options;
  const { tab, problems } = await open(browser, scene, html ? { ...options, html: html() } : options);
  await act(tab);
  await settle(tab);
  await tab.screenshot({ path: join(folder, `${name}.png`) });
  console.log(name, await tab.evaluate(() => window.ancf.coverage()), problems.join("\n").slice(0, 1500));
  await tab.close();
}
await close(browser);
