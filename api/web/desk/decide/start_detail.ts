// All that is known of one start, in words.
import { button, element } from '../../look/element';
import { told, told_by, type Answer } from './answer';
import type { Range, Windows, WindowsTask } from './answers';
import { hour_on } from './clock';
import { allowed_text, binding_text, chance_text, interval_text } from './words';

type Line = readonly [string, Node | string];

export function start_detail(
  answer: Answer<Windows>,
  t: number,
  s: number,
  zone: string,
  show_hour: (at_ms: number) => void,
): HTMLElement {
  const task = answer.body.tasks[t] as WindowsTask;
  const start = task.starts[s];
  if (start === undefined) return element('div');
  const key = `tasks.${t}.starts.${s}`;
  const at_ms = Date.parse(start.start);
  const of_futures = element(
    'span',
    {},
    told(answer, `${key}.futures_held`, String),
    ' of ',
    told(answer, `${key}.futures`, String),
    ' futures keep all limits',
  );
  const lines: Line[] = [
    [
      'Chance',
      element(
        'span',
        {},
        told(answer, `${key}.probability`, chance_text),
        ' (95 % interval ',
        told(answer, `${key}.interval_95`, (range: Range) => interval_text(range)),
        '); ',
        of_futures,
      ),
    ],
  ];
  if (start.twin !== null) {
    lines.push([
      'Flown',
      `${chance_text(start.twin.probability)} of ${start.twin.flights} flights succeed` +
        (start.twin.stopped_by ? `; stopped by: ${start.twin.stopped_by}` : ''),
    ]);
  }
  if (start.worth < start.probability) {
    lines.push(['Counts as', told(answer, `${key}.worth`, chance_text)]);
  }
  lines.push([
    !start.binding?.exceeded
      ? 'Nearest to its limit'
      : start.worth >= answer.body.rules.marginal
        ? 'Main limit'
        : 'What stops it',
    element(
      'span',
      told_by(answer, `${key}.binding.limit`),
      binding_text(start, zone, answer.body.from),
    ),
  ]);
  lines.push(['The central forecast alone', allowed_text(start.threshold, null)]);
  lines.push(['The usual safety margins', allowed_text(start.alpha, task.no_alpha)]);
  if (start.unforecast !== null) lines.push(['Nobody forecast', start.unforecast]);
  if (task.assumed.length > 0) lines.push(['Assumed', task.assumed.join('; ')]);
  const unchecked = task.not_checked.length > 0 ? task.not_checked.join('; ') : 'nothing';
  lines.push(['Not checked', unchecked]);
  const list = element('dl', {});
  for (const [name, text] of lines) {
    list.append(element('dt', {}, name), element('dd', {}, text));
  }
  const hour = hour_on(start.start, zone, answer.body.from);
  return element(
    'div',
    { class: 'start-detail' },
    element('h4', {}, `Start ${hour}, ${task.name}`),
    list,
    button(`Set the page to ${hour}`, () => show_hour(at_ms)),
  );
}
