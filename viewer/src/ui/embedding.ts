// Messages of the page around this one: points of the model that its user drags.

import type { Handle } from "../overlay/handles";
import type { Vector } from "../scene/scene";
import type { App } from "./app";

/** Message of the page: handles to show, none to hide them. */
interface HandlesMessage {
  handles: Handle[];
}

/** Message to the page: a handle that the user has moved. */
export interface MovedMessage {
  moved: { number: number; to: Vector };
}

function isHandles(data: unknown): data is HandlesMessage {
  return typeof data === "object" && data !== null && Array.isArray((data as HandlesMessage).handles);
}

/** Shows the handles that the page around this one sends. */
export function followHandles(app: App): void {
  if (window.parent === window) return;
  window.addEventListener("message", (event: MessageEvent<unknown>) => {
    const isOurs = event.source === window.parent && event.origin === window.location.origin;
    if (!isOurs || !isHandles(event.data)) return;
    app.showHandles(event.data.handles, (number, to) => {
      const message: MovedMessage = { moved: { number, to } };
      window.parent.postMessage(message, window.location.origin);
    });
  });
}
