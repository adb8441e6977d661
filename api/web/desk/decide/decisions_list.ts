// Who decided what, and what came.
import { element, scroll_region } from '../../look/element';
import type { Look } from '../look/look';
import { told, type Answer } from './answer';
import type { Decision, Decisions } from './answers';
import { table_of } from './table';
import { VERDICT, chance_text } from './words';

export function came_text({ came, decided }: Decision, look: Look): string {
  const unchecked =
    came.not_checked.length === 0 ? '' : ` (${came.not_checked.length} not checked)`;
  switch (came.outcome) {
    case 'held':
      return (decided === 'go' ? 'held' : 'would have held') + unchecked;
    case 'did_not_hold': {
      const at = came.broken_at === null ? '' : ` at ${look.time(Date.parse(came.broken_at))}`;
      return `did not hold: ${came.broken ?? 'a limit'}${at}${unchecked}`;
    }
    case 'not_known_yet':
      return `not known yet${came.why === null ? '' : `: ${came.why}`}`;
    default:
      return `cannot be known${came.why === null ? '' : `: ${came.why}`}`;
  }
}

export function decisions_list(answer: Answer<Decisions>, site: string, look: Look): HTMLElement {
  const { decisions, record } = answer.body;
  const node = element('div', { class: 'decisions' });
  if (decisions.length === 0) {
    node.append(
      element(
        'p',
        {},
        'No decision is recorded. Record one with: ',
        element(
          'code',
          {},
          `slackwater decide --site ${site} --task TASK --start TIME --go --by NAME`,
        ),
      ),
    );
    return node;
  }
  if (record.text !== null) {
    const text = (said: string): string => `The record: ${said}.`;
    node.append(element('p', {}, told(answer, 'record.text', text)));
  }
  const time = (text: string): string => look.time(Date.parse(text));
  const rows = decisions.map((it, i) => {
    const counts = it.counts ? '' : ' (a later record counts)';
    return [
      element('span', {}, told(answer, `decisions.${i}.start`, time)),
      it.turbine === null ? it.task : `${it.task} at ${it.turbine}`,
      (it.decided === 'go' ? 'Go' : 'No-go') + counts,
      said(answer, i, it),
      element(
        'span',
        {
          class: `came ${it.came.outcome}`,
          'data-key': `decisions.${i}.came.outcome`,
          'data-value': it.came.outcome,
          'data-from': answer.from,
        },
        came_text(it, look),
      ),
      `${it.by}, ${look.time(Date.parse(it.recorded_at))}${it.late ? ', after the start' : ''}`,
      it.note ?? '',
      it.hand_over ?? '',
    ];
  });
  rows.reverse(); // the newest first
  const heads = [
    ...['Start', 'Task', 'Decided', 'The program said', 'What came', 'By', 'Note'],
    'For the next shift',
  ];
  node.append(scroll_region('Recorded decisions', table_of(heads, rows)));
  return node;
}

function said(answer: Answer<Decisions>, i: number, { said: it }: Decision): Node {
  if (it.verdict === null) return element('span', {}, it.why_nothing ?? 'nothing');
  return element(
    'span',
    {},
    `${VERDICT[it.verdict]}, `,
    told(answer, `decisions.${i}.said.probability`, chance_text),
  );
}
