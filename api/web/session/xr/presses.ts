// Presses that began before the eyes of the page: on the board, for a throw, on the table. A hand
// that was lost may have been closed meanwhile: it must be seen open before a press of it counts.
import { SIDES, type HandReading, type Side } from './reading';

export class Presses {
  private readonly must_open = new Set<Side>(SIDES);
  private readonly held = new Set<Side>();
  private readonly begun = new Set<Side>();

  /** Each frame. */
  look(hands: readonly HandReading[]): void {
    this.begun.clear();
    for (const side of SIDES) {
      const hand = hands.find((it) => it.side === side);
      if (hand === undefined || !hand.is_tracked) this.lose(side);
      else if (!hand.is_pressed) {
        this.must_open.delete(side);
        this.held.delete(side);
      } else if (!this.must_open.has(side) && !this.held.has(side)) {
        this.held.add(side);
        this.begun.add(side);
      }
    }
  }

  /** The headset is hidden, or counts from elsewhere. */
  lose_all(): void {
    for (const side of SIDES) this.lose(side);
  }

  /** It is pressed, and was seen open before. */
  is_held(side: Side): boolean {
    return this.held.has(side);
  }
  /** It was pressed in this frame. */
  begins(side: Side): boolean {
    return this.begun.has(side);
  }

  private lose(side: Side): void {
    this.must_open.add(side);
    this.held.delete(side);
    this.begun.delete(side);
  }
}
