// What the page of hands asks of the page of a session: how fast the camera shall turn and zoom.
// It says so over and over; a wish ends by itself, also one that was held up on its way.

/** A wish counts so long after the moment of its picture. */
export const WISH_IS_VALID_MS = 300;

export interface Turn {
  pan_deg_s: number; // to starboard
  tilt_deg_s: number; // up
  zoom_per_s: number; // of the logarithm of the zoom: in is more than 0
}
export interface CameraWish extends Turn {
  picture_ms: number; // when the picture was taken that it was made of
}

export const NO_TURN: Readonly<Turn> = { pan_deg_s: 0, tilt_deg_s: 0, zoom_per_s: 0 };

/** Of a time of this window by `performance.now()`: that of the clock all windows share. */
export function shared_ms(here_ms: number): number {
  return performance.timeOrigin + here_ms;
}

/** No hand asks for more. */
export const MOST = { pan_deg_s: 20, tilt_deg_s: 20, zoom_per_s: 0.7 } as const;

export function is_rest(wish: Turn): boolean {
  return wish.pan_deg_s === 0 && wish.tilt_deg_s === 0 && wish.zoom_per_s === 0;
}

const NAME = 'slackwater camera wish';

export function wish_message(wish: CameraWish): Record<string, unknown> {
  return { is: NAME, ...wish };
}

/** Null: it is something else, or asks for what no hand asks for. */
export function read_wish(said: unknown): CameraWish | null {
  if (typeof said !== 'object' || said === null) return null;
  const it = said as Record<string, unknown>;
  if (it.is !== NAME) return null;
  const number = (value: unknown, most: number): number =>
    typeof value === 'number' && Math.abs(value) <= most ? value : Number.NaN;
  const wish: CameraWish = {
    pan_deg_s: number(it.pan_deg_s, MOST.pan_deg_s),
    tilt_deg_s: number(it.tilt_deg_s, MOST.tilt_deg_s),
    zoom_per_s: number(it.zoom_per_s, MOST.zoom_per_s),
    picture_ms: number(it.picture_ms, Number.MAX_VALUE),
  };
  return Object.values(wish).every(Number.isFinite) ? wish : null;
}

const ANSWER = 'slackwater camera answer';

export function wish_answer(text: string): Record<string, unknown> {
  return { is: ANSWER, text };
}

/** What the page of a session makes of wishes, in words. */
export function read_wish_answer(said: unknown): string | null {
  if (typeof said !== 'object' || said === null) return null;
  const it = said as Record<string, unknown>;
  return it.is === ANSWER && typeof it.text === 'string' ? it.text.slice(0, 200) : null;
}
