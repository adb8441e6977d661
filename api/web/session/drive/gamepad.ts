// A gamepad of the standard mapping: left stick surge and yaw, right stick heave and sway, a
// shoulder button is the dead-man. A pad that is plugged in, or that comes and goes, does nothing
// by itself.
import { beyond } from '../../look/beyond';
import type { Lean, Stick } from './stick';

const DEAD_ZONE = 0.12;
const SHOULDERS = [4, 5];

/** The part of a Gamepad that is read. */
export interface PadLike {
  readonly index: number;
  readonly connected: boolean;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Nothing in the middle, then evenly up to one. */
export function beyond_dead_zone(value: number): number {
  return beyond(value, DEAD_ZONE, 1);
}

export function pad_lean(pad: PadLike): Lean {
  const axis = (i: number): number => beyond_dead_zone(pad.axes[i] ?? 0);
  return { surge: 0 - axis(1), yaw: axis(0), sway: axis(2), heave: axis(3) };
}

export class PadReader {
  private index: number | null = null;

  /** Looks at the pads and tells the stick. True: a pad is there. */
  look(pads: readonly (PadLike | null)[], stick: Stick): boolean {
    const there = pads.filter((pad): pad is PadLike => pad !== null && pad.connected);
    let pad = there.find((it) => it.index === this.index);
    if (pad === undefined) {
      // Another pad, or none: whatever was held is let go.
      stick.lose('pad');
      pad = there[0];
      this.index = pad?.index ?? null;
    }
    if (pad === undefined) return false;
    const held = SHOULDERS.some((button) => pad.buttons[button]?.pressed === true);
    stick.set('pad', held, pad_lean(pad));
    return true;
  }
}
