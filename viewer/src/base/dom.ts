// Elements in one line, numbers as text.

type Child = Node | string | null;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** An element with attributes (`on...` are listeners) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (typeof value === "boolean") made.toggleAttribute(name, value);
    else made.setAttribute(name, String(value));
  }
  made.append(...children.filter((c) => c !== null));
  return made;
}

/** A button with a picture (path of an svg of 24 by 24) and a name for those who do not see it. */
export function iconButton(name: string, path: string, onclick: () => void): HTMLButtonElement {
  const made = h("button", { type: "button", class: "icon", title: name, "aria-label": name, onclick });
  made.innerHTML = icon(path);
  return made;
}

export function icon(path: string): string {
  return `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>`;
}

/** A number for people: four digits, an exponent where it saves zeros. */
export function text(x: number, digits = 4): string {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  const rounded = Number(x.toPrecision(digits));
  const plain = size >= 1e-3 && size < 1e5;
  const short = plain ? String(rounded) : rounded.toExponential().replace("e+", "e");
  return short.replace(/-/g, "−");
}

/** Number and unit. */
export function quantity(x: number, unit: string): string {
  return unit === "" ? text(x) : `${text(x)} ${unit}`;
}

/** Gives the browser a file to save. */
export function save(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = h("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
