// Keys: what they do, and the list of them.

import { h } from "../base/dom";

/** Names of keys (as of KeyboardEvent.key), what they do in words, what they do. */
export type Key = [keys: string[], words: string, act: (event: KeyboardEvent) => void];

/** True if the element needs the key itself. */
function own(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement && target.type === "range")
    return /^(Arrow|Home|End|Page)/.test(key);
  if (target instanceof HTMLInputElement && target.type === "checkbox") return key === " ";
  if (/^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName) || target.isContentEditable) return true;
  return /^(BUTTON|SUMMARY|A)$/.test(target.tagName) && (key === " " || key === "Enter");
}

export function listen(keys: Key[]): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || own(event.target, event.key)) return;
    if (document.querySelector("dialog[open]")) return;
    const found = keys.find(([names]) => names.includes(event.key));
    if (!found) return;
    event.preventDefault();
    found[2](event);
  });
}

const SHOWN: Record<string, string> = { " ": "space", ArrowLeft: "←", ArrowRight: "→" };

/** The list of keys as a dialog. */
export function help(keys: Key[]): HTMLDialogElement {
  const rows = keys.map(([names, words]) => {
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, h("kbd", {}, SHOWN[names[0]] ?? names[0])),
      h("td", {}, words),
    );
  });
  const mouse: [string, string][] = [
    ["drag", "turn (one finger)"],
    ["right drag", "move (two fingers)"],
    ["wheel", "zoom (pinch)"],
    ["drag in a chart", "set the time"],
    ["Ctrl, wheel there", "zoom; double click: all"],
  ];
  rows.push(...mouse.map(([how, words]) => h("tr", {}, h("th", { scope: "row" }, how), h("td", {}, words))));
  const half = Math.ceil(rows.length / 2);
  const close = h("button", { type: "button", class: "plain", onclick: () => dialog.close() }, "Close");
  const dialog = h(
    "dialog",
    { class: "help", "aria-label": "keys" },
    h("h2", {}, "Keys and mouse"),
    h(
      "div",
      { class: "columns" },
      h("table", {}, h("tbody", {}, ...rows.slice(0, half))),
      h("table", {}, h("tbody", {}, ...rows.slice(half))),
    ),
    close,
  );
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
