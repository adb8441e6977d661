// What only a supervisor does: the run, and vehicles that join it.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import type { Plane } from '../view/camera';
import type { Panel, Station } from '../station';

export interface SupervisePanel extends Panel {
  /** True: the click on the plan was awaited here. */
  click(at: Plane): boolean;
}

export function supervise_panel(station: Station): SupervisePanel {
  const pause = button('Pause', () => station.ask('Pause', { do: 'pause' }));
  const go_on = button('Go on', () => station.ask('Go on', { do: 'go_on' }));
  const steps = element('input', {
    type: 'number',
    min: 1,
    max: 100000,
    step: 1,
    value: 10,
    'aria-label': 'Steps',
  });
  const step = button('Step', () =>
    station.ask('Step', { do: 'step', steps: Math.max(1, Math.round(Number(steps.value) || 1)) }),
  );

  const models = element('datalist', { id: 'models' });
  const model = element('input', { type: 'text', list: 'models', required: true, maxlength: 80 });
  const name = element('input', { type: 'text', required: true, maxlength: 60 });
  const number = (value: number, step_size = 0.1): HTMLInputElement =>
    element('input', { type: 'number', step: step_size, value, required: true });
  const east = number(0);
  const north = number(0);
  const up = number(-5);
  const heading = number(0, 1);
  let awaits_click = false;
  const pick = button(
    'Pick on the plan',
    () => {
      awaits_click = !awaits_click;
      pick.setAttribute('aria-pressed', String(awaits_click));
    },
    { 'aria-pressed': 'false' },
  );
  const form = element(
    'form',
    { class: 'inline' },
    element('div', { class: 'pair' }, labelled('Model', model), labelled('Name', name)),
    element('div', { class: 'pair' }, labelled('East, m', east), labelled('North, m', north)),
    element(
      'div',
      { class: 'pair' },
      labelled('Up, m (deep: below 0)', up),
      labelled('Heading, degrees', heading),
    ),
    models,
    element(
      'div',
      { class: 'buttons' },
      pick,
      element('button', { type: 'submit', class: 'strong' }, 'Let it join'),
    ),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    station.ask(`${name.value} joins`, {
      do: 'spawn',
      model: model.value.trim(),
      name: name.value.trim(),
      east_m: Number(east.value),
      north_m: Number(north.value),
      up_m: Number(up.value),
      heading_deg: Number(heading.value),
    });
  });
  const details = element('details', {}, element('summary', {}, 'Let a vehicle join'), form);
  const box = element(
    'section',
    { class: 'supervise' },
    element('h2', {}, 'Run'),
    element('div', { class: 'buttons' }, pause, go_on, step, steps),
    details,
  );
  let listed = '';

  return {
    box,
    click: (at) => {
      if (!awaits_click) return false;
      awaits_click = false;
      pick.setAttribute('aria-pressed', 'false');
      east.value = at.east_m.toFixed(1);
      north.value = at.north_m.toFixed(1);
      return true;
    },
    show: () => {
      const { session } = station;
      set_hidden(box, !station.is_supervisor());
      const { state } = session.run;
      set_disabled(pause, state === 'paused' || state === 'over');
      set_disabled(go_on, state !== 'paused');
      set_disabled(step, state !== 'paused');
      set_text(pick, awaits_click ? 'Click on the plan now' : 'Pick on the plan');
      const known = [...new Set([...session.vehicles.values()].map((it) => it.model))].filter(
        (it) => it !== '',
      );
      if (known.join() !== listed) {
        listed = known.join();
        models.replaceChildren(...known.map((it) => element('option', { value: it })));
      }
    },
  };
}
