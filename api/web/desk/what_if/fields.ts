// What can be changed, as fields. Each change is told at once; nothing is sent from here.
import { button, element, labelled } from '../../look/element';
import type { Draft } from './draft';
import { limit_words, limits_of, type Limit } from './limits';

export interface FieldsOf {
  draft: Draft;
  original: Draft;
  task: string;
  tasks: readonly { id: string; name: string }[];
  on_map: HTMLElement;
  choose_task(id: string): void;
  /** @param limit  where it is one that was changed */
  changed(limit?: Limit): void;
}

function option(value: string, text = value): HTMLOptionElement {
  return element('option', { value }, text);
}

export function fields(of: FieldsOf): HTMLElement {
  return element(
    'div',
    { class: 'what-if-fields' },
    group('Limits', task_choice(of), limits(of)),
    group('Hours and turbine', hours(of)),
    group('Order', order(of)),
    group('On the map', of.on_map),
  );
}

function group(title: string, ...inside: HTMLElement[]): HTMLElement {
  return element('fieldset', {}, element('legend', {}, title), ...inside);
}

function task_choice({ task, tasks, choose_task }: FieldsOf): HTMLElement {
  const select = element('select', {}, ...tasks.map(({ id, name }) => option(id, name)));
  select.value = task;
  select.addEventListener('change', () => choose_task(select.value));
  return labelled('Task', select);
}

function limits({ draft, original, task, changed }: FieldsOf): HTMLElement {
  const now = limits_of(draft.task(task));
  const before = limits_of(original.task(task));
  if (now.length === 0) {
    return element('p', {}, 'The sheet of this task has no limit that is one number.');
  }
  const list = element('div', { class: 'limit-list' });
  now.forEach((limit, i) => {
    const { name, unit } = limit_words(limit.variable);
    const input = element('input', { type: 'number', step: 'any', value: limit.value });
    const was = before[i]?.value;
    input.addEventListener('input', () => {
      const value = input.valueAsNumber;
      input.setAttribute('aria-invalid', String(!Number.isFinite(value)));
      if (!Number.isFinite(value)) return;
      draft.set_limit(task, limit.path, value);
      changed({ ...limit, value });
    });
    const phases = limit.phases.length === 0 ? '' : `, while: ${limit.phases.join(', ')}`;
    list.append(
      labelled(
        `${name}${unit === '' ? '' : ` (${unit})`}`,
        input,
        `${limit.role}${phases}; now ${was ?? 'none'}`,
      ),
    );
  });
  return list;
}

function hours({ draft, changed }: FieldsOf): HTMLElement {
  const turbine = element(
    'select',
    {},
    option('', 'As the site says'),
    ...draft.turbines.map(({ id }) => option(id)),
  );
  turbine.value = draft.asked.turbine;
  turbine.addEventListener('change', () => {
    draft.asked.turbine = turbine.value;
    changed();
  });
  const made = element(
    'div',
    { class: 'limit-list' },
    shift_field('Shift of the site (06:00-18:00)', draft.shift, (text) => {
      draft.shift = text;
      changed();
    }),
    ...draft.crews.map(({ id, shift }, i) =>
      shift_field(`Shift of team ${id}`, shift, (text) => {
        draft.set_crew_shift(i, text);
        changed();
      }),
    ),
    labelled('Turbine', turbine),
    moment('First start (UTC)', 'from'),
    moment('Starts before (UTC)', 'to'),
  );
  function moment(text: string, key: 'from' | 'to'): HTMLElement {
    const input = element('input', { type: 'datetime-local', step: 1800 });
    input.value = draft.asked[key].slice(0, 16);
    input.addEventListener('change', () => {
      draft.asked[key] = input.value === '' ? '' : `${input.value.slice(0, 16)}:00Z`;
      changed();
    });
    return labelled(text, input);
  }
  return made;
}

const SHIFT = /^([01]?\d|2[0-4]):[0-5]\d-([01]?\d|2[0-4]):[0-5]\d$/;

function shift_field(text: string, value: string, set: (hours: string) => void): HTMLElement {
  const input = element('input', { type: 'text', value, placeholder: 'any hour' });
  input.addEventListener('input', () => {
    const hours = input.value.trim();
    const is_sound = SHIFT.test(hours);
    input.setAttribute('aria-invalid', String(!is_sound));
    if (is_sound) set(hours);
  });
  return labelled(text, input);
}

/** The plan's tasks by priority; without a plan the site's own order. */
function order({ draft, changed }: FieldsOf): HTMLElement {
  const list = element('ol', { class: 'order-list' });
  const has_plan = draft.plan_tasks.length > 0;
  const draw = (): void => {
    const rows = has_plan
      ? draft.plan_tasks.map(
          (it) => `${it.task} at ${it.turbines.join(', ')}, priority ${it.priority}`,
        )
      : draft.site_tasks;
    list.replaceChildren(
      ...rows.map((text, i) => {
        const up = button('Up', () => {
          if (has_plan) draft.move_up(i);
          else draft.move_site_task_up(i);
          draw();
          list.querySelectorAll('button')[Math.max(0, i - 1)]?.focus();
          changed();
        });
        up.setAttribute('aria-label', `Move up: ${text}`);
        up.disabled = i === 0;
        return element('li', {}, up, text);
      }),
    );
  };
  draw();
  const note = has_plan
    ? 'What stands higher has the higher priority in the plan.'
    : 'There is no plan: the order is only that of the list.';
  return element('div', {}, element('p', { class: 'note' }, note), list);
}
