// What somebody looks at, for those who want it kept: the thing that holds the gaze long enough.
export type GazeBy = 'head' | 'pointer';
export interface Gaze {
  on: string; // by name; empty: nothing that has one
  by: GazeBy;
}

export interface Gazed {
  /** What lies under a place of the window, by name; empty: nothing that has one. */
  under(x: number, y: number): string;
  /** What is ahead, where there is an ahead; empty likewise. */
  ahead(): string;
}

/** Shorter glances are passings by. A third of a second is chosen: not measured, not a standard. */
export const GLANCE_MS = 333;

export class Attention {
  private told: Gaze | null = null;
  private now: Gaze | null = null;
  private since_ms = 0;
  private link = 0;

  /** @return what is to be told, once it has lasted; by what it is seen counts, too */
  take(gaze: Gaze, now_ms: number): Gaze | null {
    if (this.now === null || this.now.on !== gaze.on) this.since_ms = now_ms;
    this.now = gaze;
    const is_told = this.told?.on === gaze.on && this.told.by === gaze.by;
    if (is_told || now_ms - this.since_ms < GLANCE_MS) return null;
    this.told = gaze;
    return gaze;
  }

  /** Over a new link nothing was told yet, nor where it could not be sent. */
  tell(gaze: Gaze, now_ms: number, link: number, send: (news: Gaze) => boolean): void {
    if (link !== this.link) this.ends();
    this.link = link;
    const news = this.take(gaze, now_ms);
    if (news !== null && !send(news)) this.ends();
  }

  /** All begins anew. @return whether anything was told since the beginning, or since this. */
  ends(): boolean {
    const was_told = this.told !== null;
    this.told = this.now = null;
    return was_told;
  }
}
