// The answer of the what-if beside the true one.
import { told, type Answer } from '../decide/answer';
import type { Plan, Windows } from '../decide/answers';
import { plan_gantt } from '../decide/plan_gantt';
import { opened, table_of } from '../decide/table';
import { verdict_badge } from '../decide/verdict_badge';
import { windows_gantt } from '../decide/windows_gantt';
import { chance_nodes } from '../decide/words';
import { element, scroll_region } from '../../look/element';
import type { Look } from '../look/look';
import { change_text, plan_changes, task_changes, type TaskAnswer } from './compare';

/** What the server answers to a what-if. */
export interface WhatIf {
  windows: Windows;
  plan: Plan | null;
  no_plan: string | null;
}

/** @param touched  the only tasks that were asked about; null: all */
export function result(
  truth: Answer<Windows>,
  true_plan: Answer<Plan> | null,
  answer: Answer<WhatIf>,
  touched: string[] | null,
  look: Look,
  show_hour: (at_ms: number) => void,
): HTMLElement {
  const { windows } = answer.body;
  const hour = (time: string): string => look.hour(Date.parse(time));
  const from = look.time(Date.parse(windows.from));
  const to = look.time(Date.parse(windows.to));
  const hours = `Starts from ${from} to ${to} ${look.zone_name}.`;
  return element(
    'div',
    { class: 'what-if-result' },
    touched === null
      ? element(
          'p',
          {},
          'All tasks: now ',
          verdict_badge(truth, 'verdict', truth.body.verdict),
          ', in the what-if ',
          verdict_badge(answer, 'windows.verdict', windows.verdict),
          `. ${hours}`,
        )
      : element('p', {}, `The other tasks are not touched by this. ${hours}`),
    scroll_region('What changes, by task', tasks_table(truth, answer, touched, hour)),
    ...windows.left_out.map(({ task, why }) =>
      element('p', { class: 'refused' }, `${task} could not be worked out: ${why}`),
    ),
    opened('The starts of the what-if', () => {
      const inside: Answer<Windows> = { from: `${answer.from}#windows`, body: windows };
      return element(
        'div',
        { class: 'decide-part' },
        windows_gantt(inside, look.zone, show_hour).node,
      );
    }),
    ...plan_parts(true_plan, answer, look),
  );
}

function tasks_table(
  truth: Answer<Windows>,
  answer: Answer<WhatIf>,
  touched: string[] | null,
  hour: (time: string) => string,
): HTMLElement {
  const cell = (of: Answer<unknown>, key: string, said: TaskAnswer | null): Node | string => {
    if (said === null) return '–';
    const at = `${key}tasks.${said.index}`;
    const badge = verdict_badge(of, `${at}.verdict`, said.verdict);
    if (said.best === null) return element('span', {}, badge, ' no start');
    const start = `${at}.starts.${said.best.index}`;
    const chance = chance_nodes(of, start, said.best.start);
    return element('span', {}, badge, ' ', ...chance, ' at ', told(of, `${start}.start`, hour));
  };
  const rows = task_changes(truth.body, answer.body.windows)
    .filter(({ task }) => touched === null || touched.includes(task))
    .map((change) => [
      change.name,
      cell(truth, '', change.before),
      cell(answer, 'windows.', change.after),
      change_text(change, hour),
    ]);
  const table = table_of(['Task', 'Now', 'What if', 'Change'], rows);
  for (const row of table.querySelectorAll('tbody tr')) {
    row.classList.toggle('changed', row.lastElementChild?.textContent !== 'the same');
  }
  return table;
}

function plan_parts(truth: Answer<Plan> | null, answer: Answer<WhatIf>, look: Look): HTMLElement[] {
  const { plan, no_plan } = answer.body;
  const head = element('h3', {}, 'The plan');
  if (plan === null) return [head, element('p', {}, `No plan: ${no_plan ?? 'the site has none.'}`)];
  const value = (of: number): string => of.toFixed(2);
  const worth = element('p', {}, 'Worth ', told(answer, 'plan.value', value));
  const inside: Answer<unknown> = answer;
  const drawing = opened('The plan of the what-if', () =>
    element('div', { class: 'decide-part' }, plan_gantt(inside, 'plan.', plan, look.zone).node),
  );
  if (truth === null) return [head, worth, drawing];
  worth.append('; now ', told(truth, 'value', value), ' (priority x chance, summed).');
  const hour = (time: string | null): string =>
    time === null ? 'not planned' : look.time(Date.parse(time));
  const rows = plan_changes(truth.body, plan).map(({ job, change, before, after }) => [
    job,
    hour(before),
    hour(after),
    change,
  ]);
  if (rows.length === 0) return [head, worth, element('p', {}, 'Neither plans a job.'), drawing];
  const table = table_of(['Job', 'Now', 'What if', 'Change'], rows);
  return [head, worth, scroll_region('What changes, by job', table), drawing];
}
