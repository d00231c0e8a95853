// Links that hold a model: the text, compressed and in base64 of URLs, in the fragment of the address.

const PREFIX = "#model=";
const EXAMPLE = "#example=";

async function transformed(
  bytes: BlobPart,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  const response = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await response.arrayBuffer());
}

/** Fragment of the address for a model. */
export async function fragmentOf(text: string): Promise<string> {
  const bytes = await transformed(text, new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return PREFIX + btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Model of a fragment; null if it holds none. Rejects if the model is damaged. */
export async function modelOf(fragment: string): Promise<string | null> {
  if (!fragment.startsWith(PREFIX)) return null;
  const base64 = fragment.slice(PREFIX.length).replaceAll("-", "+").replaceAll("_", "/");
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  return new TextDecoder().decode(await transformed(bytes, new DecompressionStream("deflate-raw")));
}

/** Name of the example of a fragment; null if it names none. */
export function exampleOf(fragment: string): string | null {
  return fragment.startsWith(EXAMPLE) ? decodeURIComponent(fragment.slice(EXAMPLE.length)) : null;
}
