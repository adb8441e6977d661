// Who looks at the scene is seen there by the others: from where, to where, and what is pointed
// at. And notes are put at places.
import { button, element, labelled, set_hidden, set_text } from '../../look/element';
import type { SceneView } from '../scene/scene_view';
import { look_along } from '../scene/people_shown';
import { at_scene } from '../scene/axes';
import type { Point } from '../session/message';
import type { Station } from '../station';

const TOLD_EVERY_MS = 250;
const POINTS_FOR_MS = 8000;

export interface ScenePeople {
  readonly nodes: HTMLElement[];
  readonly notes: HTMLElement;
  /** A place of the scene was pressed. True: it is pointed at, if there is one. */
  press(place: () => Point | null): boolean;
  /** A hand in a headset points there now, or at nothing. */
  point_at(place: Point | null): void;
  /** The scene was closed: the others see nobody there any more. */
  go(): void;
  /** Tells the others, if something changed. */
  tell(view: SceneView): void;
  show(): void;
}

export function scene_people(station: Station, on_change: () => void): ScenePeople {
  let is_pointing = false;
  let point: Point | null = null;
  let by_hand: Point | null = null;
  let pointed_ms = -Infinity;
  let told = '';
  let told_ms = -Infinity;
  let shown = '';
  const pointer = button(
    'Point',
    () => {
      is_pointing = !is_pointing;
      pointer.setAttribute('aria-pressed', String(is_pointing));
    },
    { 'aria-pressed': 'false' },
  );
  const words = element('input', {
    type: 'text',
    maxlength: 200,
    title: 'Put where you pointed last, or at the chosen vehicle',
  });
  const form = element(
    'form',
    { class: 'scene-note' },
    labelled('Note', words),
    element('button', { type: 'submit' }, 'Put'),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const text = words.value.trim();
    const chosen = station.chosen === null ? undefined : station.session.poses.get(station.chosen);
    const at = point ?? chosen;
    if (text === '' || at === undefined) return;
    const { east_m, north_m, up_m } = at;
    if (station.ask('Note', { do: 'note', text, at: { east_m, north_m, up_m } })) words.value = '';
  });
  const notes = element('ul', { class: 'scene-notes' });

  return {
    nodes: [pointer, form],
    notes,
    press: (place) => {
      if (!is_pointing) return false;
      point = place() ?? point;
      pointed_ms = performance.now();
      on_change();
      setTimeout(on_change, POINTS_FOR_MS); // a paused run draws no frames
      return true;
    },
    point_at: (place) => (by_hand = place),
    go: () => {
      if (told !== '') station.wire.send({ do: 'look' });
      told = '';
    },
    tell: (view) => {
      const now_ms = performance.now();
      if (station.session.seat === null || now_ms < told_ms + TOLD_EVERY_MS) return;
      const { at, along } = view.looks_from();
      const is_still = point !== null && now_ms < pointed_ms + POINTS_FOR_MS;
      const { heading_deg, tilt_deg } = look_along(along);
      const look = {
        do: 'look',
        from: at_scene(at),
        heading_deg: Math.round(heading_deg),
        tilt_deg: Math.round(tilt_deg),
        point: by_hand ?? (is_still ? point : null),
      };
      const text = JSON.stringify(look);
      if (text === told || station.wire.send(look) === null) return;
      told = text;
      told_ms = now_ms;
    },
    show: () => {
      const { session } = station;
      set_hidden(form, session.role === 'spectator');
      set_hidden(pointer, session.seat === null);
      const key = JSON.stringify([session.notes, session.role, session.seat]);
      if (key === shown) return;
      shown = key;
      notes.replaceChildren(
        ...session.notes.map((note) => {
          const line = element('li', {}, element('span', {}));
          set_text(line.firstChild!, `${note.who}: ${note.text} `);
          const may = note.seat === session.seat || station.is_supervisor();
          if (may)
            line.append(
              button(
                'Take away',
                () => void station.ask('Note', { do: 'unnote', note: note.note }),
              ),
            );
          return line;
        }),
      );
    },
  };
}
