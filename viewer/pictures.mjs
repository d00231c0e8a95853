// Pictures of the documentation: `node pictures.mjs`, or with the names of models.
//
// docs/pictures/pictures.json lists them: file, model, size in CSS pixels, and the instant `at` as a share of the run, the mode
// `shape`, or the length of an animation in seconds with its end `until` as a share of the run. Further keys: `keys` to press
// (such as "4" for the oblique view), the `field` of the colours, and `page` for the whole page. The checksums of the models are
// written into checksums.json, and a test compares them.

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import sharp from "sharp";
import { animation } from "./animation.mjs";
import { close, launch, open, settle } from "./test/support/browser.mjs";
import { modelPage, root } from "./test/support/models.mjs";

/** Frames per second of animations. */
const RATE = 12;
/** Compression. */
const WEBP = { quality: 76, effort: 6 };
/** Parts of the page that are not in pictures of the 3-D view. */
const STYLE = `
  header, .panel, .transport, .tools, .legend, .overlay { display: none !important; }
  main { display: block !important; }
  .view, .stage { width: 100vw !important; height: 100vh !important; min-height: 0 !important; }`;

const folder = join(root, "docs/pictures");
const pictures = JSON.parse(readFileSync(join(folder, "pictures.json"), "utf8"));
const file = join(folder, "checksums.json");
const earlier = JSON.parse(readFileSync(file, "utf8"));
const selected = process.argv.slice(2);
const browser = await launch();
const checksums = {};
for (const picture of pictures) {
  const { model } = picture;
  if (selected.length > 0 && !selected.includes(model)) {
    checksums[model] = earlier[model];
    continue;
  }
  await record(picture);
  const text = readFileSync(join(root, "models", `${model}.toml`));
  checksums[model] = createHash("sha256").update(text).digest("hex");
}
await close(browser);
writeFileSync(file, `${JSON.stringify(checksums, null, 2)}\n`);

async function record(picture) {
  const tab = await prepared(picture);
  const { file, page, at, shape, seconds, until } = picture;
  const frames = seconds ? Math.round(RATE * seconds) : 1;
  const shots = [];
  for (let k = 0; k < frames; k++) {
    if (!shape) await seek(tab, seconds ? (until * k) / (frames - 1) : at);
    await settle(tab);
    const part = page ? tab : await tab.$(".stage");
    shots.push(Buffer.from(await part.screenshot({ type: "png" })));
  }
  await tab.close();
  const image = seconds
    ? await animation(shots, Math.round(1000 / RATE), WEBP)
    : await sharp(shots[0]).webp(WEBP).toBuffer();
  writeFileSync(join(folder, file), image);
  console.log(`${file}: ${Math.round(image.length / 1000)} kB`);
}

/** Page of a model with the requested view. */
async function prepared({ model, width, height, page, shape, field, keys = [] }) {
  const viewport = { width, height, deviceScaleFactor: page ? 1.25 : 1.5 };
  const { tab } = await open(browser, null, { viewport, html: modelPage(model) });
  if (!page) await tab.addStyleTag({ content: STYLE });
  await settle(tab);
  if (field) await tab.select('[aria-label="colour by"]', field);
  for (const key of ["f", ...keys]) await tab.keyboard.press(key);
  if (shape) await tab.evaluate((number) => window.ancf.setTime(number), shape);
  return tab;
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
