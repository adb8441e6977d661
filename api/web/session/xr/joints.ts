// The 25 joints of a hand as WebXR orders them, which of them bones join, and what a hand does.
import type { Vector3 } from 'three';

const FINGERS = ['index-finger', 'middle-finger', 'ring-finger', 'pinky-finger'] as const;
const PARTS = ['metacarpal', 'phalanx-proximal', 'phalanx-intermediate', 'phalanx-distal', 'tip'];

export const JOINTS: readonly XRHandJoint[] = [
  'wrist',
  'thumb-metacarpal',
  'thumb-phalanx-proximal',
  'thumb-phalanx-distal',
  'thumb-tip',
  ...FINGERS.flatMap((finger) => PARTS.map((part) => `${finger}-${part}` as XRHandJoint)),
];

const nth = (joint: XRHandJoint): number => JOINTS.indexOf(joint);
export const WRIST = nth('wrist');
export const THUMB_TIP = nth('thumb-tip');
export const INDEX_TIP = nth('index-finger-tip');

/** From joint to joint: each finger from the wrist to its tip. */
export const BONES: readonly (readonly [number, number])[] = JOINTS.flatMap((joint, i) =>
  joint === 'wrist' ? [] : [[joint.endsWith('metacarpal') ? WRIST : i - 1, i] as const],
);

const PINCH_BEGINS_M = 0.015;
const PINCH_ENDS_M = 0.03;

/** Thumb and index meet. A pinch that is held ends farther apart than it began. */
export function is_pinch(was_pinch: boolean, apart_m: number): boolean {
  return apart_m < (was_pinch ? PINCH_ENDS_M : PINCH_BEGINS_M);
}

/** The index is stretched out, middle and ring finger are not. */
export function is_pointing_hand(joints: readonly Vector3[]): boolean {
  const wrist = joints[WRIST];
  const reach = (finger: (typeof FINGERS)[number]): number => {
    const tip = joints[nth(`${finger}-tip` as XRHandJoint)];
    const knuckle = joints[nth(`${finger}-phalanx-proximal` as XRHandJoint)];
    if (wrist === undefined || tip === undefined || knuckle === undefined) return Number.NaN;
    return tip.distanceTo(wrist) / knuckle.distanceTo(wrist);
  };
  return reach('index-finger') > 1.5 && reach('middle-finger') < 1.2 && reach('ring-finger') < 1.2;
}
