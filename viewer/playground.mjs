// Builds the playground into a folder: `node playground.mjs OUT WASM`, with the files of wasm-bindgen in WASM.

import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "..");
const [out, wasm] = process.argv.slice(2);
if (!out || !wasm) throw new Error("expected two folders: of the page and of the files of wasm-bindgen");

const TARGET = ["es2022", "chrome109", "firefox115", "safari16.4"];
const options = {
  absWorkingDir: here,
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: TARGET,
};
const source = (name) => `src/playground/${name}.ts`;

mkdirSync(out, { recursive: true });
for (const name of ["index.html", "viewer.html"])
  copyFileSync(join(here, "playground", name), join(out, name));
for (const name of ["viewer.js", "viewer.css"])
  copyFileSync(join(root, "crates/ancf-report/assets", name), join(out, name));
copyFileSync(join(root, "docs/model.schema.json"), join(out, "model.schema.json"));
for (const name of ["ancf_web.js", "ancf_web_bg.wasm"]) copyFileSync(join(wasm, name), join(out, name));

const examples = readdirSync(join(root, "models"))
  .filter((name) => name.endsWith(".toml"))
  .map((name) => {
    const text = readFileSync(join(root, "models", name), "utf8");
    const words = basename(name, ".toml").replaceAll("_", " ");
    const title = text.match(/^title\s*=\s*"([^"]+)"/m)?.[1] ?? words[0].toUpperCase() + words.slice(1);
    return { name: basename(name, ".toml"), title, text };
  })
  // The page has no files beside the text of a model.
  .filter(({ text }) => !text.includes('.msh"'));
const first = (example) => (example.name === "robot_arm" ? 0 : 1);
examples.sort((a, b) => first(a) - first(b) || a.title.localeCompare(b.title));
writeFileSync(join(out, "examples.json"), JSON.stringify(examples));

await build({ ...options, entryPoints: { playground: source("main"), worker: source("worker") } });

const files = readdirSync(out).filter((name) => name !== "offline.js");
const checksum = createHash("sha256");
for (const name of files) checksum.update(name).update(readFileSync(join(out, name)));
const cache = `ancf-${checksum.digest("hex").slice(0, 16)}`;
const define = { CACHE: JSON.stringify(cache), FILES: JSON.stringify(["./", ...files]) };
await build({ ...options, entryPoints: { offline: source("offline") }, define });
