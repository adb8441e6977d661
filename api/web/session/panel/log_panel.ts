// The record of this run: each action, taken or refused, the last on top.
import { button, element, labelled } from '../../look/element';
import { driving_region } from '../look/region';
import { zone_of } from '../look/settings';
import { time_text } from '../look/units';
import type { Action } from '../session/message';
import { time_of } from '../session/playback';
import { vehicle_name } from '../session/state';
import type { Panel, Station } from '../station';
import { plain } from './state_panel';

const ROWS_SHOWN = 150;

/** @param seek  of a recording: to the time of the row that was pressed */
export function log_panel(station: Station, seek: (time_s: number) => void): Panel {
  const filter = element('select');
  const only_refused = element('input', { type: 'checkbox' });
  const list = element('ol', { class: 'log' });
  const scroll = driving_region('Actions, list', list);
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
  const rows_of = new Map<number, HTMLElement>();
  let head: HTMLElement | null = null;

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
        session.playback !== null,
        session.start_utc_ms,
      ]);
      if (key === shown) {
        show_head();
        return;
      }
      shown = key;
      const wanted = filter.value === '' ? null : vehicle_name(session, Number(filter.value));
      const rows = session.actions
        .filter((it) => wanted === null || vehicle_name(session, it.vehicle) === wanted)
        .filter((it) => !only_refused.checked || !it.taken);
      rows_of.clear();
      head = null;
      // A recording is read from its beginning, a run under way from now.
      const shown_rows = session.playback === null ? rows.slice(-ROWS_SHOWN).reverse() : rows;
      list.replaceChildren(
        ...shown_rows.map((it) => {
          const made = row(it);
          rows_of.set(it.number, made);
          return made;
        }),
      );
      if (rows.length === 0) list.append(element('li', { class: 'note' }, 'Nothing yet.'));
      show_head();
    },
  };

  /** The last row before the head of a recording, kept in sight. */
  function show_head(): void {
    const { playback } = station.session;
    if (playback === null) return;
    let now: HTMLElement | null = null;
    for (const [number, made] of rows_of) {
      if (number > playback.seen) break;
      now = made;
    }
    if (now === head) return;
    head?.classList.remove('head');
    head?.removeAttribute('aria-current');
    head = now;
    if (head === null) {
      scroll.scrollTop = 0;
      return;
    }
    head.classList.add('head');
    head.setAttribute('aria-current', 'true');
    const above_px = head.offsetTop - list.offsetTop;
    const is_in_sight =
      above_px >= scroll.scrollTop &&
      above_px + head.offsetHeight <= scroll.scrollTop + scroll.clientHeight;
    if (!is_in_sight) scroll.scrollTop = above_px - scroll.clientHeight / 3;
  }

  function row(action: Action): HTMLElement {
    const { session, settings } = station;
    const { playback } = session;
    const at_ms =
      playback === null ? Date.parse(action.at) : session.start_utc_ms + 1000 * action.time_s;
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
      playback === null
        ? element('span', { class: 'when' }, when)
        : button(when, () => seek(time_of(action, playback)), { class: 'when' }),
      ' ',
      element('strong', {}, action.who || 'the server'),
      ` ${plain(action.what)}${vehicle === '' ? '' : ` ${vehicle}`}${change}`,
    );
    if (playback !== null) {
      made.classList.add('leads');
      made.addEventListener('click', (event) => {
        if (!(event.target instanceof HTMLButtonElement)) seek(time_of(action, playback));
      });
    }
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
