// A binary frame of the server, decoded (api/door/people/wire/session.fbs).
import { ByteBuffer } from 'flatbuffers';
import { Frame as Wire } from '../generated/slackwater/session/frame';

export interface Pose {
  vehicle: number;
  east_m: number;
  north_m: number;
  up_m: number;
  roll_rad: number;
  pitch_rad: number;
  heading_rad: number;
  east_m_s: number;
  north_m_s: number;
  up_m_s: number;
  current_east_m_s: number;
  current_north_m_s: number;
  bed_m: number | null; // above the bed
  charge: number | null;
  halted: boolean;
}
export interface Frame {
  number: number;
  step: number;
  time_s: number;
  clock_ms: number;
  is_whole: boolean;
  left_out: number;
  poses: Pose[];
}

/** As it came: with the bits of what moved (moved.ts), where it has such. */
export interface WireFrame extends Frame {
  moved: Uint8Array | null;
}

const POSE_BYTES = 56;

function known(value: number): number | null {
  return Number.isNaN(value) ? null : value;
}

/** Nothing where the bytes are no frame of ours. */
export function decode_frame(bytes: Uint8Array): WireFrame | null {
  if (bytes.length < 8) return null;
  try {
    return decode(bytes);
  } catch {
    return null; // damaged so that it points out of itself
  }
}

function decode(bytes: Uint8Array): WireFrame | null {
  const buffer = new ByteBuffer(bytes);
  if (!Wire.bufferHasIdentifier(buffer)) return null;
  const wire = Wire.getRootAsFrame(buffer);
  if (wire.posesLength() * POSE_BYTES > bytes.length) return null;
  const poses: Pose[] = [];
  for (let i = 0; i < wire.posesLength(); i += 1) {
    const pose = wire.poses(i);
    if (pose === null) continue;
    poses.push({
      vehicle: pose.vehicle(),
      east_m: pose.eastM(),
      north_m: pose.northM(),
      up_m: pose.upM(),
      roll_rad: pose.rollRad(),
      pitch_rad: pose.pitchRad(),
      heading_rad: pose.headingRad(),
      east_m_s: pose.eastMS(),
      north_m_s: pose.northMS(),
      up_m_s: pose.upMS(),
      current_east_m_s: pose.currentEastMS(),
      current_north_m_s: pose.currentNorthMS(),
      bed_m: known(pose.bedM()),
      charge: known(pose.charge()),
      halted: pose.halted(),
    });
  }
  return {
    number: wire.number(),
    step: Number(wire.step()),
    time_s: wire.timeS(),
    clock_ms: Number(wire.clockMs()),
    is_whole: wire.isWhole(),
    left_out: wire.leftOut(),
    poses,
    moved: wire.movedArray(),
  };
}
