// Left margin that all charts share, so that their abscissas are aligned.

/** Widths of the vertical axes. The widest one counts for all charts. */
export class SharedMargin {
  private width = 0;
  private drawn = 0;
  private listeners: (() => void)[] = [];

  /** Returns the margin for an axis of a width. */
  request(width: number): number {
    this.width = Math.max(this.width, Math.ceil(width));
    return this.width;
  }

  /** Adds a listener for changes of the margin. Returns a function that removes it. */
  listen(listener: () => void): () => void {
    this.listeners.push(listener);
    return () => {
      this.listeners = this.listeners.filter((other) => other !== listener);
    };
  }

  /** Draws all charts again if one of them needs a larger margin. */
  settle(): void {
    while (this.drawn !== this.width) {
      this.drawn = this.width;
      for (const listener of this.listeners) listener();
    }
  }
}
