// From what a person's hand does to what is sent: the one place where the dead-man rule lives.
//
// - A command goes out only while a dead-man is held (Space, a pad's shoulder button, a finger, a
//   grip or a pinch in a headset).
// - When it is let go, zero goes out, once. Never the last stick again.
// - Where nothing may be sent (no link, page hidden, picture old, …) nothing is kept for later, and
//   after it the dead-man must be let go and pressed anew.
// - HOLD and other orders take the vehicle from the stick: nothing follows them, not even its zero.
// - One hand drives at a time. A pad or a headset that comes or comes back drives nothing until its
//   dead-man was seen up.

export type Source = 'keys' | 'pad' | 'touch' | 'headset';

/** Each from -1 to 1. Heave down, yaw to starboard. */
export interface Lean {
  surge: number;
  sway: number;
  heave: number;
  yaw: number;
}
export const NO_LEAN: Readonly<Lean> = { surge: 0, sway: 0, heave: 0, yaw: 0 };

/** What must hold before anything is sent. */
export interface Gate {
  is_open: boolean;
  buffered_bytes: number;
  is_hidden: boolean;
  has_focus: boolean;
  clock_is_known: boolean;
  frame_age_ms: number; // not a number before the first frame
  has_helm: boolean;
}

export type Block =
  'no_link' | 'link_behind' | 'hidden' | 'no_focus' | 'no_clock' | 'old_picture' | 'no_helm';

const MOST_BUFFERED_BYTES = 8 * 1024;
export const OLDEST_PICTURE_MS = 1000;

export function block_of(gate: Gate): Block | null {
  if (!gate.is_open) return 'no_link';
  if (gate.is_hidden) return 'hidden';
  if (!gate.has_focus) return 'no_focus';
  if (!gate.has_helm) return 'no_helm';
  if (gate.buffered_bytes > MOST_BUFFERED_BYTES) return 'link_behind';
  if (!gate.clock_is_known) return 'no_clock';
  if (!(gate.frame_age_ms <= OLDEST_PICTURE_MS)) return 'old_picture';
  return null;
}

export const BLOCK_TEXT: Readonly<Record<Block, string>> = {
  no_link: 'No link. Nothing is sent.',
  link_behind: 'The link does not keep up. Nothing is sent.',
  hidden: 'The page is hidden. Nothing is sent.',
  no_focus: 'The window has no focus. Click on it.',
  no_clock: 'The clock is not known yet.',
  old_picture: 'The picture is older than 1 s. Nothing is sent.',
  no_helm: '',
};

export interface Tick {
  /** To be sent now, or nothing. */
  lean: Lean | null;
  is_driving: boolean;
  /** The last one: the dead-man was let go. */
  is_end: boolean;
  block: Block | null;
  /** A dead-man is held but does not count before it was let go. */
  must_release: boolean;
}

interface Hand {
  is_held: boolean;
  was_up: boolean; // its dead-man has been seen up since it last lost the right to drive
  lean: Lean;
}

export class Stick {
  /** Depth hold and heading hold: the axis stays at zero. */
  keep_depth = false;
  keep_heading = false;

  // Keys and fingers are up when the page begins. A pad or a hand in a headset is not known before
  // it was looked at.
  private hands: Record<Source, Hand> = {
    keys: { is_held: false, was_up: true, lean: NO_LEAN },
    touch: { is_held: false, was_up: true, lean: NO_LEAN },
    pad: { is_held: false, was_up: false, lean: NO_LEAN },
    headset: { is_held: false, was_up: false, lean: NO_LEAN },
  };
  private driver: Source | null = null;

  /** What a hand does now. */
  set(source: Source, is_held: boolean, lean: Lean): void {
    const hand = this.hands[source];
    hand.is_held = is_held;
    hand.lean = is_held ? lean : NO_LEAN;
    if (!is_held) hand.was_up = true;
  }

  /**
   * The hand is gone (a pad unplugged, a headset taken off): as let go, and it must be seen up
   * before it drives again.
   */
  lose(source: Source): void {
    this.hands[source] = { is_held: false, was_up: false, lean: NO_LEAN };
  }

  /**
   * An order takes the vehicle from the stick: no end goes out, for its zero would overrule the
   * order. What is held must be let go first.
   */
  drop(): void {
    this.driver = null;
    for (const hand of Object.values(this.hands)) if (hand.is_held) hand.was_up = false;
  }

  get driving_hand(): Source | null {
    return this.driver;
  }

  /** Twenty times a second. */
  tick(gate: Gate): Tick {
    const block = block_of(gate);
    if (block !== null) {
      this.drop();
      return { lean: null, is_driving: false, is_end: false, block, must_release: this.any_held() };
    }

    if (this.driver !== null) {
      const hand = this.hands[this.driver];
      if (hand.is_held && hand.was_up) {
        for (const other of Object.values(this.hands)) {
          // Not its turn, also not after this.
          if (other !== hand && other.is_held) other.was_up = false;
        }
        return this.driving(hand);
      }
      this.driver = null;
      return { lean: { ...NO_LEAN }, is_driving: false, is_end: true, block, must_release: false };
    }

    for (const source of ['touch', 'keys', 'pad', 'headset'] as const) {
      const hand = this.hands[source];
      if (hand.is_held && hand.was_up) {
        this.driver = source;
        return this.driving(hand);
      }
    }
    return { lean: null, is_driving: false, is_end: false, block, must_release: this.any_held() };
  }

  private driving(hand: Hand): Tick {
    return {
      lean: this.kept(hand.lean),
      is_driving: true,
      is_end: false,
      block: null,
      must_release: false,
    };
  }

  private any_held(): boolean {
    return Object.values(this.hands).some((hand) => hand.is_held);
  }

  private kept(lean: Lean): Lean {
    return {
      surge: within_one(lean.surge),
      sway: within_one(lean.sway),
      heave: this.keep_depth ? 0 : within_one(lean.heave),
      yaw: this.keep_heading ? 0 : within_one(lean.yaw),
    };
  }
}

function within_one(value: number): number {
  return Number.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0;
}

/** Full stick of yaw. The vehicle's own conduct takes of it what it can. */
const FULL_YAW_RAD_S = 0.5;

/** m/s, m/s, m/s down, rad/s to starboard, as the server wants them. */
export function velocity_of(
  lean: Lean,
  most_speed_m_s: number,
  share: number,
): [number, number, number, number] {
  const speed_m_s = most_speed_m_s * share;
  const rounded = (value: number): number => Math.round(value * 1000) / 1000 + 0; // no minus zero
  return [
    rounded(lean.surge * speed_m_s),
    rounded(lean.sway * speed_m_s),
    rounded(lean.heave * speed_m_s),
    rounded(lean.yaw * FULL_YAW_RAD_S * share),
  ];
}
