// Colour maps: viridis (van der Walt & Smith, 2015) for one-sided fields, cool-warm (Moreland, 2009) for signed fields.

export type Rgb = [number, number, number];

const VIRIDIS = "440154 482878 3e4989 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725";
const COOL_WARM = "3b4cc0 688aef 99baff c9d8ef dddddd edd1c2 f7a789 e36a53 b40426";
/** Colours of bodies and curves, distinguishable with most colour vision deficiencies (after Okabe & Ito, 2008). */
const OKABE_ITO = "3f86d0 d08700 129a73 d0558f 7b5bd6 7d8793 a8482a 2fb0c4";

function parse(list: string): Rgb[] {
  return list.split(" ").map((hex) => [0, 2, 4].map((i) => Number.parseInt(hex.slice(i, i + 2), 16)) as Rgb);
}

const MAPS = { sequential: parse(VIRIDIS), diverging: parse(COOL_WARM) };
export const PALETTE = parse(OKABE_ITO);

/** Colour (0 to 255) of the map at `t` from 0 to 1. */
export function mapColour(diverging: boolean, t: number): Rgb {
  const anchors = diverging ? MAPS.diverging : MAPS.sequential;
  const position = Math.min(1, Math.max(0, t)) * (anchors.length - 1);
  const i = Math.min(anchors.length - 2, Math.floor(position));
  const weight = position - i;
  return anchors[i].map((c, k) => c + weight * (anchors[i + 1][k] - c)) as Rgb;
}

/** Table of 256 colours of the map as RGBA bytes. */
export function colourTable(diverging: boolean): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) bytes.set([...mapColour(diverging, i / 255).map(Math.round), 255], 4 * i);
  return bytes;
}

/** CSS gradient of the map; `direction` is a CSS direction such as "to top". */
export function cssGradient(diverging: boolean, direction: string): string {
  const stops = Array.from({ length: 17 }, (_, i) => cssColour(mapColour(diverging, i / 16)));
  return `linear-gradient(${direction}, ${stops.join(", ")})`;
}

export function cssColour(rgb: Rgb): string {
  return `rgb(${rgb.map(Math.round).join(" ")})`;
}

/** Colour of the body or curve with number `index`. */
export function paletteColour(index: number): Rgb {
  return PALETTE[index % PALETTE.length];
}

/** Range of values that the colour map covers. It is symmetric about zero for a signed field. */
export function colourRange(range: [number, number], diverging: boolean): [number, number] {
  const [low, high] = range;
  if (diverging) {
    const bound = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return [-bound, bound];
  }
  return high > low ? [low, high] : [low, low + (Math.abs(low) || 1)];
}
