// Writer of scenes: the binary container (documented in the crate ancf-report) and the page around it.

import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const TYPES = { f32: Float32Array, f64: Float64Array, i16: Int16Array, u16: Uint16Array, u32: Uint32Array };

/** Array of the header that `pack` moves into the blob. */
export class ArrayData {
  constructor(type, numbers) {
    this.type = type;
    this.data = TYPES[type].from(numbers);
  }
}

export const f32 = (numbers) => new ArrayData("f32", numbers);
export const f64 = (numbers) => new ArrayData("f64", numbers);
export const i16 = (numbers) => new ArrayData("i16", numbers);
export const u16 = (numbers) => new ArrayData("u16", numbers);
export const u32 = (numbers) => new ArrayData("u32", numbers);

/** Container of a header whose arrays are of type `ArrayData`. */
export function pack(scene) {
  const parts = [];
  let at = 0;
  const header = JSON.stringify(scene, (_, value) => {
    if (!(value instanceof ArrayData)) return value;
    const bytes = Buffer.from(value.data.buffer);
    const padded = Buffer.concat([bytes, Buffer.alloc((8 - (bytes.length % 8)) % 8)]);
    const reference = { type: value.type, at, count: value.data.length };
    parts.push(padded);
    at += padded.length;
    return reference;
  });
  const text = Buffer.from(header, "utf8");
  const spaces = Buffer.alloc((8 - (text.length % 8)) % 8, " ");
  const start = Buffer.alloc(16);
  start.write("ANCF");
  start.writeUInt32LE(1, 4);
  start.writeUInt32LE(text.length + spaces.length, 8);
  return Buffer.concat([start, text, spaces, ...parts]);
}

const asset = (name) =>
  readFileSync(new URL(`../../../crates/ancf-report/assets/${name}`, import.meta.url), "utf8");

/** Page of a report, with data in base64 or with the address `source` of the data. */
export function page(data, source = null) {
  const attribute = source ? ` data-src="${source}"` : "";
  const policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; " +
    `img-src data: blob:; font-src data:; ${source ? "connect-src 'self'; " : ""}base-uri 'none'; form-action 'none'`;
  return `<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>ancf</title>
<link rel="icon" href="data:,"><style>${asset("viewer.css")}</style></head><body>
<script type="application/octet-stream" id="scene"${attribute}>${data}</script>
<script>${asset("viewer.js")}</script></body></html>`;
}

/** Page of a report of a scene. */
export function report(scene) {
  return page(gzipSync(pack(scene)).toString("base64"));
}
