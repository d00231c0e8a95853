// Pictures of the documentation: `node pictures.mjs`.
//
// docs/pictures/pictures.json lists them: file, model, size in CSS pixels, and the instant `at` as a share of the run, the mode
// `shape`, or the length of an animation in seconds with its end `until` as a share of the run. The checksums of the models are
// written into checksums.json, and a test compares them.

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import sharp from "sharp";
import { close, launch, open, settle } from "./test/support/browser.mjs";
import { modelPage, root } from "./test/support/models.mjs";

/** Frames per second of animations. */
const RATE = 12;
/** Parts of the page that are not in the pictures. */
const STYLE = `
  header, .panel, .transport, .tools, .legend, .overlay { display: none !important; }
  main { display: block !important; }
  .view, .stage { width: 100vw !important; height: 100vh !important; }`;

const folder = join(root, "docs/pictures");
const pictures = JSON.parse(readFileSync(join(folder, "pictures.json"), "utf8"));
const browser = await launch();
const checksums = {};
for (const picture of pictures) {
  await record(picture);
  const model = readFileSync(join(root, "models", `${picture.model}.toml`));
  checksums[picture.model] = createHash("sha256").update(model).digest("hex");
}
await close(browser);
writeFileSync(join(folder, "checksums.json"), `${JSON.stringify(checksums, null, 2)}\n`);

async function record({ file, model, width, height, at, shape, seconds, until }) {
  const viewport = { width, height, deviceScaleFactor: 1.5 };
  const { tab } = await open(browser, null, { viewport, html: modelPage(model) });
  await tab.addStyleTag({ content: STYLE });
  await settle(tab);
  await tab.keyboard.press("f");
  if (shape) {
    await tab.evaluate((number) => window.ancf.setTime(number), shape);
  }
  const frames = seconds ? Math.round(RATE * seconds) : 1;
  const shots = [];
  for (let k = 0; k < frames; k++) {
    if (!shape) await seek(tab, seconds ? (until * k) / (frames - 1) : at);
    await settle(tab);
    const view = await tab.$(".stage");
    shots.push(Buffer.from(await view.screenshot({ type: "png" })));
  }
  await tab.close();
  const image = seconds ? sharp(shots, { join: { animated: true } }) : sharp(shots[0]);
  const options = seconds ? { delay: Array(frames).fill(Math.round(1000 / RATE)), loop: 0 } : {};
  const { size } = await image.webp({ quality: 72, effort: 6, ...options }).toFile(join(folder, file));
  console.log(`${file}: ${Math.round(size / 1000)} kB`);
}

/** Moves to a share of the run. */
async function seek(tab, part) {
  await tab.$eval(
    "input.time-slider",
    (slider, part) => {
      slider.value = String(part * Number(slider.max));
      slider.dispatchEvent(new Event("input"));
    },
    part,
  );
}
