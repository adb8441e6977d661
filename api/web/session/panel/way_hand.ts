// A hand that moves the places of a way under edit in the scene: level, and with Shift up and down.
import type { PerspectiveCamera } from 'three';
import { held_at, moved_level, moved_up, type InPicture } from '../scene/handles';
import type { WaypointEdit } from './waypoint_edit';

export interface WayHand {
  /** True: a place is there, and held from now on. */
  take(camera: PerspectiveCamera, at: InPicture): boolean;
  /** True: a place is held. */
  move(camera: PerspectiveCamera, to: InPicture, is_up_and_down: boolean): boolean;
  let_go(): void;
  /** The picked place, by keys. */
  lift(by_m: number): void;
}

/** Where a pointer is in the picture. */
export function in_picture(
  canvas: HTMLCanvasElement,
  event: { clientX: number; clientY: number },
): InPicture {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return {
    right: (2 * (event.clientX - left)) / width - 1,
    up: 1 - (2 * (event.clientY - top)) / height,
  };
}

export function way_hand(way: WaypointEdit): WayHand {
  let held: number | null = null;
  return {
    take: (camera, at) => {
      const draft = way.draft();
      held = draft === null ? null : held_at(camera, draft.places, at);
      if (held !== null) way.pick(held);
      return held !== null;
    },
    move: (camera, to, is_up_and_down) => {
      const place = held === null ? undefined : way.draft()?.places[held];
      if (place === undefined) return false;
      if (is_up_and_down) {
        const up_m = moved_up(camera, place, to);
        if (up_m !== null) way.lift(up_m);
      } else {
        const level = moved_level(camera, place, to);
        if (level !== null) way.move(level);
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
