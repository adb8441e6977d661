// What the server tells of vehicles that move: how far each number of a pose is from what was to be
// expected (api/docs/session_wire.md, Moved). All is reckoned in whole numbers, as the server does,
// so that both have the same for ever.
import { BitReader } from './bits';
import type { Pose, WireFrame } from './frame';

const ANGLES = 3;
const PLACES = 6;
const CURRENTS = 9;
const BED = 11;
const CHARGE = 12;
const NUMBERS = 13;
const TURN = 16384;
const MOST = 2 ** 26;
/** Steps to the unit: of speeds, angles, places, depths, shares. */
const SPEED = 100;
const ANGLE = 2607.5945876176133;
const PLACE = 200;
const DEPTH = 20;
const SHARE = 2000;
const STEPS_APART = 4;

interface Known {
  pose: Pose; // as it was told last
  numbers: number[];
  step: number[]; // of speeds and angles, with the last frame
}

function wrapped(angle: number): number {
  return angle - TURN * Math.floor((angle + TURN / 2) / TURN);
}

function counted(value: number | null, steps: number): number {
  const count = value === null ? 0 : Math.floor(value * steps + 0.5);
  return Math.abs(count) <= MOST ? count : 0; // such a one is never told in bits
}

function numbers_of(pose: Pose): number[] {
  return [
    counted(pose.east_m_s, SPEED),
    counted(pose.north_m_s, SPEED),
    counted(pose.up_m_s, SPEED),
    wrapped(counted(pose.roll_rad, ANGLE)),
    wrapped(counted(pose.pitch_rad, ANGLE)),
    wrapped(counted(pose.heading_rad, ANGLE)),
    counted(pose.east_m, PLACE),
    counted(pose.north_m, PLACE),
    counted(pose.up_m, PLACE),
    counted(pose.current_east_m_s, SPEED),
    counted(pose.current_north_m_s, SPEED),
    counted(pose.bed_m === null ? null : pose.up_m - pose.bed_m, DEPTH),
    counted(pose.charge, SHARE),
  ];
}

function pose_of(known: Known): Pose {
  const n = (number: number): number => known.numbers[number] ?? 0;
  const { pose } = known;
  return {
    vehicle: pose.vehicle,
    east_m: n(PLACES) / PLACE,
    north_m: n(PLACES + 1) / PLACE,
    up_m: n(PLACES + 2) / PLACE,
    roll_rad: n(ANGLES) / ANGLE,
    pitch_rad: n(ANGLES + 1) / ANGLE,
    heading_rad: n(ANGLES + 2) / ANGLE,
    east_m_s: n(0) / SPEED,
    north_m_s: n(1) / SPEED,
    up_m_s: n(2) / SPEED,
    current_east_m_s: n(CURRENTS) / SPEED,
    current_north_m_s: n(CURRENTS + 1) / SPEED,
    bed_m: pose.bed_m === null ? null : n(PLACES + 2) / PLACE - n(BED) / DEPTH,
    charge: pose.charge === null ? null : n(CHARGE) / SHARE,
    halted: pose.halted,
  };
}

/** The vehicles as this station knows them, frame after frame. */
export class Moved {
  private readonly known = new Map<number, Known>(); // in the order in which they came
  private time_ms = 0;
  private step_ms = 0; // from the frame before to the last one
  private number = 0;
  private is_lost = true;

  /** All poses that a frame tells anew; null: it does not follow, and a whole one is needed. */
  take(frame: WireFrame): Pose[] | null {
    const time_ms = Math.floor(1000 * frame.time_s + 0.5);
    const since_ms = time_ms - this.time_ms;
    const follows = !this.is_lost && frame.number === this.number + 1;
    // Until it is known to be right.
    this.is_lost = true;
    if (frame.is_whole) this.known.clear();
    else if (frame.moved === null)
      return frame.poses; // of a server that has no such bits
    else if (!follows) return null;
    const before = [...this.known.values()];
    const are_told = new Set(frame.poses.map((pose) => pose.vehicle));
    for (const pose of frame.poses) {
      const step = new Array<number>(PLACES).fill(0);
      this.known.set(pose.vehicle, { pose, numbers: numbers_of(pose), step });
    }
    const poses = [...frame.poses];
    if (!frame.is_whole && frame.moved !== null) {
      const bits = new BitReader(frame.moved);
      if (bits.count() !== before.length) return null;
      for (const known of before) {
        if (are_told.has(known.pose.vehicle)) continue;
        if (bits.bit() === 0) {
          known.step.fill(0);
        } else {
          this.move(known, bits, since_ms);
          poses.push(known.pose);
        }
        if (bits.is_over) return null;
      }
      if (bits.bits(16) !== this.checksum() || !bits.is_at_end()) return null;
    }
    this.time_ms = time_ms;
    this.step_ms = frame.is_whole ? 0 : since_ms;
    this.number = frame.number;
    this.is_lost = false;
    return poses;
  }

  private move(known: Known, bits: BitReader, since_ms: number): void {
    const was = known.numbers;
    const now = [...was];
    for (let i = 0; i < NUMBERS; i += 1) {
      if (i === BED && known.pose.bed_m === null) continue;
      if (i === CHARGE && known.pose.charge === null) continue;
      let value = (was[i] ?? 0) + this.way(known, now, i, since_ms) + bits.signed();
      if (i >= ANGLES && i < PLACES) value = wrapped(value);
      now[i] = value;
    }
    for (let i = 0; i < PLACES; i += 1) {
      const step = (now[i] ?? 0) - (was[i] ?? 0);
      known.step[i] = i < ANGLES ? step : wrapped(step);
    }
    known.numbers = now;
    known.pose = pose_of(known);
  }

  /** How far a number is expected to go. */
  private way(known: Known, now: number[], number: number, since_ms: number): number {
    if (number < PLACES) {
      const { step_ms } = this;
      if (step_ms === 0 || since_ms > STEPS_APART * step_ms) return 0;
      const step = known.step[number] ?? 0;
      return Math.floor((2 * step * since_ms + step_ms) / (2 * step_ms));
    }
    if (number >= CURRENTS) return 0;
    const axis = number - PLACES;
    const twice = (known.numbers[axis] ?? 0) + (now[axis] ?? 0);
    return Math.floor((twice * since_ms + 500) / 1000);
  }

  private checksum(): number {
    let sum = 2166136261;
    for (const known of this.known.values())
      for (const number of known.numbers) sum = Math.imul(sum ^ number, 16777619);
    return (sum ^ (sum >>> 16)) & 0xffff;
  }
}
