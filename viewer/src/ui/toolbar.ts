// Buttons of the 3-D view and of the header.

import { iconButton } from "../base/dom";
import { ICONS } from "../base/icons";
import type { Theme } from "../base/theme";
import { STANDARD_VIEWS } from "../view/camera";
import type { App } from "./app";
import { canRecord, saveImage, saveVideo } from "./export";

const VIEW_LABELS = { front: "Front", top: "Top", side: "Side", oblique: "3-D" };

export function addButtons(app: App, theme: Theme, showHelp: () => void): void {
  const { tools, actions } = app.layout;
  for (const [i, view] of STANDARD_VIEWS.entries()) {
    const button = iconButton(`${VIEW_LABELS[view]} view (${i + 1})`, "", () =>
      app.viewport?.camera.setView(view),
    );
    button.textContent = VIEW_LABELS[view];
    button.className = "text-button";
    tools.append(button);
  }
  tools.append(iconButton("Fit (f)", ICONS.fit, () => app.viewport?.camera.fit()));
  actions.append(iconButton("Save image", ICONS.image, () => saveImage(app)));
  if (canRecord()) {
    const video = iconButton("Save video", ICONS.video, () => saveVideo(app, video));
    actions.append(video);
  }
  actions.append(
    iconButton("Dark or light theme (t)", ICONS.theme, () => theme.toggle()),
    iconButton("Keyboard and mouse (?)", ICONS.help, showHelp),
  );
}
