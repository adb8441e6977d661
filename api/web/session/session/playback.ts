// A log that is watched again: where the head is on its way from the beginning to the end, and
// which action comes next. Seconds of the run.
import { time_text, type TimeZoneChoice } from '../look/units';
import { as_number, as_object, type Action, type Json } from './message';

export interface Playback {
  from_s: number;
  to_s: number;
  /** The number of the last action before the head; 0: none. */
  seen: number;
}
export function read_playback(message: Json): Playback | null {
  const it = as_object(message.playback);
  const from_s = as_number(it?.from_s);
  const to_s = as_number(it?.to_s);
  if (from_s === null || to_s === null) return null;
  return { from_s, to_s, seen: as_number(message.seen) ?? 0 };
}
export const RATES: readonly number[] = [0.5, 1, 2, 5, 10, 50];

const SAME_S = 1e-6;
const SEEK_EVERY_MS = 100;
const STEPS_OF_A_WAY: readonly number[] = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];

/** When an action is told: one after the last row of the log with that. */
export function time_of(action: Action, playback: Playback): number {
  return Math.min(playback.to_s, Math.max(playback.from_s, action.time_s));
}

export function share_of(time_s: number, { from_s, to_s }: Playback): number {
  return to_s > from_s ? Math.min(1, Math.max(0, (time_s - from_s) / (to_s - from_s))) : 0;
}

/** What an arrow key moves the head: about a hundredth of the way, and a second at least. */
export function key_step_s({ from_s, to_s }: Playback): number {
  const wanted_s = (to_s - from_s) / 100;
  return STEPS_OF_A_WAY.filter((it) => it <= wanted_s).at(-1) ?? 1;
}

/** Where a key takes the head; null: it is no key of a scrubber. */
export function key_time_s(key: string, head_s: number, playback: Playback): number | null {
  const step_s = key_step_s(playback);
  const to = (time_s: number): number => Math.min(playback.to_s, Math.max(playback.from_s, time_s));
  switch (key) {
    case 'ArrowRight':
    case 'ArrowUp':
      return to(head_s + step_s);
    case 'ArrowLeft':
    case 'ArrowDown':
      return to(head_s - step_s);
    case 'PageUp':
      return to(head_s + 10 * step_s);
    case 'PageDown':
      return to(head_s - 10 * step_s);
    case 'Home':
      return playback.from_s;
    case 'End':
      return playback.to_s;
    default:
      return null;
  }
}

/** The first moment after the head at which somebody did something. */
export function next_action_s(
  actions: readonly Action[],
  head_s: number,
  playback: Playback,
): number | null {
  const next = actions.find((it) => time_of(it, playback) > head_s + SAME_S);
  return next === undefined ? null : time_of(next, playback);
}

/**
 * The last one before it. While it plays the one that was just passed does not count: who presses
 * twice goes back two.
 */
export function previous_action_s(
  actions: readonly Action[],
  head_s: number,
  playback: Playback,
  playing_rate: number,
): number | null {
  const before_s = head_s - Math.max(SAME_S, playing_rate);
  const previous = actions.filter((it) => time_of(it, playback) < before_s).at(-1);
  return previous === undefined ? null : time_of(previous, playback);
}

/** Minutes and seconds, with hours where there are any: 1:02:03. */
export function clock_text(time_s: number): string {
  const whole_s = Math.max(0, Math.floor(time_s + SAME_S));
  const digits = (value: number): string => String(value).padStart(2, '0');
  const [hours, minutes, seconds] = [
    Math.floor(whole_s / 3600),
    Math.floor(whole_s / 60) % 60,
    whole_s % 60,
  ];
  return hours > 0
    ? `${hours}:${digits(minutes)}:${digits(seconds)}`
    : `${minutes}:${digits(seconds)}`;
}

/** "12:34 of 30:00". */
export function way_text(head_s: number, { from_s, to_s }: Playback): string {
  return `${clock_text(head_s - from_s)} of ${clock_text(to_s - from_s)}`;
}

/** What a screen reader says of the head: the moment, and how far it is. */
export function value_text(
  head_s: number,
  start_utc_ms: number,
  playback: Playback,
  zone: TimeZoneChoice,
): string {
  const way = way_text(head_s, playback);
  return Number.isFinite(start_utc_ms)
    ? `${time_text(start_utc_ms + 1000 * head_s, zone, true)}, ${way}`
    : way;
}

export function rate_text(rate: number): string {
  return `${rate}×`;
}

/**
 * Seeks while a hand drags: ten a second at most, the last one always. Until the server has
 * answered the place that is wanted is shown, and not that of a frame on its way.
 */
export class Seeker {
  private wanted_s: number | null = null;
  private is_sent = false;
  private sent_ms = -Infinity;
  private is_waiting = false;
  private count = 0;

  /** @param send  false: it could not be sent. `on_answer` is called when it was answered. */
  constructor(
    private readonly send: (time_s: number, on_answer: () => void) => boolean,
    private readonly now_ms: () => number,
    private readonly after: (wait_ms: number, run: () => void) => void,
  ) {}

  want(time_s: number): void {
    this.wanted_s = time_s;
    this.is_sent = false;
    if (this.is_waiting) return;
    const wait_ms = this.sent_ms + SEEK_EVERY_MS - this.now_ms();
    if (wait_ms <= 0) {
      this.send_now();
      return;
    }
    this.is_waiting = true;
    this.after(wait_ms, () => {
      this.is_waiting = false;
      if (!this.is_sent) this.send_now();
    });
  }

  /** Where the head is shown. */
  shown_s(head_s: number): number {
    return this.wanted_s ?? head_s;
  }

  /** The link is new or gone. */
  forget(): void {
    this.wanted_s = null;
    this.is_sent = true;
  }

  private send_now(): void {
    if (this.wanted_s === null) return;
    this.is_sent = true;
    this.sent_ms = this.now_ms();
    this.count += 1;
    const count = this.count;
    const is_out = this.send(this.wanted_s, () => {
      if (count === this.count && this.is_sent) this.wanted_s = null;
    });
    if (!is_out) this.wanted_s = null;
  }
}
