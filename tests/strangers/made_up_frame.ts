// A frame as the server sends it: the bytes of FlatBuffers, made by the library itself.
import { Builder } from 'flatbuffers';
import { Frame } from 'page/generated/slackwater/session/frame';
import { Pose } from 'page/generated/slackwater/session/pose';
import { pose_with } from './pose_for_tests';

export function frame_bytes(
  number: number,
  time_s: number,
  poses: readonly Parameters<typeof pose_with>[0][],
): Uint8Array {
  const builder = new Builder(1024);
  Frame.startPosesVector(builder, poses.length);
  for (const told of [...poses].reverse()) {
    const it = pose_with(told);
    Pose.createPose(
      builder,
      ...([it.east_m, it.north_m, it.up_m] as const),
      ...([it.roll_rad, it.pitch_rad, it.heading_rad] as const),
      ...([it.east_m_s, it.north_m_s, it.up_m_s] as const),
      ...([it.current_east_m_s, it.current_north_m_s] as const),
      ...([it.bed_m ?? NaN, it.charge ?? NaN, it.vehicle, it.halted, 0] as const),
    );
  }
  const list = builder.endVector();
  Frame.startFrame(builder);
  Frame.addNumber(builder, number);
  Frame.addStep(builder, BigInt(number));
  Frame.addTimeS(builder, time_s);
  Frame.addClockMs(builder, BigInt(50 * number));
  Frame.addIsWhole(builder, true);
  Frame.addPoses(builder, list);
  builder.finish(Frame.endFrame(builder), 'SWS1');
  return builder.asUint8Array();
}
