// Keyboard shortcuts: key events, and the help dialog.

import { h } from "../base/dom";

/** Names of the keys (`KeyboardEvent.key`), description, action. */
export type Shortcut = [keys: string[], description: string, action: (event: KeyboardEvent) => void];

/** True if the element handles the key itself. */
function handlesKey(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement && target.type === "range")
    return /^(Arrow|Home|End|Page)/.test(key);
  if (target instanceof HTMLInputElement && target.type === "checkbox") return key === " ";
  if (/^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName) || target.isContentEditable) return true;
  return /^(BUTTON|SUMMARY|A)$/.test(target.tagName) && (key === " " || key === "Enter");
}

export function listenToKeys(shortcuts: Shortcut[]): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || handlesKey(event.target, event.key)) return;
    if (document.querySelector("dialog[open]")) return;
    const found = shortcuts.find(([keys]) => keys.includes(event.key));
    if (!found) return;
    event.preventDefault();
    found[2](event);
  });
}

const KEY_LABELS: Record<string, string> = { " ": "space", ArrowLeft: "←", ArrowRight: "→" };

const MOUSE: [gesture: string, description: string][] = [
  ["drag", "rotate (one finger)"],
  ["right drag", "pan (two fingers)"],
  ["wheel", "zoom (pinch)"],
  ["drag in a chart", "set the time"],
  ["Ctrl + wheel there", "zoom; double click: reset"],
];

/** Creates the dialog with the list of shortcuts. */
export function helpDialog(shortcuts: Shortcut[]): HTMLDialogElement {
  const row = (name: string | Node, description: string) =>
    h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, description));
  const rows = [
    ...shortcuts.map(([keys, description]) => row(h("kbd", {}, KEY_LABELS[keys[0]] ?? keys[0]), description)),
    ...MOUSE.map(([gesture, description]) => row(gesture, description)),
  ];
  const half = Math.ceil(rows.length / 2);
  const table = (part: HTMLElement[]) => h("table", {}, h("tbody", {}, ...part));
  const close = h("button", { type: "button", class: "plain", onclick: () => dialog.close() }, "Close");
  const dialog = h(
    "dialog",
    { class: "help", "aria-label": "keyboard and mouse" },
    h("h2", {}, "Keyboard and mouse"),
    h("div", { class: "columns" }, table(rows.slice(0, half)), table(rows.slice(half))),
    close,
  );
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
