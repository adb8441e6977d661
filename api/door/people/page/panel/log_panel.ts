// The record of this run: each action, taken or refused, the last on top.
import { scroll_region, element, labelled } from '../look/element';
import { zone_of } from '../look/settings';
import { time_text } from '../look/units';
import type { Action } from '../session/message';
import { vehicle_name } from '../session/state';
import type { Panel, Station } from '../station';
import { plain } from './state_panel';

const ROWS_SHOWN = 150;

export function log_panel(station: Station): Panel {
  const filter = element('select');
  const only_refused = element('input', { type: 'checkbox' });
  const list = element('ol', { class: 'log' });
  const scroll = scroll_region('Actions, list', list);
  const box = element(
    'section',
    { class: 'record' },
    element('h2', {}, 'Actions'),
    element(
      'div',
      { class: 'pair' },
      labelled('Vehicle', filter),
      element('label', { class: 'check' }, only_refused, 'Refused only'),
    ),
    scroll,
  );
  let shown = '';
  let listed = '';

  return {
    box,
    show: () => {
      const { session, settings } = station;
      const options = JSON.stringify(
        [...session.vehicles.values()].map((it) => [it.vehicle, it.name]),
      );
      if (options !== listed) {
        listed = options;
        const before = filter.value;
        filter.replaceChildren(
          element('option', { value: '' }, 'All'),
          ...[...session.vehicles.values()].map((it) =>
            element('option', { value: it.vehicle }, it.name),
          ),
        );
        filter.value = before;
        if (filter.selectedIndex < 0) filter.value = '';
      }
      const last = session.actions[session.actions.length - 1]?.number ?? -1;
      const key = JSON.stringify([
        last,
        session.actions.length,
        filter.value,
        only_refused.checked,
        settings,
        options,
      ]);
      if (key === shown) return;
      shown = key;
      const wanted = filter.value === '' ? null : vehicle_name(session, Number(filter.value));
      const rows = session.actions
        .filter((it) => wanted === null || vehicle_name(session, it.vehicle) === wanted)
        .filter((it) => !only_refused.checked || !it.taken)
        .slice(-ROWS_SHOWN)
        .reverse();
      list.replaceChildren(...rows.map((it) => row(it)));
      if (rows.length === 0) list.append(element('li', { class: 'note' }, 'Nothing yet.'));
    },
  };

  function row(action: Action): HTMLElement {
    const { session, settings } = station;
    const at_ms = Date.parse(action.at);
    const when = Number.isNaN(at_ms)
      ? `${action.time_s.toFixed(0)} s`
      : time_text(at_ms, zone_of(settings), true);
    const vehicle = vehicle_name(session, action.vehicle);
    const change =
      action.after === ''
        ? ''
        : action.before === ''
          ? `: ${plain(action.after)}`
          : `: ${plain(action.before)} → ${plain(action.after)}`;
    const made = element(
      'li',
      {},
      element('span', { class: 'when' }, when),
      ' ',
      element('strong', {}, action.who || 'the server'),
      ` ${plain(action.what)}${vehicle === '' ? '' : ` ${vehicle}`}${change}`,
    );
    if (!action.taken) {
      made.classList.add('refused');
      made.append(
        element(
          'span',
          { class: 'why' },
          ` Refused${action.why === '' ? '' : `: ${plain(action.why)}`}`,
        ),
      );
    } else if (action.why !== '' && !action.after.includes(action.why))
      made.append(element('span', { class: 'note' }, ` (${plain(action.why)})`));
    return made;
  }
}
