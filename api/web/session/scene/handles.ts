// Places of a way that are taken hold of in the scene: over a level plane, or up and down.
import { Plane, Raycaster, Vector2, Vector3, type PerspectiveCamera } from 'three';
import { at_place, at_scene, type Place } from './axes';

/** A place of the picture, from -1 to 1 to the right and up. */
export interface InPicture {
  right: number;
  up: number;
}

export const FARTHEST_M = 3000; // that something is pointed at, or a place is moved to

function ray_through(camera: PerspectiveCamera, at: InPicture): Raycaster['ray'] {
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2(at.right, at.up), camera);
  return caster.ray;
}

/** Where the level plane of a place is seen there; nothing: it is not, or it is far away. */
export function moved_level(camera: PerspectiveCamera, place: Place, to: InPicture): Place | null {
  const level = new Plane(new Vector3(0, 1, 0), -place.up_m);
  const at = ray_through(camera, to).intersectPlane(level, new Vector3());
  if (at === null || at.distanceTo(camera.position) > FARTHEST_M) return null;
  return { ...at_scene(at), up_m: place.up_m };
}

/** How high it would be on its plumb line to be seen there; nothing: one looks along the line. */
export function moved_up(camera: PerspectiveCamera, place: Place, to: InPicture): number | null {
  const from = at_place(place);
  const facing = camera.position.clone().sub(from).setY(0);
  if (facing.length() < 1e-3) return null;
  const wall = new Plane().setFromNormalAndCoplanarPoint(facing.normalize(), from);
  const at = ray_through(camera, to).intersectPlane(wall, new Vector3());
  return at === null || at.distanceTo(camera.position) > FARTHEST_M ? null : at.y;
}

/** The one that is seen nearest to there, within a share of the picture's height; nothing: none. */
export function held_at(
  camera: PerspectiveCamera,
  places: readonly Place[],
  at: InPicture,
  within = 0.05,
): number | null {
  let best: number | null = null;
  let least = within;
  places.forEach((place, nth) => {
    const seen = at_place(place).project(camera);
    if (Math.abs(seen.z) > 1) return;
    const away = Math.hypot((seen.x - at.right) * camera.aspect, seen.y - at.up);
    if (away > least) return;
    least = away;
    best = nth;
  });
  return best;
}
