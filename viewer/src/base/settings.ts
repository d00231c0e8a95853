// Display options of the user.

export interface Settings {
  /** Name of the field that colours the bodies, "" for none. */
  field: string;
  /** Name of the colour map, "" for the automatic one. */
  colourMap: string;
  /** Smallest and largest coloured value of fields by name; null for those of the data. */
  limits: Record<string, [number | null, number | null]>;
  /** Scale factor of the displacements from the reference configuration. */
  deformation: number;
  /** Scale factor of the sections. */
  thickness: number;
  ghost: boolean;
  labels: boolean;
  nodes: boolean;
  /** True if the edges of shell elements are drawn. */
  mesh: boolean;
  reactions: boolean;
  markers: boolean;
  grid: boolean;
  shadows: boolean;
  /** True if the animation restarts at its end. */
  repeat: boolean;
}

export type Switch =
  | "ghost"
  | "labels"
  | "nodes"
  | "mesh"
  | "reactions"
  | "markers"
  | "grid"
  | "shadows"
  | "repeat";

/** Settings with listeners for their changes. */
export class SettingsStore {
  readonly values: Settings = {
    ...{
      field: "",
      colourMap: "",
      limits: {},
      deformation: 1,
      thickness: 1,
      ghost: false,
      labels: true,
      nodes: false,
      mesh: true,
    },
    ...{ reactions: true, markers: true, grid: true, shadows: true, repeat: false },
  };
  private readonly listeners: ((name: keyof Settings) => void)[] = [];

  listen(listener: (name: keyof Settings) => void): void {
    this.listeners.push(listener);
  }

  set<K extends keyof Settings>(name: K, value: Settings[K]): void {
    if (this.values[name] === value) return;
    this.values[name] = value;
    for (const listener of this.listeners) listener(name);
  }

  toggle(name: Switch): void {
    this.set(name, !this.values[name]);
  }
}
