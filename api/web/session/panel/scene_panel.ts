// The scene in place of the plan: opened by who wants it, looked about in with pointer or keys.
import { button, by_id, choice, element, set_hidden, set_text } from '../../look/element';
import type { SpeedUnit } from '../look/units';
import { SceneView, type Shown } from '../scene/scene_view';
import { approaches_in } from '../scene/approach';
import type { Stand } from '../scene/eye';
import type { InPicture } from '../scene/handles';
import { scene_in_words } from '../scene/in_words';
import type { LastPicture } from '../scene/picture_view';
import type { Session } from '../session/state';
import type { Station } from '../station';
import { current_tools } from './current_tools';
import { layer_tools } from './layer_tools';
import { scene_people } from './scene_people';
import { surfaces_fetched } from './surfaces_fetched';
import { in_picture, way_hand } from './way_hand';
import type { OrdersBar } from './orders_bar';
import { way_tools } from './way_tools';
import type { WaypointEdit } from './waypoint_edit';
import { Headset } from '../xr/headset';
import { headset_cover } from '../xr/headset_cover';
import { headset_tools } from '../xr/headset_tools';

const TURN_RAD_PER_PX = 0.006;
const TURN_BY_KEY_RAD = 0.12;
const CLOSER_BY_STEP = 1.15;
const LIFT_BY_KEY_M = 0.5;

export interface ScenePanel {
  readonly opener: HTMLButtonElement;
  readonly headset: Headset;
  is_open(): boolean;
  /** The name of what is seen at a place of the window, or in the middle; empty: it has none. */
  named_at(at: { clientX: number; clientY: number }): string;
  named_ahead(): string;
  /** Draws, if it is open and nobody wears a headset: that has frames of its own. */
  draw(shown: Shown): void;
}

function show_words(list: HTMLElement, session: Session, speed_unit: SpeedUnit): void {
  const lines = scene_in_words(session, approaches_in(session), speed_unit);
  while (list.children.length > lines.length) list.lastChild?.remove();
  while (list.children.length < lines.length) list.append(element('li', {}));
  lines.forEach((line, nth) => set_text(list.children[nth] as HTMLElement, line));
}

/** What the page does for it. */
export interface SceneMeans {
  way: WaypointEdit;
  orders: OrdersBar;
  last_picture: () => LastPicture | null;
  shown: () => Shown;
  /** A frame was drawn in the headset. */
  drawn: () => void;
  choose: (vehicle: number) => void;
  /** A hand of the headset drives. */
  drives: () => boolean;
  on_change: () => void;
}

export function scene_panel(station: Station, means: SceneMeans): ScenePanel {
  const { way, last_picture, on_change } = means;
  const canvas = element('canvas', {
    id: 'scene-canvas',
    tabindex: 0,
    role: 'application',
    'aria-label':
      'The scene in depth. Arrow keys turn, plus and minus come closer, ' +
      'page up and page down lift and lower the picked place of a way, ' +
      'Enter points at the middle, or puts a place there, where Point or Place is pressed. ' +
      'The table of vehicles says the same in words.',
  });
  const labels = element('div', { class: 'scene-labels', 'aria-hidden': true });
  const note = element('p', { class: 'plan-note', role: 'status' });
  let view: SceneView | null = null;
  let shown: Shown | null = null;
  const stands = choice<Stand>(
    'Where you look from',
    [
      ['follow', 'Follow'],
      ['on_board', 'On board'],
      ['above', 'Above'],
      ['free', 'Free'],
    ],
    (stand) => {
      if (view === null) return;
      view.eye.stand = stand;
      stands.show(stand);
      on_change();
    },
  );
  const all = button('All', () => {
    if (view === null || shown === null) return;
    view.see_all(shown.session);
    stands.show(view.eye.stand);
    on_change();
  });
  const clear = button(
    'Clear water',
    () => {
      if (view === null) return;
      const { surround } = view;
      surround.is_clear = !surround.is_clear;
      clear.setAttribute('aria-pressed', String(surround.is_clear));
      set_text(note, surround.is_clear ? 'Water is shown clearer than it is.' : '');
      set_hidden(note, !surround.is_clear);
      on_change();
    },
    { 'aria-pressed': 'false' },
  );
  const current = current_tools((up_m) => {
    if (view === null) return;
    view.slice_up_m = up_m;
    on_change();
  });
  const wakes = button(
    'Wakes',
    () => {
      if (view === null) return;
      view.shows_wakes = !view.shows_wakes;
      wakes.setAttribute('aria-pressed', String(view.shows_wakes));
      on_change();
    },
    { 'aria-pressed': 'false' },
  );
  const layers = layer_tools(on_change);
  const fetch_surfaces = surfaces_fetched(station, on_change);
  const people = scene_people(station, on_change);
  const hand = way_hand(way);
  const on_way = way_tools(way, hand);
  const headset = new Headset({
    station,
    way,
    orders: means.orders,
    people,
    shown: means.shown,
    draw: () => {
      if (draw(means.shown())) means.drawn();
      cover.show();
    },
    choose: means.choose,
    drives: means.drives,
    on_change: () => {
      in_headset.show();
      cover.show();
      on_change();
    },
  });
  canvas.addEventListener('webglcontextlost', () => headset.leave());
  const cover = headset_cover(headset);
  const in_headset = headset_tools(headset, () => view);
  const words = element('ul', {});
  const in_words = element(
    'details',
    { class: 'scene-words' },
    element('summary', {}, 'The scene in words'),
    words,
    people.notes,
  );
  const tools = element(
    'div',
    { class: 'tools scene-tools' },
    stands.node,
    all,
    clear,
    wakes,
    ...layers.nodes,
    ...current.nodes,
    ...people.nodes,
    ...on_way.nodes,
    ...in_headset.nodes,
  );
  const parts = [canvas, labels, cover.node, note, tools, in_words];
  const box = element('div', { id: 'scene', hidden: true }, ...parts);
  by_id('plan').after(box);

  const open = (): void => {
    if (view === null) {
      try {
        view = new SceneView(canvas, labels);
        view.layers = layers.layers;
        stands.show(view.eye.stand);
        set_text(note, '');
      } catch {
        set_text(note, 'This browser does not draw in depth (WebGL 2). The plan shows the same.');
      }
      set_hidden(note, note.textContent === '');
    }
  };
  const opener = button(
    'Scene',
    () => {
      set_hidden(box, !box.hidden);
      opener.setAttribute('aria-pressed', String(!box.hidden));
      if (box.hidden) {
        headset.leave();
        people.go();
      } else open();
      on_change();
    },
    { 'aria-pressed': 'false' },
  );

  let from: { x: number; y: number } | null = null;
  const turn = (right_rad: number, up_rad: number): void => {
    view?.eye.turn(right_rad, up_rad);
    on_change();
  };
  /** True: a place of a way was put there, or it is pointed at. */
  const press = (at: InPicture): boolean =>
    (view !== null && on_way.put(view.eye.camera, at)) ||
    people.press(() => view?.place_under(at) ?? null);
  canvas.addEventListener('pointerdown', (event) => {
    const at = in_picture(canvas, event);
    if (press(at)) return;
    if (view !== null && hand.take(view.eye.camera, at)) {
      canvas.setPointerCapture(event.pointerId);
      return;
    }
    from = { x: event.clientX, y: event.clientY };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    const is_upright = event.shiftKey || on_way.is_up_and_down();
    if (view !== null && hand.move(view.eye.camera, in_picture(canvas, event), is_upright)) return;
    if (from === null) return;
    turn((event.clientX - from.x) * TURN_RAD_PER_PX, (event.clientY - from.y) * TURN_RAD_PER_PX);
    from = { x: event.clientX, y: event.clientY };
  });
  for (const end of ['pointerup', 'pointercancel'] as const)
    canvas.addEventListener(end, () => {
      from = null;
      hand.let_go();
    });
  const closer = (factor: number): void => {
    view?.eye.closer(factor);
    on_change();
  };
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      closer(event.deltaY < 0 ? CLOSER_BY_STEP : 1 / CLOSER_BY_STEP);
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    const by_key: Record<string, () => void> = {
      ArrowLeft: () => turn(-TURN_BY_KEY_RAD, 0),
      ArrowRight: () => turn(TURN_BY_KEY_RAD, 0),
      ArrowUp: () => turn(0, TURN_BY_KEY_RAD),
      ArrowDown: () => turn(0, -TURN_BY_KEY_RAD),
      '+': () => closer(CLOSER_BY_STEP),
      '-': () => closer(1 / CLOSER_BY_STEP),
      Enter: () => press({ right: 0, up: 0 }),
      PageUp: () => hand.lift(LIFT_BY_KEY_M),
      PageDown: () => hand.lift(-LIFT_BY_KEY_M),
    };
    const deed = by_key[event.key];
    if (deed === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    deed();
  });

  /** False: there is no picture. */
  const draw = (now: Shown): boolean => {
    shown = now;
    if (box.hidden) return false;
    const { speed_unit } = station.settings;
    if (view !== null) {
      view.speed_unit = speed_unit;
      view.site.picture = last_picture();
      if (layers.layers.inspected) fetch_surfaces(view.site.inspected);
    }
    view?.draw(now);
    layers.show(now.session, now.chosen);
    set_hidden(wakes, now.session.turbines === null);
    current.show(now.session.weather?.currents ?? []);
    people.show();
    on_way.show();
    if (view !== null) people.tell(view);
    if (in_words.open) show_words(words, now.session, speed_unit);
    return view !== null && !view.renderer.getContext().isContextLost();
  };

  return {
    opener,
    headset,
    is_open: () => !box.hidden,
    named_at: (at) => view?.named_under(in_picture(canvas, at)) ?? '',
    named_ahead: () => {
      const eye = view?.looks_from();
      return eye === undefined ? '' : (view?.named_along(eye.at, eye.along) ?? '');
    },
    draw: (now) => {
      if (!headset.is_worn()) draw(now);
    },
  };
}
