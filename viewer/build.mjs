// Bundles the viewer into ../crates/ancf-report/assets/viewer.js and viewer.css; `node build.mjs DIR` writes to another folder.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../crates/ancf-report/assets");

const result = await build({
  absWorkingDir: here,
  entryPoints: { viewer: "src/main.ts" },
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022", "chrome109", "firefox115", "safari16.4"],
  charset: "utf8",
  legalComments: "none",
  metafile: true,
  write: false,
});

/** Name, version and licence text of every package in the bundle. */
function licences(inputs) {
  const packages = new Set();
  for (const path of inputs) {
    const found = path.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (found) packages.add(found[1]);
  }
  return [...packages].sort().map((name) => {
    const folder = join(here, "node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const file = ["LICENSE", "LICENSE.md", "license"].map((f) => join(folder, f)).find(existsSync);
    if (!file) throw new Error(`${name} has no licence file`);
    return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}`;
  });
}

const notice = `\n/*!\n${licences(Object.keys(result.metafile.inputs)).join("\n\n")}\n*/\n`;
mkdirSync(out, { recursive: true });
for (const { path, text } of result.outputFiles) {
  // The bundle is embedded in <script> and <style>: it must not contain their end tags or the start of a comment.
  const safe = text.replace(/<\/(script|style)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");
  writeFileSync(path, safe.trimEnd() + notice);
  console.log(`${path}: ${Math.round(safe.length / 1024)} kB`);
}
