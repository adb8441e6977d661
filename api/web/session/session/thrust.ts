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

/** Each from -1 to 1; nothing: not told of any vehicle. */
export function read_thrust(value: unknown): { vehicle: number; share: number[] } | null {
  const it = as_object(value);
  const vehicle = as_number(it?.vehicle);
  if (it === null || vehicle === null) return null;
  const share = as_list(it.share).map((one) => Math.min(1, Math.max(-1, as_number(one) ?? 0)));
  return { vehicle, share };
}
