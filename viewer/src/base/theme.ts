// Dark or light: as the system says, until the user says otherwise.

const KEY = "ancf-theme";

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function system(): string {
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export class Theme {
  constructor(private readonly changed: () => void) {
    document.documentElement.dataset.theme = stored() ?? system();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () =>
      this.set(stored() ?? system()),
    );
  }

  toggle(): void {
    const next = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(KEY, next);
    } catch {
      // Pages from disk may have no storage: then the choice lasts as long as the page.
    }
    this.set(next);
  }

  private set(name: string): void {
    document.documentElement.dataset.theme = name;
    this.changed();
  }
}
