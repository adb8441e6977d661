// What tests of a headset share: near values and places, and hands as the headset reads them.
import assert from 'node:assert/strict';
import { Quaternion, Vector3 } from 'three';
import type { Gate } from 'page/drive/stick';
import type { HandReading, Side } from 'page/xr/reading';

export const near = (found: number | undefined, expected: number, within = 1e-9): void =>
  assert.ok(
    found !== undefined && Math.abs(found - expected) <= within,
    `${found}, not ${expected}`,
  );
export const near_place = (found: Vector3, x: number, y: number, z: number): void => {
  near(found.distanceTo(new Vector3(x, y, z)), 0, 1e-6);
};

const EAST_M: Record<Side, number> = { left: -0.2, right: 0.2 };
export function controller(side: Side, given: Partial<HandReading> = {}): HandReading {
  const spot = { at: new Vector3(EAST_M[side], 1.2, -0.3), turned: new Quaternion() };
  return {
    side,
    kind: 'controller',
    is_tracked: true,
    grip: spot,
    ray: spot,
    joints: null,
    is_pressed: false,
    press_at: spot.at,
    is_squeezed: false,
    is_pointing: false,
    is_hold: false,
    stick: { right: 0, up: 0 },
    ...given,
  };
}
/** Held on the stick, and leaned ahead. */
export const SQUEEZED = controller('left', { is_squeezed: true, stick: { right: 0, up: 1 } });

export const hand_at = (at: Vector3, is_pressed: boolean, turned = new Quaternion()): HandReading =>
  controller('right', { kind: 'hand', press_at: at, grip: { at, turned }, is_pressed });

export const OPEN: Gate = {
  is_open: true,
  buffered_bytes: 0,
  is_hidden: false,
  has_focus: true,
  clock_is_known: true,
  frame_age_ms: 50,
  has_helm: true,
};
export { NO_LEAN as ZERO } from 'page/drive/stick';

/** In place of what a browser has and Node has not. What is returned puts back what was there. */
export function put_globals(given: Record<string, unknown>): () => void {
  const before = Object.keys(given).map(
    (name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)] as const,
  );
  for (const [name, value] of Object.entries(given))
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  return () => {
    for (const [name, was] of before)
      if (was === undefined) Reflect.deleteProperty(globalThis, name);
      else Object.defineProperty(globalThis, name, was);
  };
}
