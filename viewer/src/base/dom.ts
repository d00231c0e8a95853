// Helpers for the document: elements, icon buttons, saved files.

type Child = Node | string | null;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** Creates an element with attributes and children; attributes `on...` add event listeners. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (typeof value === "boolean") element.toggleAttribute(name, value);
    else element.setAttribute(name, String(value));
  }
  element.append(...children.filter((c) => c !== null));
  return element;
}

/** Creates a button with an icon (SVG path, 24 by 24) and an accessible name. */
export function iconButton(name: string, path: string, onclick: () => void): HTMLButtonElement {
  const button = h("button", { type: "button", class: "icon", title: name, "aria-label": name, onclick });
  button.innerHTML = iconSvg(path);
  return button;
}

/** Returns the SVG markup of an icon path. */
export function iconSvg(path: string): string {
  return `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>`;
}

/** Starts the download of a file by the browser. */
export function saveFile(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = h("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
