// Turbines and zones on trial, at the place that is chosen on the map.
import type { Desk } from '../look/desk';
import { place_text } from '../look/units';
import { button, element, labelled, set_hidden, set_text } from '../../look/element';
import type { Draft } from './draft';

const NO_PLACE =
  'Choose a place on the map: press on it, or move it with the keys and press Enter.';
const RADIUS_M = 500;
const MOST_M = 50_000;

export interface OnMap {
  node: HTMLElement;
  /** Another place is chosen. */
  show(): void;
}

export function on_map(desk: Desk, draft: Draft, changed: () => void): OnMap {
  const where = element('p', { class: 'note' });
  const list = element('ul', { class: 'trial-list' });
  const turbine = element('select');
  const radius = element('input', { type: 'number', min: 1, max: MOST_M, value: RADIUS_M });
  const move = button('Move it here', () => {
    const { place } = desk.view.values;
    if (place === null) return;
    draft.move_turbine(turbine.value, place);
    show_all();
    changed();
  });
  const add = button('Add a turbine here', () => {
    const { place } = desk.view.values;
    if (place === null) return;
    const id = draft.add_turbine(place);
    show_all();
    turbine.value = id;
    changed();
  });
  const close = button('Keep out around here', () => {
    const { place } = desk.view.values;
    const radius_m = radius.valueAsNumber;
    const is_sound = radius_m > 0 && radius_m <= MOST_M;
    radius.setAttribute('aria-invalid', String(!is_sound));
    if (place === null || !is_sound) return;
    draft.add_zone(place, radius_m);
    show_all();
    changed();
  });
  const show = (): void => {
    const { place } = desk.view.values;
    set_text(
      where,
      place === null ? NO_PLACE : `Chosen: ${place_text(place.longitude_deg, place.latitude_deg)}`,
    );
    for (const it of [move, add, close]) it.disabled = place === null;
    if (turbine.options.length === 0) move.disabled = true;
  };
  const show_all = (): void => {
    const chosen = turbine.value;
    const ids = draft.turbines.map(({ id }) => id);
    turbine.replaceChildren(...ids.map((id) => element('option', { value: id }, id)));
    if (ids.includes(chosen)) turbine.value = chosen;
    const { turbines, zones } = draft.trial;
    list.replaceChildren(
      ...turbines.map(({ id, place, is_new }) => {
        const at = place_text(place.longitude_deg, place.latitude_deg);
        return element('li', {}, `${id}: ${is_new ? 'new' : 'moved'}, at ${at}`);
      }),
      ...zones.map(({ id }) => element('li', {}, `${id}: a zone to keep out of`)),
    );
    set_hidden(list, turbines.length + zones.length === 0);
    desk.view.try_out(draft.trial);
    show();
  };
  show_all();
  const node = element(
    'div',
    {},
    where,
    element(
      'div',
      { class: 'limit-list' },
      labelled('Turbine to move', turbine),
      labelled('Keep out within (m)', radius),
    ),
    element('p', { class: 'buttons' }, move, add, close),
    list,
  );
  return { node, show };
}
