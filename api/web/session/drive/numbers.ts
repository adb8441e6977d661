// The number and the validity that each command carries.

export const STICK_IS_VALID_MS = 400;
export const ORDER_IS_VALID_MS = 3000;

export interface Stamp {
  number: number;
  at: number; // when it was given
  until: number;
}

/**
 * Numbers rise with each command of the seat, also over a reload of the page, which remembers none:
 * so a number is the session's clock, or one more than the last, and the welcome tells the seat's
 * last.
 */
export class CommandNumbers {
  private last = 0;

  /** The seat's last number, as the server has it. */
  heard(last: number): void {
    if (Number.isSafeInteger(last)) this.last = Math.max(this.last, last);
  }

  /**
   * Nothing as long as the session's clock is not known: a command without an end is never sent.
   */
  stamp(clock_ms: number, valid_ms: number): Stamp | null {
    if (!Number.isFinite(clock_ms)) return null;
    this.last = Math.max(this.last + 1, Math.floor(clock_ms));
    const at = Math.floor(clock_ms);
    return { number: this.last, at, until: at + valid_ms };
  }
}
