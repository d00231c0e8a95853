// Entry point: builds the viewer and loads the scene of the page.

import "uplot/dist/uPlot.min.css";
import "./styles/page.css";
import "./styles/stage.css";
import "./styles/overlay.css";
import "./styles/panel.css";
import "./styles/phone.css";
import { Theme } from "./base/theme";
import { SceneError } from "./scene/scene";
import { followScene } from "./scene/source";
import { createApi } from "./ui/api";
import { App } from "./ui/app";
import { followHandles } from "./ui/embedding";
import { helpDialog, listenToKeys } from "./ui/keyboard";
import { shortcuts } from "./ui/shortcuts";
import { addButtons } from "./ui/toolbar";

function start(): void {
  const app = new App();
  const theme = new Theme(() => app.applyTheme());
  const showHelp = () => dialog.showModal();
  const list = shortcuts(app, theme, showHelp);
  const dialog = helpDialog(list);
  document.body.append(dialog);
  addButtons(app, theme, showHelp);
  listenToKeys(list);
  followHandles(app);
  Object.assign(window, { ancf: createApi(app, load(app)) });
}

/** Loads the scene of the page. Resolves to false if it cannot be read. */
async function load(app: App): Promise<boolean> {
  try {
    await followScene(document, {
      scene: (scene) => app.load(scene),
      connection: (message) => app.layout.showConnection(message),
    });
    return true;
  } catch (error) {
    const known = error instanceof SceneError;
    app.layout.showError(known ? error.message : `The data of this page are damaged (${String(error)}).`);
    return false;
  }
}

start();
