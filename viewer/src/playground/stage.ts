// Frame with the viewer of results, which receives scenes by messages.

export class Stage {
  private frame: HTMLIFrameElement | null = null;
  private loaded: Promise<void> = Promise.resolve();

  constructor(private readonly parent: Element) {}

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

  /** Shows a scene. */
  async show(scene: Uint8Array<ArrayBuffer>): Promise<void> {
    const { frame } = this;
    await this.loaded;
    if (frame === this.frame) frame?.contentWindow?.postMessage(scene.buffer, window.location.origin);
  }
}
