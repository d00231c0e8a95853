// Pages of the models of the repository, computed by the program: the path in the variable ANCF, or the debug build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { folder } from "./browser.mjs";
import { page } from "./container.mjs";

export const root = resolve(import.meta.dirname, "../../..");
export const program = process.env.ANCF ?? join(root, "target/debug/ancf");

export function ancf(...args) {
  const done = spawnSync(program, args, { cwd: root, encoding: "utf8" });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout;
}

export const newFolder = () => mkdtempSync(join(folder, "run-"));

/** Names of all models. */
export const modelNames = readdirSync(join(root, "models"))
  .filter((name) => name.endsWith(".toml"))
  .map((name) => name.replace(".toml", ""));

/** Runs a model file and returns its folder and report. */
export function runReport(model) {
  const dir = newFolder();
  ancf("run", model, "-o", dir, "--quiet");
  const file = ancf("report", dir).trim();
  return { dir, html: readFileSync(file, "utf8") };
}

/** Page of a model with the committed bundle, which may be newer than that of the program. */
export function modelPage(name) {
  const { html } = runReport(`models/${name}.toml`);
  return page(html.match(/id="scene">([^<]*)</)[1]);
}
