// A frame written by the FlatBuffers library itself, and read by the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Builder } from 'flatbuffers';
import { Frame } from 'page/generated/slackwater/session/frame';
import { Pose } from 'page/generated/slackwater/session/pose';
import { decode_frame } from 'page/session/frame';

function written(identifier = 'SWS1'): Uint8Array {
  const builder = new Builder(64);
  Frame.startPosesVector(builder, 2);
  Pose.createPose(builder, -1.5, 2.5, 30, 0, 0, 0, 0, 0, 0, 4, -3, NaN, NaN, 7, true, 0);
  Pose.createPose(
    builder,
    10.25,
    -20.5,
    -12,
    0.125,
    -0.25,
    3.5,
    0.5,
    -0.75,
    0.25,
    0.5,
    -0.125,
    21.5,
    0.75,
    0,
    false,
    0,
  );
  const poses = builder.endVector();
  Frame.startFrame(builder);
  Frame.addNumber(builder, 4_000_000_000);
  Frame.addStep(builder, 9_007_199_254_740_991n);
  Frame.addTimeS(builder, 12.345);
  Frame.addClockMs(builder, 1_764_000_000_123n);
  Frame.addIsWhole(builder, true);
  Frame.addLeftOut(builder, 3);
  Frame.addPoses(builder, poses);
  builder.finish(Frame.endFrame(builder), identifier);
  return builder.asUint8Array();
}

test('AFrameIsReadAsItWasWritten', () => {
  const frame = decode_frame(written())!;
  assert.deepEqual(
    { ...frame, poses: frame.poses.length },
    {
      number: 4_000_000_000,
      step: 9_007_199_254_740_991,
      time_s: 12.345,
      clock_ms: 1_764_000_000_123,
      is_whole: true,
      left_out: 3,
      poses: 2,
      moved: null,
    },
  );
  assert.deepEqual(frame.poses[0], {
    vehicle: 0,
    east_m: 10.25,
    north_m: -20.5,
    up_m: -12,
    roll_rad: 0.125,
    pitch_rad: -0.25,
    heading_rad: 3.5,
    east_m_s: 0.5,
    north_m_s: -0.75,
    up_m_s: 0.25,
    current_east_m_s: 0.5,
    current_north_m_s: -0.125,
    bed_m: 21.5,
    charge: 0.75,
    halted: false,
  });
});

test('WhatNobodyKnowsIsNothingAndNotANumberThatLooksLikeOne', () => {
  const pose = decode_frame(written())!.poses[1]!;
  assert.equal(pose.bed_m, null);
  assert.equal(pose.charge, null);
  assert.equal(pose.halted, true);
  assert.equal(pose.vehicle, 7);
});

test('BytesOfAnotherKindAreNoFrame', () => {
  assert.equal(decode_frame(written('XXXX')), null);
  assert.equal(decode_frame(new Uint8Array(0)), null);
  assert.equal(decode_frame(new Uint8Array(7)), null);
});
