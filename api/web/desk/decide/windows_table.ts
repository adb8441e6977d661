// The starts of the tasks as tables, for who reads rather than looks. Made when they are opened.
import { element, scroll_region } from '../../look/element';
import { told, type Answer } from './answer';
import type { Range, Windows, WindowsTask } from './answers';
import { opened, table_of } from './table';
import { hour_on } from './clock';
import { binding_text, chance_nodes, interval_text } from './words';

const yes_no = (allowed: boolean | null): string =>
  allowed === null ? 'no answer' : allowed ? 'yes' : 'no';

export function windows_tables(answer: Answer<Windows>, zone: string): HTMLElement {
  const made = opened('All starts as tables', () =>
    element('div', {}, ...answer.body.tasks.map((task, t) => windows_table(answer, t, task, zone))),
  );
  made.className = 'as-table';
  return made;
}

function windows_table(
  answer: Answer<Windows>,
  t: number,
  task: WindowsTask,
  zone: string,
): HTMLElement {
  const rows = task.starts.map((start, s) => {
    const key = `tasks.${t}.starts.${s}`;
    return [
      hour_on(start.start, zone, answer.body.from),
      element('span', {}, ...chance_nodes(answer, key, start)),
      told(answer, `${key}.interval_95`, (range: Range) => interval_text(range)),
      yes_no(start.threshold),
      yes_no(start.alpha),
      binding_text(start, zone, answer.body.from),
    ];
  });
  const heads = ['Start', 'Chance', '95 % interval', 'Central forecast', 'Alpha', 'What binds'];
  const title = element('h3', {}, task.name);
  return element('div', {}, title, scroll_region(`Starts of ${task.name}`, table_of(heads, rows)));
}
