// Source of the scene: the page itself, the server of a run that is in progress, or the page around this one.

import { damaged } from "./check";
import { decodeScene } from "./container";
import { type Scene, SceneError } from "./scene";

/** Decompresses gzip; other data are returned as they are. */
async function decompress(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes.slice().buffer;
  if (typeof DecompressionStream === "undefined") {
    throw new SceneError(
      "This browser cannot decompress the data of this page. Use a browser version of 2023 or later.",
    );
  }
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return await new Response(stream).arrayBuffer();
  } catch {
    throw damaged("they are not valid gzip");
  }
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  let binary: string;
  try {
    binary = atob(text.trim());
  } catch {
    throw damaged("they are not valid base64");
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Reads the scene embedded in the page. */
async function readEmbedded(element: Element): Promise<Scene> {
  const text = element.textContent ?? "";
  if (text.trim() === "") throw noData();
  return decodeScene(await decompress(fromBase64(text)));
}

function noData(): SceneError {
  return new SceneError("This page holds no data. Create the page again.");
}

/** Address of a scene. The data are transferred only if they have changed. */
class Endpoint {
  private tag = "";
  /** Size of the last answer. */
  bytes = 0;

  constructor(private readonly url: string) {}

  /** Fetches the scene; null if it has not changed. */
  async fetch(): Promise<Scene | null> {
    const headers: Record<string, string> = this.tag ? { "If-None-Match": this.tag } : {};
    const response = await fetch(this.url, { headers, cache: "no-store" });
    if (response.status === 304) return null;
    if (!response.ok)
      throw new SceneError(`The server returned status ${response.status} for the data of this page.`);
    const tag = response.headers.get("ETag") ?? "";
    if (tag !== "" && tag === this.tag) return null;
    const bytes = new Uint8Array(await response.arrayBuffer());
    const scene = decodeScene(await decompress(bytes));
    this.bytes = bytes.length;
    this.tag = tag;
    return scene;
  }
}

/** Polling interval in ms: one second, plus one second per megabyte of the last answer, at most 30 seconds. */
function pollingInterval(bytes: number): number {
  return Math.min(30_000, 1000 * (1 + bytes / 1e6));
}

/** Receiver of the scenes of a page. */
export interface SceneListener {
  scene(scene: Scene): void;
  /** Connection state: a message while the server does not respond, else null. */
  connection(message: string | null): void;
}

/** Reads the scene of the document, and polls the server for new data while the scene is live. */
export async function followScene(document: Document, listener: SceneListener): Promise<void> {
  const element = document.getElementById("scene");
  if (!element) throw noData();
  const url = element.getAttribute("data-src");
  if (!url) {
    listener.scene(await readEmbedded(element));
    return;
  }
  if (url === PARENT) {
    await followParent(listener);
    return;
  }
  const endpoint = new Endpoint(url);
  let scene = await firstScene(endpoint);
  listener.scene(scene);
  const poll = async () => {
    try {
      const update = document.hidden ? null : await endpoint.fetch();
      if (update) {
        scene = update;
        listener.scene(scene);
      }
      listener.connection(null);
    } catch {
      listener.connection("Updates of the run have stopped: the server does not respond.");
    }
    if (scene.live) setTimeout(poll, pollingInterval(endpoint.bytes));
  };
  if (scene.live) setTimeout(poll, pollingInterval(endpoint.bytes));
}

/** Address of scenes that the page around this one sends. */
const PARENT = "parent:";

/** Receives scenes as messages of the page around this one. Resolves with the first scene. */
async function followParent(listener: SceneListener): Promise<void> {
  await new Promise<void>((resolve, reject) => {
    window.addEventListener("message", (event: MessageEvent<unknown>) => {
      const isScene = event.source === window.parent && event.data instanceof ArrayBuffer;
      if (!isScene || event.origin !== window.location.origin) return;
      try {
        listener.scene(decodeScene(event.data as ArrayBuffer));
        resolve();
      } catch (error) {
        reject(error);
      }
    });
    window.parent.postMessage("ancf-viewer-ready", window.location.origin);
  });
}

async function firstScene(endpoint: Endpoint): Promise<Scene> {
  try {
    const scene = await endpoint.fetch();
    if (scene) return scene;
  } catch (error) {
    if (error instanceof SceneError) throw error;
  }
  throw new SceneError("The data of this page cannot be loaded: the server does not respond.");
}
