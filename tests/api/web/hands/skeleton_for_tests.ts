// A hand of known bones, bent, turned and placed as is asked, before a camera of known focal
// length: where its 21 landmarks are in the picture is exact geometry.
import type { Hand, Point } from 'page/gesture/hand';

type Vector = readonly [number, number, number];

/** From wrist to middle knuckle. */
export const PALM_M = 0.09;
/** Heights of the picture: a webcam that sees 53 degrees up and down. */
export const FOCAL = 1;

/** Each finger: knuckle in the palm (x to the thumb's side, y to the tips), bones, outward lean. */
const FINGERS: { at: Vector; bones_m: number[]; lean_deg: number }[] = [
  { at: [0.022, 0.088, 0], bones_m: [0.042, 0.025, 0.02], lean_deg: 3 },
  { at: [0, PALM_M, 0], bones_m: [0.046, 0.029, 0.021], lean_deg: 0 },
  { at: [-0.019, 0.083, 0], bones_m: [0.042, 0.028, 0.021], lean_deg: -3 },
  { at: [-0.036, 0.072, 0], bones_m: [0.034, 0.02, 0.018], lean_deg: -6 },
];
const THUMB: Vector[] = [
  [0.022, 0.022, 0.01],
  [0.042, 0.048, 0.015],
  [0.055, 0.072, 0.015],
  [0.065, 0.095, 0.015],
];

export interface Posed {
  /** Bend of each joint of index, middle, ring and little finger towards the palm. */
  curl_deg: readonly [number, number, number, number];
  /** Of index and middle finger away from each other. */
  apart_deg?: number;
  /** The thumb's tip so far from the index's. */
  pinch_gap_m?: number;
  /** Middle of the palm's bone before the camera: to its right, up, away. */
  right_m?: number;
  up_m?: number;
  away_m?: number;
  /** About the view, then about the upright, then about the level axis. */
  roll_deg?: number;
  yaw_deg?: number;
  pitch_deg?: number;
}

const RAD = Math.PI / 180;
const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const rotated = (axis: 0 | 1 | 2, deg: number, v: Vector): Vector => {
  const [c, s] = [Math.cos(deg * RAD), Math.sin(deg * RAD)];
  const out: [number, number, number] = [v[0], v[1], v[2]];
  const [i, j] = ([[1, 2], [2, 0], [0, 1]] as const)[axis]; // prettier-ignore
  out[i] = c * v[i] - s * v[j];
  out[j] = s * v[i] + c * v[j];
  return out;
};

/** The palm looks at the camera (+z), fingers up, thumb to the picture's right: a right hand. */
export function bones_of(posed: Posed): Vector[] {
  const fingers = FINGERS.map(({ at, bones_m, lean_deg }, f) => {
    const points: Vector[] = [at];
    const outward =
      f === 0 ? (posed.apart_deg ?? 0) / 2 : f === 1 ? -(posed.apart_deg ?? 0) / 2 : 0;
    let bend_deg = 0;
    for (const length_m of bones_m) {
      bend_deg += posed.curl_deg[f]!;
      const bone = rotated(2, -(lean_deg + outward), rotated(0, bend_deg, [0, length_m, 0]));
      points.push(add(points[points.length - 1]!, bone));
    }
    return points;
  });
  const thumb = [...THUMB];
  if (posed.pinch_gap_m !== undefined) thumb[3] = add(fingers[0]![3]!, [0, -posed.pinch_gap_m, 0]);
  return [[0, 0, 0], ...thumb, ...fingers.flat()];
}

export function hand_of(posed: Posed, sureness = 0.95): Hand {
  const landmarks = bones_of(posed).map((bone): Point => {
    const from_middle = add(bone, [0, -PALM_M / 2, 0]);
    const turned = rotated(
      2,
      posed.roll_deg ?? 0,
      rotated(1, posed.yaw_deg ?? 0, rotated(0, posed.pitch_deg ?? 0, from_middle)),
    );
    const [x, y, z] = add(turned, [posed.right_m ?? 0, posed.up_m ?? 0, -(posed.away_m ?? 0.5)]);
    return { x: 0.67 + (FOCAL * x) / -z, y: 0.5 - (FOCAL * y) / -z };
  });
  return { landmarks, sureness };
}

export const OPEN: Posed = { curl_deg: [0, 0, 0, 0] };
export const FIST: Posed = { curl_deg: [80, 80, 80, 80] };
export const PINCH: Posed = { curl_deg: [35, 10, 10, 10], pinch_gap_m: 0.008 };
export const TWO: Posed = { curl_deg: [0, 0, 80, 80] };

/** The same with each landmark moved by noise of so many sizes of the hand (one sigma). */
export function shaken(hand: Hand, by: number, size: number, random: () => number): Hand {
  const gauss = (): number =>
    Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
  const landmarks = hand.landmarks.map(({ x, y }) => ({
    x: x + by * size * gauss(),
    y: y + by * size * gauss(),
  }));
  return { ...hand, landmarks };
}

/** Numbers that are the same each time: mulberry32. */
export function seeded(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
