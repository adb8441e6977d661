// The way of the chosen vehicle under edit: clicked, dragged, typed, and sent as a whole. While it
// changes the server is asked whether it would take it, so its refusal is read before the way is
// let go.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import { notice } from '../look/notice';
import type { Said } from '../look/said';
import { stick_speed_m_s } from '../drive/shaped';
import type { Answer, Waypoint } from '../session/message';
import type { PlanDrawing, PlanHand } from '../view/plan_view';
import type { Camera, Pixel, Plane } from '../view/camera';
import type { Panel, Station } from '../station';

const TRIAL_EVERY_MS = 200;
const PICK_WITHIN_PX = 16;

export interface WaypointEdit extends Panel, PlanHand {
  /** The verdict once more, on the plan, where the eyes are while dragging. */
  readonly plan_note: HTMLElement;
  draft(): PlanDrawing['draft'];
  /** Takes hold of a place of the draft; nothing: lets go of all. */
  pick(nth: number | null): void;
  /** Brings the picked one to a height, down negative. */
  lift(up_m: number): void;
  /** Puts a place at the level of new ones. */
  place(at: Plane): void;
  new_up_m(): number;
  remove_picked(): void;
  begin(): void;
  send(): void;
  end(): void;
  /** It is of the chosen vehicle, has places, and may be told. */
  may_send(): boolean;
  /** What the server would say to it. */
  said(): Said;
}

export function waypoint_edit(
  station: Station,
  camera: () => Camera,
  redraw: () => void,
): WaypointEdit {
  let places: Waypoint[] = [];
  let is_editing = false;
  let edited: number | null = null; // the vehicle whose way it is
  let picked: number | null = null;
  let refusal = '';
  let verdict: 'unknown' | 'good' | 'refused' = 'unknown';
  let last_trial_ms = -Infinity;
  let trial_timer: number | null = null;
  let trial_number = 0;
  let answered_number = 0; // an answer of a later list is not overruled by an earlier one's

  const flies = (): boolean =>
    station.chosen !== null &&
    (station.session.vehicles.get(station.chosen)?.kind.includes('uav') ?? false);
  const usual_speed_m_s = (): number => {
    const vehicle =
      station.chosen === null ? undefined : station.session.vehicles.get(station.chosen);
    return vehicle?.cruise_m_s ?? stick_speed_m_s(vehicle);
  };
  const depth = element('input', { type: 'number', step: 0.5, value: 10, min: 0, max: 12000 });
  const speed = element('input', { type: 'number', step: 0.1, min: 0.05, max: 40 });
  const is_loop = element('input', { type: 'checkbox' });
  is_loop.addEventListener('change', () => changed());
  const depth_field = labelled('Depth of new places, m', depth);
  const depth_label = depth_field.querySelector('label');
  const rows = element('tbody');
  const level_head = element('th', { scope: 'col' }, 'Depth, m');
  const table = element(
    'table',
    { class: 'places' },
    element('caption', { class: 'unseen' }, 'Places of the way'),
    element(
      'thead',
      {},
      element(
        'tr',
        {},
        ...['', 'East, m', 'North, m'].map((it) =>
          it === '' ? element('td') : element('th', { scope: 'col' }, it),
        ),
        level_head,
        element('th', { scope: 'col' }, 'Speed, m/s'),
        element('td'),
      ),
    ),
    rows,
  );
  const plan_note = element('p', { class: 'plan-note', 'aria-hidden': 'true' });
  const word = element('p', { class: 'reply', role: 'status' });
  const begin = button('Edit the way', () => start());
  const send = button('Send the way', () => send_all(), { class: 'strong' });
  const drop = button('Drop the changes', () => end());
  const add = button('Add a place', () => {
    const middle = camera();
    place({ east_m: middle.east_m, north_m: middle.north_m });
  });
  const editor = element(
    'div',
    { class: 'editor' },
    element(
      'p',
      { class: 'note' },
      'Click on the plan to place, drag to move; in the scene drag to move, ' +
        'with Shift up and down. ' +
        'In the table all can be typed.',
    ),
    element('div', { class: 'pair' }, depth_field, labelled('Their speed, m/s', speed)),
    element('label', { class: 'check' }, is_loop, 'Round and round'),
    element('div', { class: 'scroll' }, table),
    word,
    element('div', { class: 'buttons' }, send, add, drop),
  );
  const box = element(
    'section',
    { class: 'way' },
    element('h2', {}, 'Way'),
    element('div', { class: 'buttons' }, begin),
    editor,
  );
  set_hidden(editor, true);

  const start = (): void => {
    if (station.chosen === null) return;
    edited = station.chosen;
    places = (station.session.statuses.get(edited)?.waypoints ?? []).map((it) => ({ ...it }));
    picked = null;
    is_editing = true;
    verdict = 'unknown';
    refusal = '';
    const pose = station.session.poses.get(edited);
    const usual_m_s = usual_speed_m_s();
    speed.value = String(usual_m_s);
    for (const it of places) it.speed_m_s ??= usual_m_s;
    if (pose !== undefined)
      depth.value = (flies() ? Math.max(0, pose.up_m) : Math.max(0, -pose.up_m)).toFixed(1);
    fill_rows();
    redraw();
    if (matchMedia('(min-width: 701px)').matches) editor.scrollIntoView({ block: 'nearest' });
  };
  const end = (): void => {
    is_editing = false;
    edited = null;
    places = [];
    picked = null;
    answered_number = trial_number; // answers on their way are of a way that is gone
    redraw();
  };
  const new_up_m = (): number => {
    const value = Number(depth.value);
    const level = Number.isFinite(value) ? Math.abs(value) : 0;
    return flies() ? level : 0 - level;
  };
  const place = (at: Plane): void => {
    const speed_m_s = Number(speed.value) > 0 ? Number(speed.value) : usual_speed_m_s();
    places.push({ ...rounded(at), up_m: new_up_m(), speed_m_s });
    picked = places.length - 1;
    fill_rows();
    changed();
  };
  // The last verdict stands until the next is here: a line that blinks while dragging cannot be
  // read.
  const changed = (): void => {
    ask_trial();
    redraw();
  };
  const message = (is_trial: boolean): Record<string, unknown> => ({
    do: 'waypoints',
    places: places.map(({ east_m, north_m, up_m, speed_m_s }) => ({
      east_m,
      north_m,
      up_m,
      speed_m_s,
    })),
    is_loop: is_loop.checked,
    is_trial,
  });

  /** Five times a second at most, and always once more after the last change. */
  const ask_trial = (): void => {
    if (trial_timer !== null) return;
    const wait_ms = Math.max(0, last_trial_ms + TRIAL_EVERY_MS - performance.now());
    trial_timer = setTimeout(() => {
      trial_timer = null;
      if (!is_editing || places.length === 0) {
        verdict = 'unknown';
        redraw();
        return;
      }
      last_trial_ms = performance.now();
      trial_number += 1;
      const number = trial_number;
      station.command('Trial of the way', message(true), (answer: Answer) => {
        if (!is_editing || number <= answered_number) return;
        answered_number = number;
        verdict = answer.taken ? 'good' : 'refused';
        refusal = answer.taken ? '' : answer.text || answer.reason;
        redraw();
      });
    }, wait_ms) as unknown as number;
  };
  const may_send = (): boolean =>
    is_editing && station.chosen === edited && places.length > 0 && station.may_direct();
  const send_all = (): void => {
    if (!may_send()) return;
    station.command(`Way of ${station.chosen_name()}`, message(false), (answer) => {
      const why = answer.text || answer.reason;
      notice(
        answer.taken ? 'The way is taken.' : `The way is refused. ${why}`,
        answer.taken ? 'plain' : 'alarm',
      );
      if (answer.taken) end();
      verdict = answer.taken ? 'unknown' : 'refused';
      refusal = answer.taken ? '' : why;
      redraw();
    });
  };

  const is_refused = (): boolean => is_editing && verdict === 'refused';
  const verdict_text = (): string => {
    if (!is_editing || verdict === 'unknown') return '';
    return verdict === 'refused' ? `Refused: ${refusal}` : 'The server would take this way.';
  };

  const number_field = (
    name: string,
    value: number | null,
    set: (value: number | null) => void,
  ): HTMLElement => {
    const field = element('input', { type: 'number', step: 'any', 'aria-label': name });
    field.value = value === null ? '' : String(Math.round(value * 10) / 10);
    field.addEventListener('input', () => {
      const given = field.value === '' ? null : Number(field.value);
      if (given !== null && !Number.isFinite(given)) return;
      set(given);
      changed();
    });
    return element('td', {}, field);
  };
  const fill_rows = (): void => {
    rows.replaceChildren(
      ...places.map((it, i) => {
        const n = i + 1;
        const level = flies() ? it.up_m : 0 - it.up_m;
        return element(
          'tr',
          {},
          element('th', { scope: 'row' }, String(n)),
          number_field(
            `East of place ${n}, m`,
            it.east_m,
            (value) => (it.east_m = value ?? it.east_m),
          ),
          number_field(
            `North of place ${n}, m`,
            it.north_m,
            (value) => (it.north_m = value ?? it.north_m),
          ),
          number_field(`${flies() ? 'Height' : 'Depth'} of place ${n}, m`, level, (value) => {
            if (value !== null) it.up_m = flies() ? value : 0 - value;
          }),
          number_field(
            `Speed to place ${n}, m/s`,
            it.speed_m_s,
            (value) => (it.speed_m_s = value ?? it.speed_m_s),
          ),
          element(
            'td',
            {},
            button('×', () => remove(i), {
              'aria-label': `Delete place ${n}`,
              title: `Delete place ${n}`,
            }),
          ),
        );
      }),
    );
  };
  const remove = (i: number): void => {
    places.splice(i, 1);
    picked = null;
    fill_rows();
    changed();
  };
  const nearest = (pixel: Pixel): number | null => {
    let best: number | null = null;
    let least = PICK_WITHIN_PX;
    places.forEach((it, i) => {
      const at = camera().to_pixel(it);
      const away = Math.hypot(at.x - pixel.x, at.y - pixel.y);
      if (away <= least) {
        least = away;
        best = i;
      }
    });
    return best;
  };
  addEventListener('keydown', (event) => {
    if (!is_editing || picked === null || event.key !== 'Delete') return;
    if (document.activeElement instanceof HTMLInputElement) return;
    remove(picked);
  });

  return {
    box,
    plan_note,
    draft: () =>
      is_editing ? { places, picked, is_refused: is_refused(), is_loop: is_loop.checked } : null,
    pick: (nth) => {
      picked = nth;
      redraw();
    },
    lift: (up_m) => {
      const it = picked === null ? undefined : places[picked];
      if (it === undefined) return;
      it.up_m = Math.round(up_m * 10) / 10;
      changed();
    },
    place,
    new_up_m,
    remove_picked: () => {
      if (picked !== null) remove(picked);
    },
    begin: () => start(),
    send: () => send_all(),
    end,
    may_send,
    said: () => ({ text: verdict_text(), is_alarm: is_refused() }),
    press: (_at, pixel) => {
      if (!is_editing) return false;
      picked = nearest(pixel);
      return picked !== null;
    },
    move: (at) => {
      const it = picked === null ? undefined : places[picked];
      if (it === undefined) return;
      Object.assign(it, rounded(at));
      changed();
    },
    let_go: () => fill_rows(),
    click: (at) => {
      if (!is_editing) return false;
      place(at);
      return true;
    },
    show: () => {
      if (is_editing && station.chosen !== edited) end();
      set_hidden(box, station.session.role === 'spectator');
      set_hidden(editor, !is_editing);
      set_hidden(begin, is_editing);
      set_disabled(begin, !station.may_direct());
      set_disabled(send, !may_send());
      set_hidden(table, places.length === 0);
      if (depth_label !== null)
        set_text(depth_label, flies() ? 'Height of new places, m' : 'Depth of new places, m');
      set_text(level_head, flies() ? 'Height, m' : 'Depth, m');
      set_text(word, verdict_text());
      word.classList.toggle('alarm', is_refused());
      set_hidden(plan_note, !is_editing);
      set_text(plan_note, word.textContent || 'Click to place, drag to move.');
      plan_note.classList.toggle('alarm', is_refused());
    },
  };
}

function rounded(at: Plane): Plane {
  return { east_m: Math.round(at.east_m * 10) / 10, north_m: Math.round(at.north_m * 10) / 10 };
}
