// The plan of the day: who does what, when and with what; and what was left, and why.
import { drawn, element, scroll_region } from '../../look/element';
import { day_text, hour_text } from '../look/units';
import { told, told_by, type Answer } from './answer';
import type { Plan } from './answers';
import { Axis } from './axis';
import { clock_above, hour_line, move_hour_line, tick_lines } from './axis_drawing';
import { lanes_of, plan_rows, plan_span, type PlanRow } from './plan_rows';
import { opened, table_of } from './table';
import type { Gantt } from './windows_gantt';
import { chance_text, counted } from './words';

const LANE = 22;

/** @param key where the plan stands in the answer: "plan." in a report, "" in a plan's own */
export function plan_gantt(answer: Answer<unknown>, key: string, plan: Plan, zone: string): Gantt {
  const rows = plan_rows(plan);
  const span = plan_span(rows);
  const node = element('div', { class: 'plan' }, sum(answer, key, plan, zone));
  const hours: SVGLineElement[] = [];
  if (span === null) {
    node.append(element('p', {}, 'Nothing is planned for that day.'));
  } else {
    const axis = new Axis(span.from_ms, span.to_ms);
    node.append(
      element('div', { class: 'plan-row' }, element('span', {}), clock_above(axis, zone)),
    );
    let group = '';
    for (const row of rows) {
      if (row.group !== group) node.append(element('h3', {}, row.group));
      group = row.group;
      const { line, svg } = drawn_row(answer, key, row, axis, zone);
      hours.push(line);
      const name = element('span', { class: 'name' }, row.name);
      node.append(element('div', { class: 'plan-row' }, name, svg));
    }
    node.append(jobs_table(answer, key, plan, zone));
    return {
      node: ending(node, plan),
      at: (at_ms) => hours.forEach((of) => move_hour_line(of, axis, at_ms)),
    };
  }
  return { node: ending(node, plan), at: () => undefined };
}

function drawn_row(
  answer: Answer<unknown>,
  key: string,
  row: PlanRow,
  axis: Axis,
  zone: string,
): { svg: SVGSVGElement; line: SVGLineElement } {
  const lanes = lanes_of(row.bars);
  const height = LANE * (1 + Math.max(0, ...lanes));
  const words = row.bars.map(
    ({ from_ms, to_ms, text }) =>
      `${hour_text(from_ms, zone)} to ${hour_text(to_ms, zone)} ${text}`,
  );
  const svg = drawn('svg', {
    class: 'bars',
    height,
    width: '100%',
    role: 'img',
    'aria-label': `${row.name}: ${words.length === 0 ? 'free all day' : words.join('; ')}`,
  });
  svg.append(...tick_lines(axis, zone, height));
  row.bars.forEach((bar, i) => {
    const box = {
      x: axis.x(bar.from_ms),
      y: (lanes[i] ?? 0) * LANE + 2,
      width: axis.width(bar.to_ms - bar.from_ms),
      height: LANE - 4,
    };
    const hatched: Record<string, string> =
      bar.kind === 'reserve'
        ? { fill: 'url(#desk-hatch)' }
        : bar.kind === 'charge'
          ? { fill: 'url(#desk-dots)' }
          : {};
    const said = bar.kind === 'job' ? told_by(answer, `${key}${bar.key}.start`) : {};
    const inside = drawn('svg', box);
    inside.append(
      drawn('rect', {
        class: `bar ${bar.kind}`,
        width: '100%',
        height: '100%',
        ...hatched,
        ...said,
      }),
      drawn('title', {}, words[i] ?? ''),
    );
    if (bar.kind !== 'reserve')
      inside.append(drawn('text', { class: bar.kind, x: 4, y: 13 }, bar.text));
    svg.append(inside);
  });
  const line = hour_line(height);
  svg.append(line);
  return { svg, line };
}

function sum(answer: Answer<unknown>, key: string, plan: Plan, zone: string): HTMLElement {
  const all = plan.jobs.length + plan.left.length;
  const day = day_text(Date.parse(`${plan.day}T12:00:00Z`), zone);
  return element(
    'p',
    {},
    element('strong', {}, plan.plan),
    `, ${day}: ${plan.jobs.length} of ${counted(all, 'job')} planned, worth `,
    told(answer, `${key}value`, (value: number) => value.toFixed(2)),
    ' (priority x chance, summed). ',
    plan.proven
      ? 'No plan is worth more.'
      : `The search ended early: no plan can be worth more than ${plan.bound.toFixed(2)}.`,
  );
}

function jobs_table(answer: Answer<unknown>, key: string, plan: Plan, zone: string): HTMLElement {
  const hour = (time: string): string => hour_text(Date.parse(time), zone);
  return opened('The plan as a table', () => {
    const rows = plan.jobs.map((job, j) => [
      element('span', {}, told(answer, `${key}jobs.${j}.start`, hour), ` to ${hour(job.end)}`),
      job.job,
      told(answer, `${key}jobs.${j}.probability`, chance_text),
      job.vessel,
      job.crew,
      job.vehicles.join(', '),
      job.packs.map(({ battery, count }) => `${count} x ${battery}`).join(', '),
    ]);
    const heads = ['From and to', 'Job', 'Chance', 'Vessel', 'Team', 'Vehicles', 'Packs'];
    return scroll_region('Jobs of the plan', table_of(heads, rows));
  });
}

function ending(node: HTMLElement, plan: Plan): HTMLElement {
  if (plan.left.length === 0) {
    node.append(element('p', {}, 'Nothing was left out.'));
    return node;
  }
  const lines = plan.left.map(({ job, priority, why }) =>
    element('li', {}, element('strong', {}, job), ` (priority ${priority}): ${why}`),
  );
  node.append(element('h3', {}, 'Left out'), element('ul', { class: 'left' }, ...lines));
  return node;
}
