// The last forecasts held against what came: the error by lead, ours beside its rivals.
import { drawn, element, scroll_region } from '../../look/element';
import type { Look } from '../look/look';
import { told, told_by, type Answer } from './answer';
import type { Score } from './answers';
import { VARIABLES, hourly, lead_days, methods_of, type HourlyLine, type LeadDay } from './scores';
import { table_of } from './table';
import { error_text } from './trust';

const METHOD: Record<string, string> = {
  forecast: 'This forecast',
  provider: "The provider's model",
  persistence: 'The last value kept',
  'same-hour': 'The same hour the day before',
  'day-mean': 'The mean of the day before',
  'tide-harmonic': 'Tide alone (harmonic)',
  'tide-phase': 'Tide alone (by its phase)',
  'reference-slab': 'A slab of water pushed by the wind',
  'oracle-mean': 'The mean of the day itself (known only afterwards: a yardstick)',
};
export const method_text = (method: string): string => METHOD[method] ?? method;

export function yesterday(answer: Answer<Score[]>, look: Look): HTMLElement {
  const node = element('div', { class: 'yesterday' });
  for (const [variable, name] of VARIABLES) {
    const days = lead_days(answer.body, variable);
    if (days.length === 0) continue;
    node.append(
      element('h3', {}, `${name}: root mean square error`),
      scroll_region(`${name}: errors by lead`, lead_table(answer, days, look)),
      element('p', { class: 'note' }, `Held against ${truths(days)}.`),
    );
    const first = days[0];
    if (first !== undefined && first.lead_h[0] === 0) {
      const lines = hourly(answer.body, variable, first.issued);
      if (lines.length > 0) node.append(hourly_chart(answer, lines, first, name, look));
    }
  }
  if (node.childElementCount === 0) {
    node.append(
      element('p', {}, 'Nothing that was forecast lately has truth yet to be held against.'),
    );
  }
  return node;
}

function truths(days: readonly LeadDay[]): string {
  return [...new Set(days.map(({ truth }) => truth))].join(', ');
}

function lead_table(answer: Answer<Score[]>, days: LeadDay[], look: Look): HTMLElement {
  const heads = days.map(
    ({ lead_h, issued }) =>
      `${lead_h[0]} to ${lead_h[1]} h ahead, issued ${look.day(Date.parse(issued))}`,
  );
  const rows = methods_of(days).map((method) => {
    const cells = days.map(({ by_method }) => {
      const found = by_method.get(method);
      if (found === undefined) return 'none';
      const ours = by_method.get('forecast')?.rmse ?? null;
      const text = (rmse: number | null): string => error_text(rmse, found.score.unit, look);
      const shown = told(answer, found.key, text);
      const is_better =
        method !== 'forecast' &&
        (found.rmse ?? Infinity) < (ours ?? 0) &&
        text(found.rmse) !== text(ours);
      return is_better ? element('span', { class: 'better' }, shown, ' (less than ours)') : shown;
    });
    return [method_text(method), ...cells];
  });
  const table = table_of(['Method', ...heads], rows);
  table.querySelector('tbody tr')?.classList.add('ours');
  return table;
}

const WIDTH = 600;
const HEIGHT = 150;
const LEFT = 40;
const BOTTOM = 24;

/** Ours drawn full, the best rivals dashed, each named at its end. */
function hourly_chart(
  answer: Answer<Score[]>,
  lines: HourlyLine[],
  { issued }: LeadDay,
  name: string,
  look: Look,
): HTMLElement {
  const mean = ({ points }: HourlyLine): number =>
    points.reduce((sum, { found }) => sum + (found.rmse ?? 0), 0) / points.length;
  const rivals = lines
    .filter(({ method }) => method !== 'forecast' && method !== 'oracle-mean')
    .sort((a, b) => mean(a) - mean(b))
    .slice(0, 2);
  const shown = [...lines.filter(({ method }) => method === 'forecast'), ...rivals];
  const most = Math.max(
    ...shown.flatMap(({ points }) => points.map(({ found }) => found.rmse ?? 0)),
  );
  const unit = lines[0]?.points[0]?.found.score.unit ?? '';
  const x = (lead_h: number): number => LEFT + ((WIDTH - LEFT - 6) * (lead_h - 0.5)) / 24;
  const y = (rmse: number): number => 8 + (HEIGHT - BOTTOM - 8) * (1 - rmse / (most || 1));
  const svg = drawn('svg', {
    class: 'hourly',
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: 'img',
    'aria-label':
      `${name}: error by hour of lead, forecast issued ${issued}. ` + 'The table above sums it up.',
  });
  svg.append(
    drawn('line', { class: 'base', x1: LEFT, x2: WIDTH, y1: y(0), y2: y(0) }),
    drawn(
      'text',
      { x: LEFT - 4, y: y(most) + 8, 'text-anchor': 'end' },
      number_text(most, unit, look),
    ),
    drawn('text', { x: LEFT - 4, y: y(0), 'text-anchor': 'end' }, '0'),
    ...[1, 6, 12, 18, 24].map((lead) =>
      drawn('text', { x: x(lead), y: HEIGHT - 8, 'text-anchor': 'middle' }, `${lead} h`),
    ),
  );
  shown.forEach(({ method, points }, i) => {
    const path = points
      .map(({ lead_h, found }, p) => `${p === 0 ? 'M' : 'L'}${x(lead_h)},${y(found.rmse ?? 0)}`)
      .join('');
    svg.append(drawn('path', { class: `line line-${i}`, d: path }));
    for (const { lead_h, found } of points) {
      const at = { cx: x(lead_h), cy: y(found.rmse ?? 0), r: method === 'forecast' ? 2.2 : 1.4 };
      svg.append(
        drawn('circle', { class: `point point-${i}`, ...at, ...told_by(answer, found.key) }),
      );
    }
  });
  const keys = shown.map(({ method }, i) =>
    element(
      'span',
      { class: 'key' },
      element('i', { class: `mark line-${i}` }),
      method_text(method),
    ),
  );
  return element(
    'figure',
    {},
    svg,
    element(
      'figcaption',
      {},
      `Error by hour ahead, issued ${look.day(Date.parse(issued))}: `,
      ...keys,
    ),
  );
}

function number_text(value: number, unit: string, look: Look): string {
  return (unit === 'm' ? value : look.speed_number(value)).toFixed(2);
}
