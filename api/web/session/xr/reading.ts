// What the headset says of both hands in one frame, as plain values, in its own metres. Controllers
// and bare hands are told alike: to press is the trigger, or thumb and index that meet.
import { Matrix4, Quaternion, Vector3 } from 'three';
import { INDEX_TIP, is_pinch, is_pointing_hand, JOINTS, THUMB_TIP, WRIST } from './joints';

export type Side = 'left' | 'right';
export const SIDES: readonly Side[] = ['left', 'right'];

export interface Spot {
  at: Vector3;
  turned: Quaternion;
}
export interface HandReading {
  side: Side;
  kind: 'controller' | 'hand';
  /**
   * The headset knows now where it is. A controller in the lap, that it reckons on for a while
   * unseen, still has its buttons and is not lost.
   */
  is_tracked: boolean;
  grip: Spot | null;
  ray: Spot | null; // points along its -z
  joints: Vector3[] | null; // all 25, or none
  is_pressed: boolean;
  press_at: Vector3 | null; // between the finger tips, or the controller's front
  is_squeezed: boolean;
  is_pointing: boolean; // A or X, or an index finger
  is_hold: boolean; // B or Y
  stick: { right: number; up: number };
}

/** How a controller of WebXR's standard mapping is laid out. */
const BUTTON = { trigger: 0, squeeze: 1, lower: 4, upper: 5 };
const PRESSED_FROM = 0.5;

export function spot_of(pose: XRPose | null | undefined): Spot | null {
  if (pose == null) return null;
  const at = new Vector3();
  const turned = new Quaternion();
  new Matrix4().fromArray(pose.transform.matrix).decompose(at, turned, new Vector3());
  return { at, turned };
}

function joints_of(frame: XRFrame, hand: XRHand, space: XRReferenceSpace): Vector3[] | null {
  const joints: Vector3[] = [];
  for (const name of JOINTS) {
    const joint = hand.get(name);
    const { x, y, z } = (joint && frame.getJointPose?.(joint, space))?.transform.position ?? {};
    if (x === undefined || y === undefined || z === undefined) return null;
    joints.push(new Vector3(x, y, z));
  }
  return joints;
}

export class HandReader {
  private readonly pinches = new Map<Side, boolean>();

  read(frame: XRFrame, space: XRReferenceSpace): HandReading[] {
    const readings: HandReading[] = [];
    for (const source of frame.session.inputSources ?? []) {
      const side = source.handedness;
      if (side === 'none' || source.targetRayMode !== 'tracked-pointer') continue;
      if (readings.some((it) => it.side === side)) continue;
      const ray = spot_of(frame.getPose(source.targetRaySpace, space));
      readings.push(
        source.hand == null
          ? this.controller(side, source, frame, space, ray)
          : this.hand(side, source.hand, frame, space, ray),
      );
    }
    return readings;
  }

  private controller(
    side: Side,
    source: XRInputSource,
    frame: XRFrame,
    space: XRReferenceSpace,
    ray: Spot | null,
  ): HandReading {
    const grip = spot_of(source.gripSpace && frame.getPose(source.gripSpace, space));
    const { axes, buttons } = source.gamepad ?? { axes: [], buttons: [] };
    const value = (nth: number): number => buttons[nth]?.value ?? 0;
    const from = axes.length > 2 ? 2 : 0; // a thumb-stick, else a touchpad
    return {
      side,
      kind: 'controller',
      is_tracked: grip !== null,
      grip,
      ray,
      joints: null,
      is_pressed: value(BUTTON.trigger) > PRESSED_FROM,
      press_at: ray?.at ?? null,
      is_squeezed: value(BUTTON.squeeze) > PRESSED_FROM,
      is_pointing: buttons[BUTTON.lower]?.pressed === true,
      is_hold: buttons[BUTTON.upper]?.pressed === true,
      stick: { right: axes[from] ?? 0, up: 0 - (axes[from + 1] ?? 0) },
    };
  }

  private hand(
    side: Side,
    hand: XRHand,
    frame: XRFrame,
    space: XRReferenceSpace,
    ray: Spot | null,
  ): HandReading {
    const joints = joints_of(frame, hand, space);
    const [thumb, index] = [joints?.[THUMB_TIP], joints?.[INDEX_TIP]];
    const is_seen = thumb !== undefined && index !== undefined;
    const is_pressed =
      is_seen && is_pinch(this.pinches.get(side) ?? false, thumb.distanceTo(index));
    this.pinches.set(side, is_pressed);
    const wrist = hand.get(JOINTS[WRIST]!);
    return {
      side,
      kind: 'hand',
      is_tracked: joints !== null,
      grip: spot_of(wrist && frame.getJointPose?.(wrist, space)),
      ray,
      joints,
      is_pressed,
      press_at: is_seen ? thumb.clone().lerp(index, 0.5) : null,
      is_squeezed: false,
      is_pointing: !is_pressed && joints !== null && is_pointing_hand(joints),
      is_hold: false,
      stick: { right: 0, up: 0 },
    };
  }
}

/** Which way something looks, in the level: 0 along -z, against the clock from above. */
export function turn_of(turned: Quaternion): number {
  const ahead = new Vector3(0, 0, -1).applyQuaternion(turned);
  return Math.atan2(-ahead.x, -ahead.z);
}
