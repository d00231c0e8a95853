// Structure of the sources: order of the folders, import cycles, sizes.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { test } from "node:test";

const SOURCES = resolve(import.meta.dirname, "../src");
/** Folders from the bottom to the top. Imports between folders point to a lower folder. */
const FOLDERS = [
  "base",
  "scene",
  "view",
  "draw/shaders",
  "draw",
  "charts",
  "overlay",
  "panel",
  "ui",
  ".",
  "playground",
];
const MAX_FILES = 12;
const MAX_LINES = 400;

const files = readdirSync(SOURCES, { recursive: true }).filter((path) => path.endsWith(".ts"));

/** Modules of the viewer that a file imports. */
function imports(file) {
  const text = readFileSync(join(SOURCES, file), "utf8");
  return [...text.matchAll(/from "(\.[^"]*)(?<!\.json)"/g)].map(
    ([, path]) => `${relative(SOURCES, resolve(SOURCES, dirname(file), path))}.ts`,
  );
}

test("folders have at most 12 files, files at most 400 lines", () => {
  for (const folder of FOLDERS) {
    const count = files.filter((file) => dirname(file) === folder).length;
    assert.ok(count > 0 && count <= MAX_FILES, `${folder}: ${count} files`);
  }
  for (const file of files) {
    assert.ok(FOLDERS.includes(dirname(file)), `${file} is in an unknown folder`);
    const lines = readFileSync(join(SOURCES, file), "utf8").split("\n").length;
    assert.ok(lines <= MAX_LINES, `${file}: ${lines} lines`);
  }
});

test("imports between folders point to a lower folder", () => {
  for (const file of files) {
    for (const imported of imports(file)) {
      assert.ok(files.includes(imported), `${file} imports ${imported}, which does not exist`);
      const [from, to] = [file, imported].map((path) => FOLDERS.indexOf(dirname(path)));
      assert.ok(to <= from, `${file} imports ${imported} from a higher folder`);
    }
  }
});

test("files have no import cycle", () => {
  const done = new Set();
  const visit = (file, path) => {
    assert.ok(!path.includes(file), `cycle: ${[...path, file].join(" -> ")}`);
    if (done.has(file)) return;
    for (const imported of imports(file)) visit(imported, [...path, file]);
    done.add(file);
  };
  for (const file of files) visit(file, []);
});
