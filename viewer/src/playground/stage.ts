// Frame with the viewer of results, which receives scenes by messages.

import type { MovedMessage } from "../ui/embedding";
import type { Handle } from "./messages";

export class Stage {
  private frame: HTMLIFrameElement | null = null;
  private loaded: Promise<void> = Promise.resolve();

  /** `moved` is called when the user has dragged a point of the model. */
  constructor(
    private readonly parent: Element,
    moved: (number: number, to: [number, number, number]) => void,
  ) {
    window.addEventListener("message", (event: MessageEvent<Partial<MovedMessage> | null>) => {
      const isOurs = event.source === this.frame?.contentWindow && event.origin === window.location.origin;
      if (isOurs && event.data?.moved) moved(event.data.moved.number, event.data.moved.to);
    });
  }

  /** Opens an empty viewer for the next run. */
  open(): void {
    this.frame?.remove();
    const frame = document.createElement("iframe");
    frame.title = "results";
    frame.src = "viewer.html";
    this.loaded = new Promise((resolve) => {
      const ready = (event: MessageEvent) => {
        if (event.source !== frame.contentWindow || event.data !== "ancf-viewer-ready") return;
        window.removeEventListener("message", ready);
        resolve();
      };
      window.addEventListener("message", ready);
    });
    this.frame = frame;
    this.parent.replaceChildren(frame);
  }

  /** True if a viewer is open. */
  get isOpen(): boolean {
    return this.frame !== null;
  }

  /** Shows a scene. */
  async show(scene: Uint8Array<ArrayBuffer>): Promise<void> {
    await this.send(scene.buffer);
  }

  /** Shows points of the model that one drags. */
  async showHandles(handles: Handle[]): Promise<void> {
    await this.send({ handles });
  }

  private async send(message: unknown): Promise<void> {
    const { frame } = this;
    await this.loaded;
    if (frame === this.frame) frame?.contentWindow?.postMessage(message, window.location.origin);
  }
}
