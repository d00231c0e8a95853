// What the user has chosen to see.

export interface Settings {
  /** Name of the field that colours the bodies, "" for none. */
  field: string;
  deformation: number;
  thickness: number;
  ghost: boolean;
  labels: boolean;
  nodes: boolean;
  reactions: boolean;
  markers: boolean;
  grid: boolean;
  /** Whether the film begins again at its end. */
  repeat: boolean;
}

export type Changed = (name: keyof Settings) => void;

export class Choice {
  readonly values: Settings = {
    ...{ field: "", deformation: 1, thickness: 1, ghost: false, labels: true, nodes: false },
    ...{ reactions: true, markers: true, grid: true, repeat: false },
  };
  private readonly listeners: Changed[] = [];

  listen(listener: Changed): void {
    this.listeners.push(listener);
  }

  set<K extends keyof Settings>(name: K, value: Settings[K]): void {
    if (this.values[name] === value) return;
    this.values[name] = value;
    for (const listener of this.listeners) listener(name);
  }

  toggle(name: "ghost" | "labels" | "nodes" | "reactions" | "markers" | "grid" | "repeat"): void {
    this.set(name, !this.values[name]);
  }
}
