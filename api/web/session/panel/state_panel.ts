// The chosen vehicle: what it does and why, how much is left, how near its limits it is.
import { button, element, set_hidden, set_text } from '../../look/element';
import { zone_of } from '../look/settings';
import {
  degrees_text,
  heading_text,
  level_text,
  metres_text,
  percent_text,
  span_text,
  speed_text,
  time_text,
} from '../look/units';
import { stick_speed_m_s } from '../drive/shaped';
import { draw_attitude } from '../view/attitude_view';
import type { Panel, Station } from '../station';
import { bar, type Bar } from './bar';

const LINES = [
  'Doing',
  'Driven by',
  'Because',
  'Phase',
  'Task',
  'Halted',
  'Level',
  'Above the bed',
  'Course',
  'Roll, pitch',
  'Flow',
  'Reserve',
  'Spare',
  'Home by',
  'Traffic',
] as const;
type Line = (typeof LINES)[number];

/** A button for each alarm of the vehicle that nobody has acknowledged. */
function acknowledge_buttons(station: Station): {
  box: HTMLElement;
  show(chosen: number | null): void;
} {
  const box = element('div', { class: 'buttons' });
  let shown = '';
  return {
    box,
    show: (chosen) => {
      const { session } = station;
      const may = session.role !== 'spectator' && session.playback === null;
      const open = [...session.alarms.values()].filter(
        (it) => may && it.vehicle === chosen && it.mmsi !== null && it.acknowledged_by === '',
      );
      const key = JSON.stringify(open.map((it) => [it.vehicle, it.mmsi, it.with]));
      if (key === shown) return;
      shown = key;
      box.replaceChildren(
        ...open.map(({ vehicle, mmsi, with: vessel }) =>
          button(`Acknowledge ${vessel}`, () => {
            station.ask('Acknowledge', { do: 'acknowledge', vehicle, mmsi });
          }),
        ),
      );
      set_hidden(box, open.length === 0);
    },
  };
}

export function state_panel(station: Station): Panel {
  const list = element('dl', { class: 'facts' });
  const lines = new Map<Line, { term: HTMLElement; value: HTMLElement }>();
  for (const name of LINES) {
    const term = element('dt', {}, name);
    const value = element('dd');
    if (name === 'Halted' || name === 'Traffic') value.className = 'alarm';
    list.append(term, value);
    lines.set(name, { term, value });
  }
  const acknowledge = acknowledge_buttons(station);
  const attitude = element('canvas', { class: 'attitude', 'aria-hidden': 'true' });
  const bars = element('div', { class: 'bars' });
  const fixed = {
    charge: bar('Charge'),
    speed: bar('Speed'),
    fence: bar('From home'),
    tether: bar('Tether'),
  };
  bars.append(fixed.charge.box, fixed.speed.box, fixed.fence.box, fixed.tether.box);
  const limits = new Map<string, Bar>();
  const title = element('h2', {}, 'No vehicle chosen');
  const box = element(
    'section',
    { class: 'state' },
    element('div', { class: 'head' }, title, attitude),
    bars,
    list,
    acknowledge.box,
  );

  const set = (name: Line, text: string): void => {
    const line = lines.get(name);
    if (line === undefined) return;
    set_text(line.value, text);
    set_hidden(line.term, text === '');
    set_hidden(line.value, text === '');
  };

  return {
    box,
    show: () => {
      const { session, settings, chosen } = station;
      const vehicle = chosen === null ? undefined : session.vehicles.get(chosen);
      const pose = chosen === null ? undefined : session.poses.get(chosen);
      const status = chosen === null ? undefined : session.statuses.get(chosen);
      const helm = chosen === null ? undefined : session.helms.get(chosen);
      const model = vehicle?.model ?? '';
      set_text(
        title,
        vehicle === undefined
          ? 'No vehicle chosen'
          : model === '' || model === vehicle.name
            ? vehicle.name
            : `${vehicle.name} (${model})`,
      );
      set('Doing', plain(status?.doing ?? ''));
      set(
        'Driven by',
        helm === undefined || helm.mode === status?.doing
          ? ''
          : (helm.mode === 'own' ? 'its own mission' : plain(helm.mode)) +
              (helm.is_raw ? ', raw thrusters' : ''),
      );
      set('Because', plain(status?.cause || helm?.cause || ''));
      set('Phase', plain(status?.phase ?? ''));
      set('Task', status === undefined ? '' : task_text(status.task, status.tasks));
      set('Halted', status?.halt ? plain(status.halt) : pose?.halted ? 'yes' : '');
      set('Level', pose === undefined ? '' : level_text(pose.up_m));
      set(
        'Above the bed',
        pose === undefined || pose.bed_m === null ? '' : metres_text(pose.bed_m, 1),
      );
      set('Course', pose === undefined ? '' : heading_text(pose.heading_rad));
      set(
        'Roll, pitch',
        pose === undefined ? '' : `${degrees_text(pose.roll_rad)}, ${degrees_text(pose.pitch_rad)}`,
      );
      set(
        'Flow',
        pose === undefined
          ? ''
          : flow_text(pose.current_east_m_s, pose.current_north_m_s, settings.speed_unit),
      );
      const reserve = status?.reserve ?? null;
      set(
        'Reserve',
        reserve === null
          ? ''
          : typeof reserve === 'string'
            ? with_times(reserve)
            : percent_text(reserve),
      );
      set('Spare', status?.margin_s == null ? '' : span_text(status.margin_s));
      set('Home by', home_by_text(status?.home_by ?? null));
      set(
        'Traffic',
        [...session.alarms.values()]
          .filter((it) => it.vehicle === chosen)
          .map(
            (it) =>
              `${it.with}: ${plain(it.level)}` +
              (it.cpa_m === null ? '' : `, passes at ${metres_text(it.cpa_m)}`) +
              (it.cpa_s === null ? '' : ` in ${Math.round(it.cpa_s)} s`) +
              (it.acknowledged_by === '' ? '' : `, acknowledged by ${it.acknowledged_by}`),
          )
          .join('. '),
      );
      acknowledge.show(chosen);
      if (pose !== undefined) draw_attitude(attitude, pose.roll_rad, pose.pitch_rad);

      const charge = pose?.charge ?? null;
      set_hidden(fixed.charge.box, charge === null);
      if (charge !== null) {
        const is_low =
          charge < 0.2 || (typeof reserve === 'number' && reserve <= 1 && charge < reserve);
        fixed.charge.set(charge, percent_text(charge), is_low);
      }
      set_hidden(fixed.speed.box, pose === undefined || vehicle === undefined);
      if (pose !== undefined && vehicle !== undefined) {
        const speed_m_s = Math.hypot(pose.east_m_s, pose.north_m_s, pose.up_m_s);
        const most = vehicle.most_speed_m_s;
        const whole = stick_speed_m_s(vehicle);
        const of_what = most === null ? ', cruises at' : ' of';
        const unit = settings.speed_unit;
        const words = `${speed_text(speed_m_s, unit, 2)}${of_what} ${speed_text(whole, unit)}`;
        fixed.speed.set(speed_m_s / whole, words, most !== null && speed_m_s > 1.05 * most);
      }
      const home = vehicle?.home ?? null;
      const fence_m = vehicle?.fence_m ?? null;
      set_hidden(fixed.fence.box, pose === undefined || home === null || fence_m === null);
      if (pose !== undefined && home !== null && fence_m !== null) {
        const away_m = Math.hypot(pose.east_m - home.east_m, pose.north_m - home.north_m);
        fixed.fence.set(
          away_m / fence_m,
          `${metres_text(away_m)} of ${metres_text(fence_m)}`,
          away_m > 0.9 * fence_m,
        );
      }
      const tether = vehicle?.tether ?? null;
      set_hidden(fixed.tether.box, pose === undefined || tether === null);
      if (pose !== undefined && tether !== null) {
        const away_m = Math.hypot(
          pose.east_m - tether.east_m,
          pose.north_m - tether.north_m,
          pose.up_m - tether.up_m,
        );
        fixed.tether.set(
          away_m / tether.length_m,
          `${metres_text(away_m)} of ${metres_text(tether.length_m)}`,
          away_m > 0.9 * tether.length_m,
        );
      }
      const told = new Set<string>();
      for (const limit of status?.limits ?? []) {
        told.add(limit.name);
        let shown = limits.get(limit.name);
        if (shown === undefined) {
          shown = bar(plain(limit.name));
          limits.set(limit.name, shown);
          bars.append(shown.box);
        }
        shown.set(
          limit.value / limit.limit,
          `${limit.value.toFixed(1)} of ${limit.limit.toFixed(1)} ${limit.unit}`,
          limit.value > limit.limit,
        );
      }
      for (const [name, shown] of limits) set_hidden(shown.box, !told.has(name));
    },
  };

  /** A sentence of the server whose moments are UTC: shown in the zone that was chosen. */
  function with_times(sentence: string): string {
    return sentence.replaceAll(/\d{4}-\d\d-\d\dT[\d:.]+Z/g, (utc) =>
      time_text(Date.parse(utc), zone_of(station.settings)),
    );
  }

  function home_by_text(home_by: number | string | null): string {
    if (home_by === null) return '';
    const zone = zone_of(station.settings);
    if (typeof home_by === 'string') {
      const utc_ms = Date.parse(home_by);
      return Number.isNaN(utc_ms) ? home_by : time_text(utc_ms, zone);
    }
    // A number is of the session's clock: so long from now, on the run's own time.
    const left_ms = home_by - station.clock_ms();
    const run_now_ms = station.session.start_utc_ms + station.session.run.time_s * 1000;
    return Number.isFinite(left_ms + run_now_ms) ? time_text(run_now_ms + left_ms, zone) : '';
  }
}

/** Words of the wire as words of a sentence. */
export function plain(word: string): string {
  return word.replaceAll('_', ' ');
}

/** The server counts tasks from 0; one beyond the last is the end. */
export function task_text(task: string, tasks: string): string {
  if (task === '' || tasks === '') return plain(task);
  const [at, of] = [Number(task), Number(tasks)];
  if (!Number.isInteger(at) || !Number.isInteger(of)) return `${plain(task)} of ${tasks}`;
  if (of === 0) return '';
  return at >= of ? `all ${of} done` : `${at + 1} of ${of}`;
}

function flow_text(
  east_m_s: number,
  north_m_s: number,
  unit: Parameters<typeof speed_text>[1],
): string {
  if (!Number.isFinite(east_m_s + north_m_s)) return 'not known here';
  const speed_m_s = Math.hypot(east_m_s, north_m_s);
  const towards = heading_text(Math.atan2(east_m_s, north_m_s));
  return `${speed_text(speed_m_s, unit, 2)} towards ${towards}`;
}
