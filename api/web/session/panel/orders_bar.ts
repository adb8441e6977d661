// HOLD, Home and Resume: always there, always in the same place. Beside them the stick, drawn at
// once.
import { button, element, set_disabled, set_text } from '../../look/element';
import { ready_canvas } from '../look/canvas';
import { colours } from '../look/palette';
import { NOTHING_SAID, type Said } from '../look/said';
import { NO_LEAN, type Lean, type Stick } from '../drive/stick';
import { line } from '../view/draw';
import type { Panel, Station } from '../station';

export interface OrdersBar extends Panel {
  hold(): void;
  /** At once, as the hand moves. */
  show_stick(lean: Lean | null, text: string, is_alarm: boolean): void;
  /** What the server made of it. */
  show_taken(text: string, is_alarm: boolean): void;
  /** What it says of the stick, for the headset's board. */
  said(): Said;
}

export function orders_bar(station: Station, stick: Pick<Stick, 'drop'>): OrdersBar {
  const order = (what: string, command: string) => (): void => {
    if (station.chosen === null) return;
    stick.drop();
    station.command(`${what} ${station.chosen_name()}`, { do: command });
  };
  const hold_now = order('HOLD', 'hold');
  const hold = button('HOLD', hold_now, { class: 'hold' });
  const home = button('Home', order('Home', 'home'));
  const resume = button('Resume', order('Resume', 'resume'));
  const target = element('p', { class: 'target' });
  const why = element('p', { class: 'note' });
  const canvas = element('canvas', { class: 'stick-view', 'aria-hidden': 'true' });
  const asked = element('p', { class: 'asked' });
  const taken = element('p', { class: 'taken' });
  let said: Said = NOTHING_SAID;
  const box = element(
    'div',
    { class: 'orders-row' },
    element('div', { class: 'orders-buttons' }, hold, home, resume),
    element('div', { class: 'orders-target' }, target, why),
    canvas,
    element('div', { class: 'stick-words' }, asked, taken),
  );

  return {
    box,
    hold: hold_now,
    show: () => {
      const { session, chosen } = station;
      const mine = station.has_helm();
      set_disabled(hold, !station.may_hold());
      set_disabled(home, !station.may_direct());
      set_disabled(resume, !station.may_direct());
      set_text(target, chosen === null ? 'No vehicle is chosen' : `For ${station.chosen_name()}`);
      set_text(
        why,
        mine
          ? 'You have the helm.'
          : session.role === 'spectator'
            ? 'Spectators look on.'
            : station.is_supervisor()
              ? station.may_direct()
                ? 'Nobody drives it: you may.'
                : 'HOLD always works.'
              : 'Ask for the helm first.',
      );
    },
    show_stick: (lean, text, is_alarm) => {
      draw_stick(canvas, lean ?? NO_LEAN, lean !== null);
      said = { text, is_alarm };
      set_text(asked, text);
      asked.classList.toggle('alarm', is_alarm);
    },
    said: () => said,
    show_taken: (text, is_alarm) => {
      set_text(taken, text);
      taken.classList.toggle('alarm', is_alarm);
    },
  };
}

function draw_stick(canvas: HTMLCanvasElement, lean: Lean, is_driving: boolean): void {
  const ready = ready_canvas(canvas);
  if (ready === null) return;
  const { context, width, height } = ready;
  const c = colours();
  const radius = Math.min(height / 2, width / 4) - 4;
  const pair = [
    { x: width / 4, right: lean.yaw, up: lean.surge },
    { x: (3 * width) / 4, right: lean.sway, up: -lean.heave },
  ];
  for (const stick of pair) {
    const y = height / 2;
    context.strokeStyle = is_driving ? c.accent : c.rule;
    context.lineWidth = 1.5;
    context.strokeRect(stick.x - radius, y - radius, 2 * radius, 2 * radius);
    line(
      context,
      [
        { x: stick.x - radius, y },
        { x: stick.x + radius, y },
      ],
      c.rule,
      1,
    );
    line(
      context,
      [
        { x: stick.x, y: y - radius },
        { x: stick.x, y: y + radius },
      ],
      c.rule,
      1,
    );
    context.fillStyle = is_driving ? c.accent : c.quiet;
    context.beginPath();
    context.arc(stick.x + stick.right * radius, y - stick.up * radius, 5, 0, 2 * Math.PI);
    context.fill();
  }
}
