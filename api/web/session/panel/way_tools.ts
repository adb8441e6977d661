// Hands on a way under edit in the scene that need no keys: places are put and taken away, and
// moved up and down by dragging or by steps.
import type { PerspectiveCamera } from 'three';
import { button, set_disabled, set_hidden } from '../../look/element';
import { moved_level, type InPicture } from '../scene/handles';
import type { WayHand } from './way_hand';
import type { WaypointEdit } from './waypoint_edit';

const STEP_M = 0.5;

export interface WayTools {
  readonly nodes: HTMLElement[];
  /** Dragging moves up and down its line what it moves level else. */
  is_up_and_down(): boolean;
  /** Puts a place where the level of new places is seen there. True: places are being put. */
  put(camera: PerspectiveCamera, at: InPicture): boolean;
  show(): void;
}

export function way_tools(way: WaypointEdit, hand: WayHand): WayTools {
  const pressed = (made: HTMLButtonElement): boolean =>
    made.getAttribute('aria-pressed') === 'true';
  const toggle = (text: string, title: string): HTMLButtonElement => {
    const made = button(text, () => made.setAttribute('aria-pressed', String(!pressed(made))), {
      'aria-pressed': 'false',
      title,
    });
    return made;
  };
  const put = toggle('Place', 'Press in the scene: a place is put at the level of new places');
  const upright = toggle('Up and down', 'Drag a place along its plumb line');
  const up = button('Up', () => hand.lift(STEP_M), { 'aria-label': 'Up half a metre' });
  const down = button('Down', () => hand.lift(-STEP_M), { 'aria-label': 'Down half a metre' });
  const away = button('Delete', () => way.remove_picked());
  const nodes = [put, upright, up, down, away];
  return {
    nodes,
    is_up_and_down: () => pressed(upright),
    put: (camera, at) => {
      if (way.draft() === null || !pressed(put)) return false;
      const level = { east_m: 0, north_m: 0, up_m: way.new_up_m() };
      const place = moved_level(camera, level, at);
      if (place !== null) way.place(place);
      return true;
    },
    show: () => {
      const draft = way.draft();
      for (const node of nodes) set_hidden(node, draft === null);
      for (const node of [up, down, away]) set_disabled(node, draft?.picked == null);
      if (draft === null) put.setAttribute('aria-pressed', 'false');
    },
  };
}
