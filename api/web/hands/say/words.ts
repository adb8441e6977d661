// What is seen and asked, in words.
import { is_rest, WISH_IS_VALID_MS, type Turn } from '../../look/camera_wish';
import type { Seen } from '../gesture/follower';

export const SEEN_TEXT: Readonly<Record<Seen, string>> = {
  none: 'No hand is seen.',
  unsure: 'A hand is seen, but not surely.',
  jump: 'The hand jumped.',
  open: 'Open hand: at rest.',
  pinch: 'Pinch: move it to pan and tilt.',
  two: 'Two fingers: apart zooms in, together out.',
  fist: 'Fist: at rest.',
  other: 'A hand at rest.',
};

export function asked_text(wish: Turn): string {
  if (is_rest(wish)) return 'Nothing is asked.';
  const parts: string[] = [];
  const turn = (deg_s: number, more: string, less: string): void => {
    if (deg_s !== 0) parts.push(`${Math.abs(deg_s).toFixed(1)}°/s ${deg_s > 0 ? more : less}`);
  };
  turn(wish.pan_deg_s, 'to starboard', 'to port');
  turn(wish.tilt_deg_s, 'up', 'down');
  if (wish.zoom_per_s !== 0) parts.push(wish.zoom_per_s > 0 ? 'zoom in' : 'zoom out');
  return `Asked: ${parts.join(', ')}.`;
}

/** Empty where the detector keeps up. */
export function slow_text(took_ms: number): string {
  if (took_ms <= WISH_IS_VALID_MS) return '';
  const most_s = WISH_IS_VALID_MS / 1000;
  const took_s = (took_ms / 1000).toFixed(1);
  return `Too slow to steer: a picture takes ${took_s} s, ${most_s} s is the most.`;
}
