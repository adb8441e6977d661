// The price of a limit: how much of each month of the site's history allows the task, at the limit
// of today and at the changed one.
import { told, type Answer } from '../decide/answer';
import { table_of } from '../decide/table';
import { element, scroll_region } from '../../look/element';
import { is_known } from '../look/units';
import { Refused } from '../server/server';
import { limit_words, type Limit } from './limits';

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
  current_speed_m_s: ['sea_water_speed', 'm/s'],
};
const CURRENT = 'current_speed_m_s';

/** Where the current of a limit is meant; null for other limits. @param shown_m  on the map */
export function current_depth(limit: Limit, shown_m: number): { m: number; words: string } | null {
  if (limit.variable !== CURRENT) return null;
  return limit.at_depth_m === null
    ? { m: shown_m, words: `The current is that at ${shown_m} m, the depth chosen at the map.` }
    : {
        m: limit.at_depth_m,
        words: `The current is that at ${limit.at_depth_m} m, as the sheet has it.`,
      };
}

export function history_limit(variable: string, value: number): string | null {
  const series = SERIES[variable];
  return series === undefined ? null : `${series[0]}<=${value} ${series[1]}`;
}

export function workability_query(
  limit: string,
  duration_h: number,
  contingency_h: number,
  depth_m: number | null,
): string {
  const minutes = (hours: number): string => `${Math.round(60 * hours)}min`;
  const query = new URLSearchParams({ limit, duration: minutes(duration_h) });
  if (contingency_h > 0) query.set('contingency', minutes(contingency_h));
  if (depth_m !== null) query.set('depth', String(depth_m));
  return `/workability?${query.toString()}`;
}

/** What of a task its price goes by. */
export interface Priced {
  site: string;
  limit: Limit; // as it is changed
  was: number;
  shown_depth_m: number;
  duration_h: number;
  contingency_h: number;
}

/** The price as a table; in its place why there is none, and what to do. */
export async function price_of(
  get: (path: string) => Promise<Answer<Workability>>,
  of: Priced,
): Promise<HTMLElement> {
  const { limit, was } = of;
  const { name, unit } = limit_words(limit.variable);
  const depth = current_depth(limit, of.shown_depth_m);
  const [today, changed] = [was, limit.value].map((value) => history_limit(limit.variable, value));
  if (!today || !changed) {
    return element('p', {}, `No history of a site tells of "${name}": its price is not known.`);
  }
  const asked = (text: string): Promise<Answer<Workability>> =>
    get(workability_query(text, of.duration_h, of.contingency_h, depth?.m ?? null));
  try {
    const [a, b] = await Promise.all([asked(today), asked(changed)]);
    const names = [`${name} ${was} ${unit}`, `${name} ${limit.value} ${unit}`] as const;
    return price_table(a, b, names, depth?.words ?? '');
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    if (![404, 501, 503].includes(problem.status)) {
      return element('p', {}, `The price could not be worked out: ${problem.detail}`);
    }
    return no_history(of.site, name, problem.detail);
  }
}

function no_history(site: string, name: string, why: string): HTMLElement {
  return element(
    'div',
    {},
    element('p', {}, `The site has no history of "${name}": ${why}.`),
    element(
      'p',
      {},
      'To have one, ingest files of the past around the site. The lines that fetch a year: ',
      element('code', {}, `slackwater forecast --site ${site} --print-downloads --history 365d`),
      ', and then ',
      element('code', {}, 'slackwater ingest downloads'),
      '.',
    ),
  );
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
  where: string, // '' where nothing is to be said
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
      where === '' ? '' : ` ${where}`,
    ),
    scroll_region('Price of the limit', table),
  );
}

function months_apart(first: string, last: string): number {
  return (Date.parse(last) - Date.parse(first)) / (30.4 * 86_400_000);
}
