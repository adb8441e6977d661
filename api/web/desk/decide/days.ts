// The hours that are left today, and the day after beside them, task by task.
import { element } from '../../look/element';
import { told, type Answer } from './answer';
import type { Day, Report, ReportTask, Verdict } from './answers';
import { day_name, hour_on, span_text, type Clock } from './clock';
import { task_cell } from './task_cell';
import { verdict_badge } from './verdict_badge';
import { past_text } from './words';

const VERDICTS: readonly Verdict[] = ['go', 'marginal', 'no-go'];

/** Whether the report's own day, which is told whole, has begun and not ended. */
export function is_today({ from, to }: Day, now_ms: number): boolean {
  return Date.parse(from) <= now_ms && now_ms < Date.parse(to);
}

/** @param why_no_today  what is said where the report has nothing of today */
export function days(answer: Answer<Report>, clock: Clock, why_no_today: string): HTMLElement {
  const report = answer.body;
  const { today } = report;
  const heads = element('div', { class: 'day-heads' });
  if (today !== null) {
    const begin = hour_on(today.from, clock.zone, today.from);
    heads.append(head(answer, 'today.', today, `Today from ${begin}`, clock));
  } else if (!is_today(report, clock.now_ms)) {
    heads.append(
      element(
        'div',
        { class: 'day-head' },
        element('h3', {}, 'Today'),
        element('p', {}, why_no_today),
      ),
    );
  }
  heads.append(head(answer, '', report, title_of(report, clock), clock));
  const list = element('ol', { class: 'tasks' });
  for (const name of names_of(report)) list.append(task_line(answer, name, clock));
  const none =
    list.childElementCount === 0
      ? [element('p', {}, 'The site names no tasks, or none could be worked out.')]
      : [];
  return element(
    'div',
    { class: 'days' },
    heads,
    ...none,
    list,
    ...left_out(report),
    ...report.notes.map((note) => element('p', { class: 'note' }, note)),
  );
}

/** "Fri 14 Mar", by the day that the report is of. */
function title_of(report: Report, { now_ms }: Clock): string {
  const day = day_name(report.day);
  return is_today(report, now_ms) ? `Today, ${day}` : day;
}

function head(
  answer: Answer<Report>,
  key: string,
  day: Day,
  title: string,
  clock: Clock,
): HTMLElement {
  const span = span_text(day.from, day.to, clock);
  return element(
    'div',
    { class: 'day-head' },
    element('h3', {}, title, ' ', verdict_badge(answer, `${key}verdict`, day.verdict)),
    ...(span === '' ? [] : [element('p', { class: 'span' }, span)]),
    element(
      'p',
      { class: 'headline' },
      told(answer, `${key}headline`, (text: string) => text),
    ),
  );
}

/** What can be done first: by the better verdict of the two days, then by the better chance. */
function names_of({ today, tasks }: Report): string[] {
  const all = [...(today?.tasks ?? []), ...tasks];
  const worth = (name: string): number =>
    Math.max(...all.filter(({ task }) => task === name).map(({ best }) => best?.worth ?? -1));
  const rank = (name: string): number =>
    Math.min(
      ...all.filter(({ task }) => task === name).map(({ verdict }) => VERDICTS.indexOf(verdict)),
    );
  const names = [...new Set([...tasks, ...all].map(({ task }) => task))];
  return names.sort((a, b) => rank(a) - rank(b) || worth(b) - worth(a));
}

function task_line(answer: Answer<Report>, name: string, clock: Clock): HTMLElement {
  const report = answer.body;
  const at = (tasks: readonly ReportTask[] | undefined): number =>
    (tasks ?? []).findIndex(({ task }) => task === name);
  const now = at(report.today?.tasks);
  const next = at(report.tasks);
  const task = (report.tasks[next] ?? report.today?.tasks[now]) as ReportTask;
  const cell = (
    title: string,
    day: string,
    key: string,
    of: ReportTask | undefined,
  ): HTMLElement =>
    of === undefined
      ? element('p', { class: 'task-cell note' }, `${title}: nothing is said of it.`)
      : task_cell(title, answer, key, of, clock, day);
  const cells = element('div', { class: 'cells' });
  const { today } = report;
  if (today !== null)
    cells.append(cell('Today', today.from, `today.tasks.${now}`, today.tasks[now]));
  cells.append(cell(title_of(report, clock), report.day, `tasks.${next}`, report.tasks[next]));
  return element(
    'li',
    {},
    element(
      'h4',
      {},
      task.name,
      element('span', { class: 'where' }, ` at ${task.turbines.join(', ')}`),
    ),
    cells,
    element('p', { class: 'past' }, past_text(task.past)),
  );
}

function left_out(report: Report): HTMLElement[] {
  const all = [...report.left_out, ...(report.today?.left_out ?? [])];
  const lines = new Set(all.map(({ task, why }) => `${task} could not be worked out: ${why}`));
  return [...lines].map((line) => element('p', { class: 'left-out' }, line));
}
