// Summary of the run: messages, numbers, text of the model.

import { h, saveFile } from "../base/dom";
import type { Scene } from "../scene/scene";

export function messageList(scene: Scene): HTMLElement {
  const items = scene.messages.map((m) => h("li", { class: /^error/i.test(m) ? "error" : "" }, m));
  const list =
    items.length > 0 ? h("ul", { class: "messages" }, ...items) : h("p", { class: "empty" }, "No messages.");
  return h("section", {}, h("h2", {}, "Messages"), list);
}

export function summaryTable(scene: Scene): HTMLElement {
  const row = (name: string, value: string, attributes = {}) =>
    h("tr", {}, h("th", { scope: "row" }, name), h("td", attributes, value));
  const rows = scene.summary.map(([name, value]) => row(name, value));
  if (scene.units) {
    const { length, time, force } = scene.units;
    rows.push(row("units", `${length}, ${time}, ${force}`));
  }
  if (!scene.summary.some(([name]) => name === "program")) rows.push(row("program", scene.program));
  if (scene.sha256) rows.push(row("model SHA-256", scene.sha256, { class: "hash" }));
  return h("section", {}, h("h2", {}, "Summary"), h("table", {}, h("tbody", {}, ...rows)));
}

/** Text of the model, with buttons to copy and save it. */
export function modelText(scene: Scene): HTMLElement {
  const copy = h("button", { type: "button", class: "plain" }, "Copy");
  const source = h("pre", { tabindex: 0, "aria-label": "text of the model" }, scene.text);
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(scene.text);
      copy.textContent = "Copied";
    } catch {
      // Pages opened from a file may have no access to the clipboard. The text is selected instead.
      getSelection()?.selectAllChildren(source);
      copy.textContent = "Selected: press Ctrl+C";
    }
  });
  const file = `${scene.title.replace(/[^\w-]+/g, "_") || "model"}.toml`;
  const content = () => new Blob([scene.text], { type: "application/toml" });
  const onclick = () => saveFile(file, content());
  const save = h("button", { type: "button", class: "plain", onclick }, "Save");
  return h("details", {}, h("summary", {}, "Model"), h("div", { class: "buttons" }, copy, save), source);
}
