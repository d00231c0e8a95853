// Animated WebP files in which each frame is coded by itself, so that slow changes of colour leave no traces of earlier frames.

import sharp from "sharp";

/** Bits of the headers: the file is an animation, a frame replaces the one before. */
const ANIMATION = 0x02;
const REPLACE = 0x02;

/** File of images of equal size (PNG), each shown for `duration` milliseconds, repeated for ever. */
export async function animation(images, duration, options) {
  const { width, height } = await sharp(images[0]).metadata();
  const size = [...bytes(width - 1, 3), ...bytes(height - 1, 3)];
  const frames = [];
  for (const image of images) {
    const head = [...bytes(0, 6), ...size, ...bytes(duration, 3), REPLACE];
    frames.push(chunk("ANMF", Buffer.concat([Buffer.from(head), await bitstream(image, options)])));
  }
  const header = chunk("VP8X", Buffer.from([ANIMATION, 0, 0, 0, ...size]));
  const repeat = chunk("ANIM", Buffer.alloc(6));
  return chunk("RIFF", Buffer.concat([Buffer.from("WEBP"), header, repeat, ...frames]));
}

/** Chunks of an image without the header of its file. */
async function bitstream(image, options) {
  const file = await sharp(image).removeAlpha().webp(options).toBuffer();
  return file.subarray(12);
}

/** Chunk of a RIFF file: name, size, content, padding to an even size. */
function chunk(name, content) {
  const padding = Buffer.alloc(content.length % 2);
  return Buffer.concat([Buffer.from(name), Buffer.from(bytes(content.length, 4)), content, padding]);
}

/** Little-endian bytes of an integer. */
function bytes(value, count) {
  return Array.from({ length: count }, (_, i) => (value >> (8 * i)) & 255);
}
