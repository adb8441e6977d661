// A hand that moves the places of a way under edit in the scene: level, and with Shift up and down.
import type { PerspectiveCamera } from 'three';
import { held_at, moved_level, moved_up, type InPicture } from '../scene/handles';
import type { WaypointEdit } from './waypoint_edit';

export interface WayHand {
  /** True: a place is there, and held from now on. */
  take(camera: PerspectiveCamera, event: PointerEvent): boolean;
  /** True: a place is held. */
  move(camera: PerspectiveCamera, event: PointerEvent): boolean;
  let_go(): void;
  /** The picked place, by keys. */
  lift(by_m: number): void;
}

export function way_hand(canvas: HTMLCanvasElement, way: WaypointEdit): WayHand {
  let held: number | null = null;
  const in_picture = (event: PointerEvent): InPicture => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const right = (event.clientX - left) / width;
    const down = (event.clientY - top) / height;
    return { right: 2 * right - 1, up: 1 - 2 * down };
  };
  return {
    take: (camera, event) => {
      const draft = way.draft();
      held = draft === null ? null : held_at(camera, draft.places, in_picture(event));
      if (held !== null) way.pick(held);
      return held !== null;
    },
    move: (camera, event) => {
      const place = held === null ? undefined : way.draft()?.places[held];
      if (place === undefined) return false;
      if (event.shiftKey) {
        const up_m = moved_up(camera, place, in_picture(event));
        if (up_m !== null) way.lift(up_m);
      } else {
        const to = moved_level(camera, place, in_picture(event));
        if (to !== null) way.move(to);
      }
      return true;
    },
    let_go: () => {
      if (held !== null) way.let_go();
      held = null;
    },
    lift: (by_m) => {
      const draft = way.draft();
      const place = draft === null || draft.picked === null ? null : draft.places[draft.picked];
      if (place == null) return;
      way.lift(place.up_m + by_m);
      way.let_go();
    },
  };
}
