// Colour maps of fields, and colours of bodies and curves. The maps are those of the table that Python uses, too.

import table from "../../../crates/ancf-report/assets/colour_maps.json";

export type Rgb = [number, number, number];

/** Colours of bodies and curves, distinguishable with most colour vision deficiencies (after Okabe & Ito, 2008). */
const OKABE_ITO = "3f86d0 d08700 129a73 d0558f 7b5bd6 7d8793 a8482a 2fb0c4";

function parse(list: string): Rgb[] {
  return list.split(" ").map((hex) => [0, 2, 4].map((i) => Number.parseInt(hex.slice(i, i + 2), 16)) as Rgb);
}

const MAPS = new Map(Object.entries(table.maps).map(([name, colours]) => [name, parse(colours)]));
/** Names of all maps. */
export const MAP_NAMES = [...MAPS.keys()];
export const PALETTE = parse(OKABE_ITO);

/** Name of the map of a quantity with values of both signs, or of one sign. */
export function automaticMap(bothSigns: boolean): string {
  return bothSigns ? table.diverging : table.sequential;
}

/** Colour (0 to 255) of a map at `t` from 0 to 1. */
export function mapColour(map: string, t: number): Rgb {
  const colours = MAPS.get(map) ?? PALETTE;
  const position = Math.min(1, Math.max(0, t)) * (colours.length - 1);
  const i = Math.min(colours.length - 2, Math.floor(position));
  const weight = position - i;
  return colours[i].map((c, k) => c + weight * (colours[i + 1][k] - c)) as Rgb;
}

/** Table of 256 colours of a map as RGBA bytes. */
export function colourTable(map: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) bytes.set([...mapColour(map, i / 255).map(Math.round), 255], 4 * i);
  return bytes;
}

/** CSS gradient of a map; `direction` is a CSS direction such as "to top". */
export function cssGradient(map: string, direction: string): string {
  const stops = Array.from({ length: 17 }, (_, i) => cssColour(mapColour(map, i / 16)));
  return `linear-gradient(${direction}, ${stops.join(", ")})`;
}

export function cssColour(rgb: Rgb): string {
  return `rgb(${rgb.map(Math.round).join(" ")})`;
}

/** Colour of the body or curve with number `index`. */
export function paletteColour(index: number): Rgb {
  return PALETTE[index % PALETTE.length];
}
