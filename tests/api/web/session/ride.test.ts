// Riding along with a vehicle.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Pose } from 'page/session/frame';
import { Ride } from 'page/xr/ride';
import { near_place } from './xr_for_tests';

const pose = (east_m: number, speed_m_s: number): Pose =>
  ({
    vehicle: 1,
    east_m,
    north_m: 5,
    up_m: -3,
    east_m_s: speed_m_s,
    north_m_s: 0,
    up_m_s: 0,
  }) as Pose;
const poses = (it: Pose): Map<number, Pose> => new Map([[1, it]]);

test('one goes as far as the vehicle, step by step, and no step is lost', () => {
  const ride = new Ride();
  assert.equal(ride.step(poses(pose(0, 1))), null);
  ride.begin(pose(10, 1));
  near_place(ride.step(poses(pose(10.5, 1)))!, 0.5, 0, 0);
  near_place(ride.step(poses(pose(10.5, 1)))!, 0, 0, 0);
  near_place(ride.step(poses(pose(12, 1)))!, 1.5, 0, 0);
  ride.end();
  assert.equal(ride.step(poses(pose(20, 1))), null);
});

test('it is felt by the speed, also in frames between those of the vehicle', () => {
  const ride = new Ride();
  assert.equal(ride.is_felt(poses(pose(0, 1))), false, 'nobody rides');
  ride.begin(pose(0, 1));
  const told = poses(pose(0, 0.06));
  for (let i = 0; i < 3; i += 1) {
    near_place(ride.step(told)!, 0, 0, 0);
    assert.equal(ride.is_felt(told), true);
  }
  assert.equal(ride.is_felt(poses(pose(0, 0.04))), false, 'it holds its place');
});

test('a vehicle that is gone ends the ride', () => {
  const ride = new Ride();
  ride.begin(pose(0, 1));
  assert.equal(ride.step(new Map()), null);
  assert.equal(ride.is_on, false);
});
