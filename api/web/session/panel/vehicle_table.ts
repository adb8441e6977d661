// All vehicles as a table: the words for what the plan draws, and the place to choose one.
import { button, element, set_text } from '../../look/element';
import { driving_region } from '../look/region';
import { heading_text, level_text, percent_text, speed_text } from '../look/units';
import { holder_name } from '../session/state';
import type { Panel, Station } from '../station';

interface Row {
  row: HTMLTableRowElement;
  choose: HTMLButtonElement;
  helm: HTMLElement;
  cells: HTMLTableCellElement[];
}

export function vehicle_table(station: Station, choose: (vehicle: number) => void): Panel {
  const body = element('tbody');
  const heads = ['Vehicle, helm', 'Level', 'Course', 'Speed', 'Charge'];
  const table = element(
    'table',
    {},
    element('caption', { class: 'unseen' }, 'The vehicles on the plan'),
    element(
      'thead',
      {},
      element('tr', {}, ...heads.map((it) => element('th', { scope: 'col' }, it))),
    ),
    body,
  );
  const scroll = driving_region('Vehicles, table', table);
  const box = element('section', { class: 'vehicles' }, element('h2', {}, 'Vehicles'), scroll);
  const rows = new Map<number, Row>();

  const row_of = (vehicle: number): Row => {
    const known = rows.get(vehicle);
    if (known !== undefined) return known;
    const press = button('', () => choose(vehicle), { class: 'choose', 'aria-pressed': 'false' });
    const cells = heads.slice(1).map(() => element('td'));
    const helm = element('span', { class: 'note' });
    const row = element('tr', {}, element('th', { scope: 'row' }, press, helm), ...cells);
    body.append(row);
    const made = { row, choose: press, helm, cells };
    rows.set(vehicle, made);
    return made;
  };

  return {
    box,
    show: () => {
      const { session, settings } = station;
      for (const [vehicle, { row }] of rows) {
        if (session.vehicles.has(vehicle)) continue;
        row.remove();
        rows.delete(vehicle);
      }
      for (const vehicle of session.vehicles.values()) {
        const { row, choose: press, helm: helm_note, cells } = row_of(vehicle.vehicle);
        const pose = session.poses.get(vehicle.vehicle);
        const helm = session.helms.get(vehicle.vehicle);
        const is_chosen = vehicle.vehicle === station.chosen;
        set_text(press, vehicle.name);
        press.setAttribute('aria-pressed', String(is_chosen));
        row.classList.toggle('chosen', is_chosen);
        const alarms = [...session.alarms.values()].some((it) => it.vehicle === vehicle.vehicle);
        const helm_words =
          helm === undefined || helm.state === 'free'
            ? 'free'
            : helm.holder === session.seat
              ? 'you'
              : holder_name(session, helm.holder) + (helm.state === 'lost' ? ', link down' : '');
        const words =
          pose === undefined
            ? ['–', '–', '–', '–']
            : [
                level_text(pose.up_m),
                heading_text(pose.heading_rad),
                speed_text(
                  Math.hypot(pose.east_m_s, pose.north_m_s, pose.up_m_s),
                  settings.speed_unit,
                ),
                percent_text(pose.charge),
              ];
        const is_absent = session.playback !== null && pose === undefined;
        set_text(
          helm_note,
          is_absent
            ? 'not there'
            : helm_words + (pose?.halted ? ', halted' : '') + (alarms ? ', traffic alarm' : ''),
        );
        cells.forEach((cell, i) => set_text(cell, words[i] ?? ''));
      }
    },
  };
}
