// The thrusters of a vehicle: where they sit on it, and what each does now.
import { as_list, as_number, as_object } from './json';

/** Forward, right, down of a vehicle. */
export type OfBody = readonly [number, number, number];
export interface Mount {
  at: OfBody; // m
  axis: OfBody; // unit; a positive share pushes along it
}

function read_of_body(value: unknown): OfBody | null {
  const [forward, right, down] = as_list(value).map(as_number);
  return forward == null || right == null || down == null ? null : [forward, right, down];
}

/** All of them, in their order; none where one of them is no mount: shares go by their places. */
export function read_mounts(value: unknown): Mount[] {
  const made: Mount[] = [];
  for (const one of as_list(value)) {
    const it = as_object(one);
    const [at, axis] = [read_of_body(it?.at), read_of_body(it?.axis)];
    const long = axis === null ? 0 : Math.hypot(...axis);
    if (at === null || axis === null || !(long > 1e-6)) return [];
    made.push({ at, axis: [axis[0] / long, axis[1] / long, axis[2] / long] });
  }
  return made;
}

export interface Thrust {
  vehicle: number;
  share: number[]; // each from -1 to 1
}

/** All of them, or nothing where one is no number: it would look at rest. */
function thrust_of(vehicle: number | null, told: readonly (number | null)[]): Thrust | null {
  const share = told.filter((it) => it !== null);
  if (vehicle === null || share.length < told.length) return null;
  return { vehicle, share: share.map((it) => Math.min(1, Math.max(-1, it))) };
}

export function read_thrust(value: unknown): Thrust | null {
  const it = as_object(value);
  return it === null ? null : thrust_of(as_number(it.vehicle), as_list(it.share).map(as_number));
}

/** Of several vehicles: each its number, then parts of a hundred. */
export function read_thrusts(value: unknown): Thrust[] {
  return as_list(value)
    .map((row) => {
      const [vehicle, ...parts] = as_list(row).map(as_number);
      return thrust_of(
        vehicle ?? null,
        parts.map((it) => (it === null ? null : it / 100)),
      );
    })
    .filter((it) => it !== null);
}
