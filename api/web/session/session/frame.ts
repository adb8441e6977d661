// A binary frame of the server, decoded (api/door/people/wire/session.fbs).
import { ByteBuffer } from 'flatbuffers';
import { Frame as WireFrame } from '../generated/slackwater/session/frame';

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

function known(value: number): number | null {
  return Number.isNaN(value) ? null : value;
}

/** Nothing where the bytes are no frame of ours. */
export function decode_frame(bytes: Uint8Array): Frame | null {
  if (bytes.length < 8) return null;
  const buffer = new ByteBuffer(bytes);
  if (!WireFrame.bufferHasIdentifier(buffer)) return null;
  const wire = WireFrame.getRootAsFrame(buffer);
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
  };
}
