// A headset's hands: where a throw comes down, what a hand asks of a vehicle and when it must not,
// the farm as a table, turns by steps.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { Stick, type Gate } from 'page/drive/stick';
import { default_settings, read_settings } from 'page/look/settings';
import { empty_session } from 'page/session/state';
import { at_place, type Place } from 'page/scene/axes';
import { Board, button_boxes } from 'page/xr/board';
import { Flight, narrowed, out_of_bed_m, SnapTurn } from 'page/xr/comfort';
import { FloorAhead } from 'page/xr/floor_ahead';
import { controllers_lean, HelmHand, moved_lean } from 'page/xr/helm_hand';
import { BONES, is_pinch, is_pointing_hand, JOINTS } from 'page/xr/joints';
import { FEATURES_OF, modes_there } from 'page/xr/modes';
import { turn_of, type HandReading, type Side } from 'page/xr/reading';
import { Rig } from 'page/xr/rig';
import { lay_table, table_middle, TableHand, type TableDeeds } from 'page/xr/table';
import { arc_of, at_time, landing_of, type Ground } from 'page/xr/teleport';

const near = (found: number | undefined, expected: number, within = 1e-9): void =>
  assert.ok(
    found !== undefined && Math.abs(found - expected) <= within,
    `${found}, not ${expected}`,
  );
const near_place = (found: Vector3, x: number, y: number, z: number): void => {
  near(found.distanceTo(new Vector3(x, y, z)), 0, 1e-6);
};

// Throws.

const OPEN_SEA: Ground = { structures: [], bed_under: () => -30, is_water_open: false };
const PILE = { name: 'pile', east_m: 0, north_m: 8, radius_m: 3, bottom_m: -30, top_m: 5 };
const ahead_up = (up_rad: number): Vector3 => new Vector3(0, Math.sin(up_rad), -Math.cos(up_rad));

test('a level throw lands as far as a ball thrown from there flies', () => {
  // From a height h a ball that is thrown level at v flies v sqrt(2 h / g).
  for (const h of [0.5, 1.2, 9]) {
    const landing = landing_of(new Vector3(4, h, -7), ahead_up(0), OPEN_SEA);
    assert.equal(landing?.on, 'water');
    near_place(landing!.at, 4, 0, -7 - 10 * Math.sqrt((2 * h) / 9.81));
  }
});

test('thrown upwards it lands on the way down, as far as v v sin(2 a) / g on the level', () => {
  const up_rad = 0.6;
  const landing = landing_of(new Vector3(0, 1e-9, 0), ahead_up(up_rad), OPEN_SEA);
  near(0 - landing!.at.z, (100 * Math.sin(2 * up_rad)) / 9.81, 1e-6);
});

test('who stands on the water throws to the bed, who is under it to the water', () => {
  const down = landing_of(new Vector3(0, 1, 0), ahead_up(-0.5), {
    ...OPEN_SEA,
    is_water_open: true,
  });
  assert.equal(down?.on, 'bed');
  near(down?.at.y, -30, 1e-9);
  const up = landing_of(new Vector3(0, -2, 0), ahead_up(Math.PI / 2), OPEN_SEA);
  assert.equal(up?.on, 'water');
  near(up?.at.y, 0, 1e-9);
  // 10 m/s straight up rises 5.1 m and no more.
  assert.equal(landing_of(new Vector3(0, -5.2, 0), ahead_up(1.57), OPEN_SEA)?.on, 'bed');
});

test('a deck is landed on from above, and a wall is no place', () => {
  const ground = { ...OPEN_SEA, structures: [PILE] };
  const from = new Vector3(0, 6, 0);
  // From 1 m over the deck, so far that it comes down in its middle: 8 m = v cos(a) t.
  let best = 1;
  let up_rad = 0;
  for (let a = -0.5; a < 1.2; a += 0.001) {
    const landing = landing_of(from, ahead_up(a), ground);
    const off = landing?.on === 'deck' ? Math.abs(landing.at.z + 8) : 1;
    if (off < best) [best, up_rad] = [off, a];
  }
  const landing = landing_of(from, ahead_up(up_rad), ground)!;
  assert.equal(landing.on, 'deck');
  near(landing.at.y, 5);
  near(10 * Math.cos(up_rad) * landing.after_s, 8, 0.05);
  // Lower it meets the wall, 5 m away, long before the water behind it.
  assert.equal(landing_of(new Vector3(0, 2, 0), ahead_up(0.2), ground), null);
  // Beside the pile there is the water.
  assert.equal(landing_of(new Vector3(3.1, 2, 0), ahead_up(0.2), ground)?.on, 'water');
});

test('the arc that is shown begins at the hand and ends where one would land', () => {
  const [from, ahead] = [new Vector3(1, 2, 3), ahead_up(0.3)];
  const landing = landing_of(from, ahead, OPEN_SEA)!;
  const arc = arc_of(from, ahead, landing);
  assert.deepEqual(arc[0], from);
  near(arc.at(-1)!.distanceTo(landing.at), 0);
  // Where all stands still, nothing lands.
  near(at_time(from, ahead, 0).distanceTo(from), 0);
  assert.equal(landing_of(from, new Vector3(Number.NaN, 0, 0), OPEN_SEA), null);
});

test('on a slope a throw comes down as high as the bed is there', () => {
  const bed_under = (at: Vector3): number => -30 - 0.2 * at.z; // rises by one in five to the north
  const from = new Vector3(0, -28, 0);
  const landing = landing_of(from, ahead_up(0), { ...OPEN_SEA, bed_under });
  assert.ok(landing !== null && landing.on === 'bed');
  near(landing.at.y, bed_under(landing.at), 0.01);
});

// Turns and moves.

test('a push turns by 30 degrees once, whatever it does before it is back', () => {
  const snap = new SnapTurn();
  const pushes = [0.2, 0.9, 1, 0.5, 0.9, 0.1, -0.8, -0.8, 0];
  const turned = pushes.map((it) => Math.round((snap.step(it) * 180) / Math.PI));
  assert.deepEqual(turned, [0, 30, 0, 0, 0, 0, -30, 0, 0]);
});

test('a turn is about the head, at any size', () => {
  for (const scale of [1, 500]) {
    const rig = new Rig();
    rig.take_head({ at: new Vector3(0.3, 1.6, -0.2), turned: new Quaternion() });
    rig.bring(rig.head.position, new Vector3(10, 20, 30), scale);
    const before = rig.looks_along();
    rig.turn(Math.PI / 6);
    near_place(rig.head_at(), 10, 20, 30);
    near(rig.looks_along().angleTo(before), Math.PI / 6, 1e-7);
    assert.ok(rig.looks_along().x > 0, 'to the right of north is east');
  }
});

test('flight goes where one looks, begins at 3 m/s, and stops at once', () => {
  const flight = new Flight();
  const look = new Vector3(0, -1, 0);
  const first = flight.step(look, { right: 0, up: 1 }, 0, 0.01);
  near(first.x, 0);
  near(first.y, -0.03 * Math.exp(0.01 / 1.5), 1e-6);
  for (let i = 0; i < 1000; i += 1) flight.step(look, { right: 0, up: 1 }, 0, 0.02);
  near(flight.step(look, { right: 0, up: 1 }, 0, 0.02).length(), 0.6); // 30 m/s
  assert.equal(flight.step(look, { right: 0, up: 0 }, 0, 0.02).length(), 0);
  // A frame that was a second late.
  assert.ok(flight.step(look, { right: 0, up: 1 }, 0, 1).length() < 0.4);
});

test('nobody flies into the bed', () => {
  near(out_of_bed_m(-31, -30), 1.3);
  assert.deepEqual([out_of_bed_m(-29.5, -30), out_of_bed_m(-31, null)], [0, 0]);
});

test('the view narrows while one moves, and opens again', () => {
  let narrow = 0;
  for (let i = 0; i < 10; i += 1) narrow = narrowed(narrow, true, 0.02);
  assert.equal(narrow, 1);
  narrow = narrowed(narrow, false, 0.075);
  near(narrow, 0.5);
  assert.equal(narrowed(narrow, false, 1), 0);
});

test('who arrives looks from where the desk looked, seated or not, and stands on a landing', () => {
  for (const lift_m of [0, 0.45]) {
    const rig = new Rig();
    rig.lift_m = lift_m;
    const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.4);
    rig.take_head({ at: new Vector3(0.5, 1.2, 0.1), turned });
    rig.face(new Vector3(7, -8, 9), 1.1, turn_of(turned));
    near_place(rig.head_at(), 7, -8, 9);
    const along = rig.looks_along();
    near(Math.atan2(-along.x, -along.z), 1.1, 1e-7);
    rig.stand_at(new Vector3(1, -30, 2));
    near_place(rig.head_at(), 1, -30 + 1.2 + lift_m, 2);
  }
});

// The vehicle's stick.

const SIDES: Record<Side, number> = { left: -0.2, right: 0.2 };
function controller(side: Side, given: Partial<HandReading> = {}): HandReading {
  const spot = { at: new Vector3(SIDES[side], 1.2, -0.3), turned: new Quaternion() };
  return {
    side,
    kind: 'controller',
    is_tracked: true,
    grip: spot,
    ray: spot,
    joints: null,
    is_pressed: false,
    press_at: spot.at,
    is_squeezed: false,
    is_pointing: false,
    is_hold: false,
    stick: { right: 0, up: 0 },
    ...given,
  };
}
const hand_at = (at: Vector3, is_pressed: boolean, turned = new Quaternion()): HandReading =>
  controller('right', { kind: 'hand', press_at: at, grip: { at, turned }, is_pressed });

const OPEN: Gate = {
  is_open: true,
  buffered_bytes: 0,
  is_hidden: false,
  has_focus: true,
  clock_is_known: true,
  frame_age_ms: 50,
  has_helm: true,
};
const ZERO = { surge: 0, sway: 0, heave: 0, yaw: 0 };
const always = (): boolean => true;

test('two controllers lean as the two sticks of a gamepad do, one alone ahead and turn', () => {
  const left = controller('left', { stick: { right: -1, up: 0.5 } });
  const right = controller('right', { stick: { right: 1, up: -1 } });
  const lean = controllers_lean([right, left]);
  assert.deepEqual({ ...lean, surge: 0 }, { surge: 0, yaw: -1, sway: 1, heave: 1 });
  near(lean.surge, (0.5 - 0.12) / (1 - 0.12)); // beyond the gamepad's dead zone
  assert.deepEqual(controllers_lean([right]), { surge: -1, yaw: 1, sway: 0, heave: 0 });
  assert.deepEqual(controllers_lean([{ ...left, is_tracked: false }]), ZERO);
});

test('a pinched hand leans by how far it was moved, seen from who moves it', () => {
  const at = new Vector3(0.2, 1.2, -0.4);
  const flat = new Quaternion();
  for (const ahead_rad of [0, 1, -2.5]) {
    const from = { at, turned: flat, ahead_rad };
    const up = new Vector3(0, 1, 0);
    const to = (right: number, up_m: number, ahead: number): Vector3 =>
      new Vector3(right, up_m, -ahead).applyAxisAngle(up, ahead_rad).add(at);
    assert.deepEqual(moved_lean(from, to(0.013, -0.013, 0.013), flat), ZERO); // a hand trembles
    const half = moved_lean(from, to(0, 0, 0.07), flat);
    near(half.surge, 0.5, 1e-6);
    near(half.sway, 0, 1e-6);
    near(moved_lean(from, to(-0.3, 0, 0), flat).sway, -1);
    near(moved_lean(from, to(0, 0.12, 0), flat).heave, -1, 1e-6); // a hand up is a vehicle up
    // The wrist to the right is to starboard.
    const right = new Quaternion().setFromAxisAngle(up, -0.42);
    near(moved_lean(from, at, right).yaw, 0.5, 1e-6);
    near(moved_lean(from, at, right.clone().invert()).yaw, -0.5, 1e-6);
  }
});

/** A stick that is driven by a squeeze, and the hand that does it. */
function driven(): { stick: Stick; helm: HelmHand; frame: (...it: HandReading[]) => void } {
  const [stick, helm] = [new Stick(), new HelmHand()];
  let now_ms = 0;
  const frame = (...hands: HandReading[]): void => {
    now_ms += 20;
    helm.take(hands, 0, always, now_ms);
    helm.look(stick, now_ms);
  };
  for (let i = 0; i < 2; i += 1) frame(controller('left')); // new hands, then open ones
  stick.tick(OPEN);
  frame(controller('left', { is_squeezed: true, stick: { right: 0, up: 1 } }));
  assert.deepEqual(stick.tick(OPEN).lean, { ...ZERO, surge: 1 });
  return { stick, helm, frame };
}
const SQUEEZED = controller('left', { is_squeezed: true, stick: { right: 0, up: 1 } });

test('released is zero, once, though the thumb stays on the stick', () => {
  const { stick, frame } = driven();
  frame({ ...SQUEEZED, is_squeezed: false });
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
  frame({ ...SQUEEZED, is_squeezed: false });
  assert.equal(stick.tick(OPEN).lean, null);
  frame(SQUEEZED);
  assert.equal(stick.tick(OPEN).lean?.surge, 1);
});

const LOSSES: [string, (it: ReturnType<typeof driven>) => void][] = [
  ['a controller that is gone', ({ frame }) => frame()],
  ['a hand that is not tracked', ({ frame }) => frame({ ...SQUEEZED, is_tracked: false })],
  ['a headset that is taken off', ({ helm, stick }) => (helm.lose(), helm.look(stick, 60))],
  ['frames that no longer come', ({ helm, stick }) => helm.look(stick, 60 + 501)],
];
for (const [what, lose] of LOSSES)
  test(`${what} is zero, and must be seen open before it drives again`, () => {
    const it = driven();
    lose(it);
    assert.deepEqual(it.stick.tick(OPEN).lean, ZERO);
    for (let i = 0; i < 5; i += 1) {
      it.frame(SQUEEZED); // back, and squeezed all the while
      assert.equal(it.stick.tick(OPEN).lean, null);
    }
    it.frame({ ...SQUEEZED, is_squeezed: false });
    assert.equal(it.stick.tick(OPEN).lean, null);
    it.frame(SQUEEZED);
    assert.equal(it.stick.tick(OPEN).lean?.surge, 1);
  });

test('a loss between two looks is not missed', () => {
  const { stick, helm } = driven();
  helm.take([], 0, always, 50);
  helm.take([SQUEEZED], 0, always, 60);
  helm.look(stick, 60);
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
});

test('another hand that is squeezed does not go on where one was lost', () => {
  const { stick, frame } = driven();
  const other = controller('right', { is_squeezed: true, stick: { right: 0, up: 1 } });
  frame(SQUEEZED, other);
  stick.tick(OPEN);
  frame(other);
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
  frame(other);
  assert.equal(stick.tick(OPEN).lean, null);
});

test('a hand that held before it might, as one that comes from the table, drives nothing', () => {
  const [stick, helm] = [new Stick(), new HelmHand()];
  helm.take([controller('left')], 0, always, 0);
  helm.take([SQUEEZED], 0, () => false, 20);
  helm.take([SQUEEZED], 0, always, 40);
  assert.equal(helm.held_by, null);
  helm.look(stick, 40);
  assert.equal(stick.tick(OPEN).lean, null);
});

test('what is not open for keys is not open for a headset', () => {
  for (const shut of [
    { is_open: false },
    { is_hidden: true },
    { has_helm: false },
    { frame_age_ms: 1001 },
    { clock_is_known: false },
  ]) {
    const { stick, frame } = driven();
    assert.equal(stick.tick({ ...OPEN, ...shut }).lean, null);
    frame(SQUEEZED);
    assert.equal(stick.tick(OPEN).lean, null);
    assert.equal(stick.tick(OPEN).must_release, true);
  }
});

// The table.

function table_with(places: Place[]): {
  rig: Rig;
  hand: TableHand;
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
  return { rig, hand: new TableHand(rig, deeds), told, local };
}
const none: ReadonlySet<Side> = new Set();

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
  const { hand, told, local, rig } = table_with(places);
  const at = local(places[0]!);
  hand.take([hand_at(at, false)], none);
  hand.take([hand_at(at, true)], none);
  const moved = new Vector3(0.03, 0.02, -0.01); // in the hand's own axes
  hand.take([hand_at(at.clone().add(moved), true)], none);
  // The rig was not turned: its axes are east, up and south.
  near(places[0]!.east_m, 100 + 500 * 0.03, 0.01);
  near(places[0]!.north_m, 350 + 500 * 0.01, 0.01);
  near(places[0]!.up_m, -12);
  const other = controller('left', { is_pressed: true });
  hand.take([hand_at(at.clone().add(moved), true), other], none);
  near(places[0]!.up_m, -12 + 500 * 0.02, 1e-6);
  hand.take([hand_at(at, false)], none);
  assert.deepEqual(told, ['pick 0', 'let go']);
  near(rig.scale, 500);
});

test('a vehicle is chosen by a pinch on it, and not by one that drags the table', () => {
  const { hand, told, local, rig } = table_with([]);
  const at = local({ east_m: 200, north_m: 300, up_m: -10 });
  hand.take([hand_at(at, true)], none);
  hand.take([hand_at(at, false)], none);
  assert.deepEqual(told, ['choose 4']);
  hand.take([hand_at(at, true)], none);
  hand.take([hand_at(at.clone().setX(at.x + 0.1), true)], none);
  hand.take([hand_at(at.clone().setX(at.x + 0.2), true)], none);
  hand.take([hand_at(at, false)], none);
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
  const { hand, told, local } = table_with(places);
  const at = local(places[0]!);
  hand.take([hand_at(at.clone().setY(at.y + 0.031), true)], none); // reach is 0.03 m
  hand.take([], none);
  assert.deepEqual(told, []);
  hand.take([hand_at(at, true)], none);
  hand.take([{ ...hand_at(at.clone().setX(at.x + 1), true), is_tracked: false }], none);
  near(places[0]!.east_m, 100);
  hand.lose();
  hand.take([hand_at(at, true)], none); // still pinched: not taken again
  assert.deepEqual(told, ['pick 0', 'let go']);
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

// The board.

test('a finger tip that comes through a button of the board presses it once', () => {
  const canvas = { getContext: () => null };
  Object.assign(globalThis, {
    document: { createElement: () => canvas, documentElement: {} },
    getComputedStyle: () => ({ getPropertyValue: () => '#000000' }),
  });
  const board = new Board();
  const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.3);
  board.follow({ at: new Vector3(0, 1.6, 0), turned });
  const pressed: string[] = [];
  const texts = ['HOLD', 'Give back', 'Leave'];
  board.show(
    [],
    texts.map((text) => ({ text, is_strong: false, press: () => pressed.push(text) })),
  );
  const box = button_boxes(3)[1]!;
  /** Over the middle of the second one, so far before the board. */
  const tip = (before_m: number): Vector3 => {
    const { width, height } = board.mesh.geometry.parameters;
    const [x, y] = [box.x + box.wide / 2, box.y + 27];
    const at = new Vector3((x / 560 - 0.5) * width, (0.5 - y / 700) * height, before_m);
    return board.mesh.localToWorld(at);
  };
  for (const before_m of [0.2, 0.02, 0.005, -0.005, 0.005, 0.03, 0.005])
    board.touch('right', tip(before_m));
  assert.deepEqual(pressed, ['Give back']);
  for (const before_m of [0.05, 0.005]) board.touch('right', tip(before_m));
  assert.deepEqual(pressed, ['Give back', 'Give back']);
  // A ray that meets it presses what it meets, one beside it nothing.
  const from = new Vector3(0, 1.6, 0);
  const ray = (to: Vector3): boolean => board.press(from, to.clone().sub(from).normalize());
  assert.equal(ray(tip(0)), true);
  assert.equal(pressed.length, 3);
  assert.equal(ray(tip(0).add(new Vector3(0, 3, 0))), false);
  // It stays where it is until one has turned away from it, then it comes along.
  const stood = board.mesh.position.clone();
  board.follow({ at: from, turned: new Quaternion() });
  near(board.mesh.position.distanceTo(stood), 0);
  board.follow({ at: from, turned: turned.clone().set(0, 1, 0, 0) });
  assert.ok(board.mesh.position.distanceTo(stood) > 0.5);
});

// Hands and ways in.

test('a hand has 25 joints, and bones from the wrist to each finger tip', () => {
  assert.equal(JOINTS.length, 25);
  assert.equal(new Set(JOINTS).size, 25);
  assert.equal(BONES.length, 24);
  for (let nth = 1; nth < 25; nth += 1) {
    let at = nth;
    for (let i = 0; i < 5 && at !== 0; i += 1) at = BONES.find(([, into]) => into === at)![0];
    assert.equal(at, 0, `${JOINTS[nth]} hangs on the wrist`);
  }
});

test('a pinch ends farther apart than it begins', () => {
  assert.deepEqual(
    [0.02, 0.014, 0.02, 0.029, 0.031, 0.02].map(
      (() => {
        let is = false;
        return (apart_m: number) => (is = is_pinch(is, apart_m));
      })(),
    ),
    [false, true, true, true, false, false],
  );
});

test('a stretched index among bent fingers points, a flat hand and a fist do not', () => {
  /** The knuckles 9 cm from the wrist, the tips as far as told. */
  const hand = (index_m: number, others_m: number): Vector3[] =>
    JOINTS.map((joint) => {
      const tip_m = joint.startsWith('index') ? index_m : others_m;
      return new Vector3(0, 0, joint === 'wrist' ? 0 : joint.endsWith('tip') ? -tip_m : -0.09);
    });
  assert.equal(is_pointing_hand(hand(0.17, 0.07)), true);
  assert.equal(is_pointing_hand(hand(0.17, 0.17)), false);
  assert.equal(is_pointing_hand(hand(0.07, 0.07)), false);
  assert.equal(is_pointing_hand([]), false);
});

test('a way in is offered where the browser says so, and nothing where it fails', async () => {
  const xr = (say: (mode: string) => Promise<boolean>): XRSystem =>
    ({ isSessionSupported: say }) as unknown as XRSystem;
  assert.deepEqual([...(await modes_there(undefined))], []);
  assert.deepEqual([...(await modes_there(xr(async (it) => it === 'immersive-ar')))], ['ar']);
  assert.deepEqual([...(await modes_there(xr(() => Promise.reject(new Error('no')))))], []);
  const asked = JSON.stringify(FEATURES_OF);
  assert.ok(!asked.includes('dom-overlay'));
});

test('comfort is kept in the settings', () => {
  const otherwise = default_settings(false);
  const kept = { headset_narrows: false, headset_is_seated: true };
  const read = read_settings(JSON.stringify({ ...otherwise, ...kept }), otherwise);
  assert.deepEqual([read.headset_narrows, read.headset_is_seated], [false, true]);
  const bad = read_settings('{"headset_narrows": 1, "headset_is_seated": "yes"}', otherwise);
  assert.deepEqual([bad.headset_narrows, bad.headset_is_seated], [true, false]);
});
