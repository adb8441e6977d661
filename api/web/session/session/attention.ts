// What somebody looks at, for those who want it kept: the thing that holds the gaze long enough.
export type GazeBy = 'head' | 'pointer';
export interface Gaze {
  on: string; // by name; empty: nothing that has one
  by: GazeBy;
}

/** Shorter glances are passings by: people fixate things for a third of a second or more. */
export const GLANCE_MS = 300;

export class Attention {
  private told: Gaze | null = null;
  private now: Gaze | null = null;
  private since_ms = 0;

  /** @return what is to be told, once it has lasted */
  take(gaze: Gaze, now_ms: number): Gaze | null {
    if (this.now === null || this.now.on !== gaze.on) this.since_ms = now_ms;
    this.now = gaze;
    const is_told = this.told !== null && this.told.on === gaze.on;
    if (is_told || now_ms - this.since_ms < GLANCE_MS) return null;
    this.told = gaze;
    return gaze;
  }

  /** Whether anything was told since the beginning, or since this was asked. */
  ends(): boolean {
    const was_told = this.told !== null;
    this.told = this.now = null;
    return was_told;
  }
}
