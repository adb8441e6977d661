// The farm as a table: places, vehicles and the table itself in the hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { at_place, type Place } from 'page/scene/axes';
import { empty_session } from 'page/session/state';
import { FloorAhead } from 'page/xr/floor_ahead';
import { Presses } from 'page/xr/presses';
import type { HandReading } from 'page/xr/reading';
import { Rig } from 'page/xr/rig';
import { lay_table, table_middle, TableHand, type TableDeeds } from 'page/xr/table';
import { controller, hand_at, near, near_place } from './xr_for_tests';

function table_with(places: Place[]): {
  rig: Rig;
  take: (...hands: HandReading[]) => void;
  lose: () => void;
  told: string[];
  local: (place: Place) => Vector3;
} {
  const rig = new Rig();
  const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.7);
  rig.take_head({ at: new Vector3(0.1, 1.5, 0.2), turned });
  lay_table(rig, new Vector3(120, 0, -340), null);
  const told: string[] = [];
  let picked = -1;
  const deeds: TableDeeds = {
    places: () => places,
    pick: (nth) => (told.push(`pick ${nth}`), (picked = nth)),
    move: (to) => Object.assign(places[picked]!, { east_m: to.east_m, north_m: to.north_m }),
    lift: (up_m) => (places[picked]!.up_m = up_m),
    let_go: () => told.push('let go'),
    vehicles: () => [{ vehicle: 4, east_m: 200, north_m: 300, up_m: -10 }],
    choose: (vehicle) => told.push(`choose ${vehicle}`),
  };
  const local = (place: Place): Vector3 => rig.inner.worldToLocal(at_place(place));
  const [hand, presses] = [new TableHand(rig, deeds), new Presses()];
  const take = (...hands: HandReading[]): void => {
    presses.look(hands);
    hand.take(hands, presses, new Set());
  };
  const lose = (): void => {
    presses.lose_all();
    hand.lose();
  };
  return { rig, take, lose, told, local };
}

test('the table lies half a metre below the eyes, 0.6 m ahead, 1:500', () => {
  const { rig, local } = table_with([]);
  const middle = local({ east_m: 120, north_m: 340, up_m: 0 });
  near_place(middle, 0.1 - 0.6 * Math.sin(0.7), 1, 0.2 - 0.6 * Math.cos(0.7));
  const east = local({ east_m: 620, north_m: 340, up_m: 0 });
  near(east.distanceTo(middle), 1, 1e-9); // 500 m
  near(rig.scale, 500);
});

test('a pinched place moves by the hand times 500, level, and the other hand lifts it', () => {
  const places = [{ east_m: 100, north_m: 350, up_m: -12 }];
  const { take, told, local, rig } = table_with(places);
  const at = local(places[0]!);
  const other = controller('left');
  take(hand_at(at, false), other);
  take(hand_at(at, true), other);
  const moved = new Vector3(0.03, 0.02, -0.01); // in the hand's own axes
  take(hand_at(at.clone().add(moved), true), other);
  // The rig was not turned: its axes are east, up and south.
  near(places[0]!.east_m, 100 + 500 * 0.03, 0.01);
  near(places[0]!.north_m, 350 + 500 * 0.01, 0.01);
  near(places[0]!.up_m, -12);
  take(hand_at(at.clone().add(moved), true), { ...other, is_pressed: true });
  near(places[0]!.up_m, -12 + 500 * 0.02, 1e-6);
  take(hand_at(at, false));
  assert.deepEqual(told, ['pick 0', 'let go']);
  near(rig.scale, 500);
});

test('a vehicle is chosen by a pinch on it, and not by one that drags the table', () => {
  const { take, told, local, rig } = table_with([]);
  const at = local({ east_m: 200, north_m: 300, up_m: -10 });
  take(hand_at(at, false));
  take(hand_at(at, true));
  take(hand_at(at, false));
  assert.deepEqual(told, ['choose 4']);
  take(hand_at(at, true));
  take(hand_at(at.clone().setX(at.x + 0.1), true));
  take(hand_at(at.clone().setX(at.x + 0.2), true));
  take(hand_at(at, false));
  assert.deepEqual(told, ['choose 4']);
  // It has moved along with the hand, as far as that went.
  near_place(
    rig.inner.worldToLocal(at_place({ east_m: 200, north_m: 300, up_m: -10 })),
    at.x + 0.2,
    at.y,
    at.z,
  );
});

test('what is beyond reach is not taken, and what is held when a hand is lost stays', () => {
  const places = [{ east_m: 100, north_m: 350, up_m: -12 }];
  const { take, lose, told, local } = table_with(places);
  const at = local(places[0]!);
  take(hand_at(at, false));
  take(hand_at(at.clone().setY(at.y + 0.031), true)); // reach is 0.03 m
  take();
  assert.deepEqual(told, []);
  take(hand_at(at, false));
  take(hand_at(at, true));
  take({ ...hand_at(at.clone().setX(at.x + 1), true), is_tracked: false });
  near(places[0]!.east_m, 100);
  assert.deepEqual(told, ['pick 0', 'let go']);
  for (let i = 0; i < 3; i += 1) take(hand_at(at, true)); // still pinched: not taken again
  assert.deepEqual(told, ['pick 0', 'let go']);
  take(hand_at(at, false));
  take(hand_at(at, true));
  lose(); // the headset is hidden
  for (let i = 0; i < 3; i += 1) take(hand_at(at, true));
  assert.deepEqual(told, ['pick 0', 'let go', 'pick 0', 'let go']);
});

test('a hand that is lost on a vehicle chooses nothing', () => {
  const { take, lose, told, local } = table_with([]);
  const at = local({ east_m: 200, north_m: 300, up_m: -10 });
  const losses: [string, () => void][] = [
    ['gone', () => take()],
    ['untracked', () => take({ ...hand_at(at, true), is_tracked: false })],
    // Without its joints nobody knows whether it pinches.
    ['untracked and open', () => take({ ...hand_at(at, false), is_tracked: false })],
    ['hidden', lose],
  ];
  for (const [how, lost] of losses) {
    take(hand_at(at, false));
    take(hand_at(at, true));
    lost();
    take(hand_at(at, true));
    take(hand_at(at, false));
    assert.deepEqual(told, [], how);
  }
  take(hand_at(at, true));
  take(hand_at(at, false));
  assert.deepEqual(told, ['choose 4'], 'seen open before');
});

test('the middle of the table is the chosen vehicle at sea level, or the middle of all', () => {
  const session = empty_session();
  assert.deepEqual(table_middle(session, null), new Vector3());
  const pose = { east_m: 10, north_m: 20, up_m: -30 };
  session.poses.set(1, { vehicle: 1, ...pose } as never);
  session.poses.set(2, { vehicle: 2, ...pose, east_m: 30 } as never);
  assert.deepEqual(table_middle(session, 1), new Vector3(10, 0, -20));
  near_place(table_middle(session, null), 20, 0, -20);
});

test('the table may be laid where the headset finds a floor', async () => {
  const floor = new FloorAhead();
  const space = {} as XRReferenceSpace;
  const position = { x: 1, y: -1.4, z: -2 };
  let results: unknown[] = [{ getPose: () => ({ transform: { position } }) }];
  const frame = { getHitTestResults: () => results } as unknown as XRFrame;
  floor.look(frame, space);
  assert.equal(floor.at, null); // nobody has asked yet
  const refuses = { requestReferenceSpace: () => Promise.reject(new Error('no')) };
  await floor.begin(refuses as unknown as XRSession);
  floor.look(frame, space);
  assert.equal(floor.at, null);
  const session = {
    requestReferenceSpace: async () => space,
    requestHitTestSource: async () => ({}),
  } as unknown as XRSession;
  await floor.begin(session);
  floor.look(frame, space);
  near_place(floor.at!, 1, -1.4, -2);
  const { rig } = table_with([]);
  lay_table(rig, new Vector3(120, 0, -340), floor.at);
  near_place(rig.in_scene(floor.at!), 120, 0, -340);
  results = [];
  floor.look(frame, space);
  assert.equal(floor.at, null);
});

test('the search for a floor ends with the session, also one that is granted later', async () => {
  for (const is_late of [false, true]) {
    let cancelled = 0;
    let grant = (): void => undefined;
    const session = {
      requestReferenceSpace: async () => ({}),
      requestHitTestSource: () =>
        new Promise((done) => (grant = () => done({ cancel: () => (cancelled += 1) }))),
    } as unknown as XRSession;
    const floor = new FloorAhead();
    const begun = floor.begin(session);
    await Promise.resolve();
    if (is_late) floor.end();
    grant();
    await begun;
    if (!is_late) floor.end();
    assert.equal(cancelled, 1);
  }
});
