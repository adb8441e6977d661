// Whether nobody has touched anything for a while.
export const KIOSK_WAITS_MS = 120_000;

/** Calls back once nothing was touched for so long; again only after it was touched. */
export class Idle {
  private touched_ms: number;
  private is_told = true; // nothing to go back from yet
  constructor(now_ms: number) {
    this.touched_ms = now_ms;
  }
  touch(now_ms: number): void {
    this.touched_ms = now_ms;
    this.is_told = false;
  }
  /** True once, when it is time to go back. */
  is_over(now_ms: number): boolean {
    if (this.is_told || now_ms - this.touched_ms < KIOSK_WAITS_MS) return false;
    this.is_told = true;
    return true;
  }
}
