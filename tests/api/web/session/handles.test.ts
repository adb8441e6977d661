// Places of a way that are moved in the scene: what is held stays under the hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Line, PerspectiveCamera, Scene, Vector3 } from 'three';
import { at_place, type Place } from 'page/scene/axes';
import { held_at, moved_level, moved_up } from 'page/scene/handles';
import { Kept } from 'page/scene/kept';
import { place_draft } from 'page/scene/way_shown';

/** From 30 m south and 20 m up it looks at the origin. */
function camera_from(x: number, y: number, z: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(55, 16 / 9, 0.1, 20_000);
  camera.position.set(x, y, z);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}
const camera = camera_from(0, 20, 30);
const seen_at = (place: Place): { right: number; up: number } => {
  const at = at_place(place).project(camera);
  return { right: at.x, up: at.y };
};
const near = (found: number | undefined, expected: number): void =>
  assert.ok(found !== undefined && Math.abs(found - expected) < 0.01, `${found}, not ${expected}`);

test('a place moves over its own level to where the hand is', () => {
  const from = { east_m: 1, north_m: 2, up_m: -12 };
  const to = { east_m: -4, north_m: 9, up_m: -12 };
  const found = moved_level(camera, from, seen_at(to));
  near(found?.east_m, -4);
  near(found?.north_m, 9);
  near(found?.up_m, -12);
  // Above the horizon there is no place of that level.
  assert.equal(moved_level(camera_from(0, 0, 30), from, { right: 0, up: 0.5 }), null);
});

test('up and down it stays on its plumb line', () => {
  const from = { east_m: 3, north_m: -5, up_m: -12 };
  near(moved_up(camera, from, seen_at({ ...from, up_m: -2.5 })) ?? undefined, -2.5);
  near(moved_up(camera, from, seen_at({ ...from, up_m: -30 })) ?? undefined, -30);
  // Who looks straight down the line sees no up or down.
  assert.equal(
    moved_up(camera_from(0, 20, 0), { east_m: 0, north_m: 0, up_m: -3 }, { right: 0, up: 0 }),
    null,
  );
});

test('what is nearest to the hand is held, and nothing that is far', () => {
  const places = [
    { east_m: 0, north_m: 0, up_m: -1 },
    { east_m: 5, north_m: 0, up_m: -1 },
    { east_m: 0, north_m: -80, up_m: 30 }, // behind who looks
  ];
  assert.equal(held_at(camera, places, seen_at(places[1]!)), 1);
  assert.equal(held_at(camera, places, seen_at({ ...places[0]!, east_m: 0.3 })), 0);
  assert.equal(held_at(camera, places, { right: 0.9, up: 0.9 }), null);
});

test('a way under edit has plumb lines to the surface and the bed', () => {
  const scene = new Scene();
  const places = [{ east_m: 1, north_m: 2, up_m: -12, speed_m_s: 1 }];
  const palette = { accent: '#0000ff', alarm: '#ff0000', amber: '#ffaa00' };
  const draft = { places, picked: null, is_refused: true, is_loop: false };
  place_draft(new Kept(scene), draft, { up_at: () => -30 }, palette);
  const [plumb] = scene.children.filter((it) => it instanceof Line) as Line[];
  assert.deepEqual([...plumb!.geometry.getAttribute('position').array], [1, 0, -2, 1, -30, -2]);
  const ball = scene.children.find((it) => !(it instanceof Line));
  assert.equal(ball!.position.distanceTo(new Vector3(1, -12, -2)), 0);
  place_draft(new Kept(new Scene()), null, { up_at: () => null }, palette);
});
