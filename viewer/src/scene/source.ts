// Where the scene comes from: out of the page itself, or from the server that follows a run.

import { decode, type Scene, SceneError } from "./scene";

async function unpack(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes.slice().buffer;
  if (typeof DecompressionStream === "undefined") {
    throw new SceneError(
      "This browser is too old to unpack the data of this page; any of 2023 or later will do.",
    );
  }
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return await new Response(stream).arrayBuffer();
  } catch {
    throw new SceneError("The data of this page are damaged: they cannot be unpacked.");
  }
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  let binary: string;
  try {
    binary = atob(text.trim());
  } catch {
    throw new SceneError("The data of this page are damaged: they are not base64.");
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Reads the scene that stands in the page. */
async function embedded(element: Element): Promise<Scene> {
  const text = element.textContent ?? "";
  if (text.trim() === "") throw new SceneError("This page holds no data.");
  return decode(await unpack(fromBase64(text)));
}

/** A scene behind an address, fetched again only when it has changed. */
class Endpoint {
  private tag = "";
  bytes = 0;

  constructor(private readonly url: string) {}

  /** The scene, or null if it is the one already seen. */
  async fetch(): Promise<Scene | null> {
    const headers: Record<string, string> = this.tag ? { "If-None-Match": this.tag } : {};
    const response = await fetch(this.url, { headers, cache: "no-store" });
    if (response.status === 304) return null;
    if (!response.ok)
      throw new SceneError(`The server answers ${response.status} for the data of this page.`);
    const tag = response.headers.get("ETag") ?? "";
    if (tag !== "" && tag === this.tag) return null;
    const bytes = new Uint8Array(await response.arrayBuffer());
    const scene = decode(await unpack(bytes));
    this.bytes = bytes.length;
    this.tag = tag;
    return scene;
  }
}

/** Milliseconds between two looks at a run: one second, and one more for each megabyte of the last answer. */
export function pause(bytes: number): number {
  return Math.min(30_000, 1000 * (1 + bytes / 1e6));
}

export interface Listener {
  scene(scene: Scene): void;
  /** The server cannot be reached (text) or can again (null). */
  trouble(text: string | null): void;
}

/** Reads the scene of `document`, tells the listener, and goes on as long as the scene is live. */
export async function follow(document: Document, listener: Listener): Promise<void> {
  const element = document.getElementById("scene");
  if (!element) throw new SceneError("This page holds no data.");
  const url = element.getAttribute("data-src");
  if (!url) {
    listener.scene(await embedded(element));
    return;
  }
  const endpoint = new Endpoint(url);
  let scene = await first(endpoint);
  listener.scene(scene);
  const next = async () => {
    try {
      const fresh = document.hidden ? null : await endpoint.fetch();
      if (fresh) {
        scene = fresh;
        listener.scene(scene);
      }
      listener.trouble(null);
    } catch {
      listener.trouble("The run cannot be followed any more: the server does not answer.");
    }
    if (scene.live) setTimeout(next, pause(endpoint.bytes));
  };
  if (scene.live) setTimeout(next, pause(endpoint.bytes));
}

async function first(endpoint: Endpoint): Promise<Scene> {
  try {
    const scene = await endpoint.fetch();
    if (scene) return scene;
  } catch (error) {
    if (error instanceof SceneError) throw error;
  }
  throw new SceneError("The data of this page cannot be fetched: the server does not answer.");
}
