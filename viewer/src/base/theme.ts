// Colour theme (dark or light): that of the system until the user selects one.

const KEY = "ancf-theme";

function storedTheme(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function systemTheme(): string {
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** True if the page has the dark theme. */
export function isDark(): boolean {
  return document.documentElement.dataset.theme === "dark";
}

export class Theme {
  constructor(private readonly changed: () => void) {
    document.documentElement.dataset.theme = storedTheme() ?? systemTheme();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.follow());
  }

  /** Applies the theme that the user selected in this page or another one. */
  follow(): void {
    this.set(storedTheme() ?? systemTheme());
  }

  toggle(): void {
    const next = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(KEY, next);
    } catch {
      // Pages opened from a file may have no storage. The selection then lasts until the page is closed.
    }
    this.set(next);
  }

  private set(name: string): void {
    document.documentElement.dataset.theme = name;
    this.changed();
  }
}
