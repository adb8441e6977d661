// The price of a limit: how much of each month of the site's history allows the task, at the limit
// of today and at the changed one.
import { told, type Answer } from '../decide/answer';
import { table_of } from '../decide/table';
import { element, scroll_region } from '../../look/element';
import { is_known } from '../look/units';

export interface Workability {
  first: string;
  last: string;
  source: string;
  by_month: { month: number; workability: number | null }[];
}

/** What a history calls it; null where no history has it. */
const SERIES: Record<string, readonly [string, string]> = {
  significant_wave_height_m: ['sea_surface_wave_significant_height', 'm'],
  wind_speed_m_s: ['wind_speed', 'm/s'],
  wind_speed_10m_m_s: ['wind_speed', 'm/s'],
  gust_speed_m_s: ['wind_speed_of_gust', 'm/s'],
};

export function history_limit(variable: string, value: number): string | null {
  const series = SERIES[variable];
  return series === undefined ? null : `${series[0]}<=${value} ${series[1]}`;
}

export function workability_query(
  limit: string,
  duration_h: number,
  contingency_h: number,
): string {
  const minutes = (hours: number): string => `${Math.round(60 * hours)}min`;
  const query = new URLSearchParams({ limit, duration: minutes(duration_h) });
  if (contingency_h > 0) query.set('contingency', minutes(contingency_h));
  return `/workability?${query.toString()}`;
}

const MONTHS = 'Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec'.split(' ');
const DAYS = [31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];

export function days_text(share: number | null, month: number): string {
  const days = DAYS[month - 1];
  if (!is_known(share) || days === undefined) return '–';
  return `${(share * days).toFixed(1)} days (${Math.round(100 * share)} %)`;
}

export function price_table(
  today: Answer<Workability>,
  changed: Answer<Workability>,
  names: readonly [string, string],
): HTMLElement {
  const rows = today.body.by_month.map(({ month }, i) => {
    const j = changed.body.by_month.findIndex((it) => it.month === month);
    const text = (share: number | null): string => days_text(share, month);
    return [
      MONTHS[month - 1] ?? String(month),
      told(today, `by_month.${i}.workability`, text),
      told(changed, `by_month.${j}.workability`, text),
    ];
  });
  const { first, last } = today.body;
  const table = table_of(['Month', `Now: ${names[0]}`, `Changed: ${names[1]}`], rows);
  return element(
    'div',
    {},
    element(
      'p',
      { class: 'note' },
      `Days a month on whose hours the task can begin by this limit alone, in the site's history ` +
        `from ${first.slice(0, 10)} to ${last.slice(0, 10)}.`,
      months_apart(first, last) < 12
        ? ' That is less than a year: no climate, only an example.'
        : '',
    ),
    scroll_region('Price of the limit', table),
  );
}

function months_apart(first: string, last: string): number {
  return (Date.parse(last) - Date.parse(first)) / (30.4 * 86_400_000);
}
