// What the server tells of vehicles that move, read from bytes that it wrote itself.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Builder } from 'flatbuffers';
import { Frame as WireFrame } from 'page/generated/slackwater/session/frame';
import { Pose as WirePose } from 'page/generated/slackwater/session/pose';
import { decode_frame, type Pose } from 'page/session/frame';
import { FrameReader } from 'page/session/frame_reader';
import { MOVED_FRAMES } from './moved_frames_for_tests';

interface Told {
  bytes: Uint8Array;
  knows: Map<number, number[]>;
}

function told(): Told[] {
  return MOVED_FRAMES.split('frame\n')
    .slice(1)
    .map((text) => {
      const lines = text.trim().split('\n');
      const hex = lines.filter((line) => !line.startsWith('knows')).join('');
      const knows = lines
        .filter((line) => line.startsWith('knows'))
        .map((line) => line.split(' ').slice(1).map(Number));
      return {
        bytes: Uint8Array.from(Buffer.from(hex, 'hex')),
        knows: new Map(knows.map(([vehicle, ...numbers]) => [vehicle ?? -1, numbers])),
      };
    });
}

const ANGLE = 2607.5945876176133;
const STEPS = [100, 100, 100, ANGLE, ANGLE, ANGLE, 200, 200, 200, 100, 100, 20, 2000];

function numbers_of(pose: Pose): number[] {
  const values = [
    ...[pose.east_m_s, pose.north_m_s, pose.up_m_s],
    ...[pose.roll_rad, pose.pitch_rad, pose.heading_rad],
    ...[pose.east_m, pose.north_m, pose.up_m, pose.current_east_m_s, pose.current_north_m_s],
    ...[pose.bed_m === null ? 0 : pose.up_m - pose.bed_m, pose.charge ?? 0],
  ];
  return values.map((value, i) => Math.floor(value * (STEPS[i] ?? 0) + 0.5));
}

test('ThePageKnowsToTheBitWhatTheServerKnowsThatItKnows', () => {
  const reader = new FrameReader();
  const shown = new Map<number, Pose>();
  let compared = 0;
  let as_poses = 0;
  for (const { bytes, knows } of told()) {
    const frame = reader.take(bytes);
    assert.notEqual(frame, null);
    as_poses += decode_frame(bytes)!.poses.length;
    for (const pose of frame!.poses) shown.set(pose.vehicle, pose);
    assert.deepEqual([...shown.keys()], [...knows.keys()]);
    for (const [vehicle, numbers] of knows) {
      const pose = shown.get(vehicle)!;
      if (!Number.isFinite(pose.north_m)) continue;
      assert.deepEqual(numbers_of(pose), numbers);
      compared += 1;
    }
  }
  assert.ok(compared > 150, `${compared}`);
  assert.ok(as_poses < 20, 'the others were told in bits');
});

test('WhatIsNotKnownStaysSoAndWhatHaltsIsTold', () => {
  const reader = new FrameReader();
  const last = new Map<number, Pose>();
  for (const { bytes } of told())
    for (const pose of reader.take(bytes)!.poses) last.set(pose.vehicle, pose);
  assert.equal(last.get(11)?.bed_m, null);
  assert.equal(last.get(12)?.charge, null);
  assert.equal(last.get(10)?.halted, true);
  assert.equal(last.get(13)?.halted, false);
});

test('AFrameThatDoesNotFollowIsLeftOutUntilAWholeOneComes', () => {
  const all = told();
  const reader = new FrameReader();
  reader.take(all[0]!.bytes);
  assert.equal(reader.is_lost, false);
  for (let i = 2; i < all.length; i += 1) {
    const is_whole = decode_frame(all[i]!.bytes)!.is_whole;
    const frame = reader.take(all[i]!.bytes);
    assert.equal(frame === null, i < 40, `frame ${i}`);
    assert.equal(reader.is_lost, i < 40);
    assert.equal(is_whole, i === 40);
  }
  reader.forget();
  assert.equal(reader.take(all[41]!.bytes), null, 'of another link nothing is known');
});

test('AServerWithoutSuchBitsIsReadAsEver', () => {
  const reader = new FrameReader();
  reader.take(told()[0]!.bytes);
  const builder = new Builder(64);
  WireFrame.startPosesVector(builder, 1);
  WirePose.createPose(builder, 5, 6, -7, 0, 0, 0, 0, 0, 0, 0, 0, NaN, NaN, 11, false, 0);
  const poses = builder.endVector();
  WireFrame.startFrame(builder);
  WireFrame.addNumber(builder, 9);
  WireFrame.addPoses(builder, poses);
  builder.finish(WireFrame.endFrame(builder), 'SWS1');
  const frame = reader.take(builder.asUint8Array());
  assert.deepEqual(
    frame?.poses.map((pose) => [pose.vehicle, pose.east_m]),
    [[11, 5]],
  );
  assert.equal(reader.is_lost, false);
});

/** The same numbers each time. */
function dice(seed: number): (below: number) => number {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

function place_of(moved: Uint8Array, bytes: Uint8Array): number {
  return Buffer.from(bytes).indexOf(Buffer.from(moved));
}

test('DamagedBitsAreNeverTakenAndNeverThrow', () => {
  const all = told();
  const draw = dice(37);
  let tried = 0;
  for (let i = 1; i < 40; i += 1) {
    const { bytes } = all[i]!;
    const { moved } = decode_frame(bytes)!;
    const begin = place_of(moved!, bytes);
    for (let round = 0; round < 40; round += 1) {
      const reader = new FrameReader();
      for (let k = 0; k < i; k += 1) reader.take(all[k]!.bytes);
      const damaged = Uint8Array.from(bytes);
      if (round < 20) {
        damaged[begin + draw(moved!.length)]! ^= 1 << draw(8);
      } else {
        const value = round % 2 === 0 ? 0 : draw(256);
        damaged.fill(value, begin + draw(moved!.length), begin + moved!.length);
      }
      if (Buffer.compare(damaged, bytes) === 0) continue;
      assert.equal(reader.take(damaged), null, `frame ${i}`);
      assert.equal(reader.is_lost, true);
      assert.equal(reader.take(all[i + 1]!.bytes) === null, i + 1 < 40, 'until a whole one');
      tried += 1;
    }
  }
  assert.ok(tried > 1000);
});

test('DamageAnywhereOrAnEndTooEarlyNeverThrowsOrTakesLong', () => {
  const all = told();
  const draw = dice(5);
  const began_ms = performance.now();
  for (let round = 0; round < 20000; round += 1) {
    const reader = new FrameReader();
    reader.take(all[0]!.bytes);
    const { bytes } = all[draw(2)]!;
    const damaged = Uint8Array.from(bytes.subarray(0, round % 3 === 0 ? draw(400) : 400));
    for (let k = draw(4); k >= 0; k -= 1) damaged[draw(damaged.length)] = draw(256);
    const frame = reader.take(damaged);
    assert.ok(frame === null || frame.poses.length < 10);
    assert.equal(reader.is_lost, frame === null);
  }
  assert.ok(performance.now() - began_ms < 20_000);
});
