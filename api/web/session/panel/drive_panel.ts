// How the stick acts: its reach, what is kept, the touch sticks, and raw thrusters behind a
// question.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import { keep_settings } from '../look/settings';
import { percent_text, speed_text } from '../look/units';
import { touch_stick } from '../drive/touch_stick';
import { NO_LEAN, type Lean, type Stick } from '../drive/stick';
import { stick_speed_m_s } from '../drive/shaped';
import type { Panel, Station } from '../station';

export interface DrivePanel extends Panel {
  readonly touch_box: HTMLElement;
  touch_is_held(): boolean;
  touch_lean(): Lean;
  /** The thrusters' shares when raw is on; null: the stick. */
  shares(): number[] | null;
  zero_shares(): void;
  let_go(): void;
  show_pad(is_there: boolean): void;
}

export function drive_panel(station: Station, stick: Stick): DrivePanel {
  const { settings } = station;
  const toggle = (
    text: string,
    on_change: (is_on: boolean) => void,
  ): { box: HTMLElement; field: HTMLInputElement } => {
    const field = element('input', { type: 'checkbox' });
    field.addEventListener('change', () => on_change(field.checked));
    return { box: element('label', { class: 'check' }, field, text), field };
  };
  const keep_depth = toggle('Keep the depth (no heave)', (is_on) => (stick.keep_depth = is_on));
  const keep_heading = toggle('Keep the heading (no yaw)', (is_on) => (stick.keep_heading = is_on));
  const keep_place = button('Keep this place', () => {
    stick.drop();
    station.command(`Keep the place of ${station.chosen_name()}`, { do: 'hold' });
  });
  const reach = element('select');
  for (const share of [0.1, 0.25, 0.5, 0.75, 1])
    reach.append(element('option', { value: share }, ''));
  reach.value = String(settings.stick_share);
  reach.addEventListener('change', () => {
    settings.stick_share = Number(reach.value);
    keep_settings(settings);
  });
  const pad = element('p', { class: 'note' }, 'No gamepad.');

  // Touch sticks: in the fixed bar, above the orders, so that plan and sticks are seen together.
  const left = touch_stick('Left stick', 'turn', 'ahead and back');
  const right = touch_stick('Right stick', 'sideways', 'up and down');
  const touch_box = element('div', { class: 'touch-sticks' }, left.box, right.box);
  const show_touch = button('Touch sticks', () => set_touch(touch_box.hidden), {
    'aria-expanded': 'false',
  });
  const set_touch = (is_on: boolean): void => {
    set_hidden(touch_box, !is_on);
    show_touch.setAttribute('aria-expanded', String(is_on));
    left.let_go();
    right.let_go();
  };
  set_touch(false);
  let had_helm = false;

  // Raw thrusters.
  let raw_is_held = false;
  const sliders = element('div', { class: 'sliders' });
  const inputs: HTMLInputElement[] = [];
  let sliders_of: number | null = null;
  const hold_to_drive = element(
    'button',
    { type: 'button', 'data-drives': true, class: 'strong' },
    'Press and keep pressed to drive',
  );
  const raw_up = (): void => {
    raw_is_held = false;
  };
  hold_to_drive.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    raw_is_held = true;
    hold_to_drive.setPointerCapture(event.pointerId);
  });
  for (const over of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur'] as const)
    hold_to_drive.addEventListener(over, raw_up);
  const raw_off = button('Back to the stick', () =>
    station.ask('Raw thrusters off', { do: 'raw', vehicle: station.chosen, is_on: false }),
  );
  const raw_box = element(
    'div',
    { class: 'raw' },
    element('h3', {}, 'Raw thrusters'),
    element(
      'p',
      { class: 'note' },
      'Move the sliders and hold Space, a shoulder button, or the button below. ' +
        'Let go: all go to zero.',
    ),
    sliders,
    element('div', { class: 'buttons' }, hold_to_drive, raw_off),
  );
  const dialog = element('dialog', { 'aria-labelledby': 'raw-title' });
  const raw_on = button('Raw thrusters', () => {
    set_text(
      dialog_text,
      `Nothing slows ${station.chosen_name()} or keeps it off structures and inside its fence. ` +
        'It ends with the helm.',
    );
    dialog.showModal();
  });
  const dialog_text = element('p');
  dialog.append(
    element('h2', { id: 'raw-title' }, 'Drive the thrusters themselves?'),
    dialog_text,
    element(
      'div',
      { class: 'buttons' },
      button(
        'Drive raw thrusters',
        () => {
          dialog.close();
          station.ask('Raw thrusters', { do: 'raw', vehicle: station.chosen, is_on: true });
        },
        { class: 'strong' },
      ),
      button('Stay with the stick', () => dialog.close(), { autofocus: true }),
    ),
  );

  const box = element(
    'section',
    { class: 'drive' },
    element('h2', {}, 'Drive'),
    element(
      'p',
      { class: 'note' },
      'Hold Space and use W S ahead and back, A D turn, Q E sideways, R F up and down. ' +
        'Let Space go: the stick is zero. H is HOLD.',
    ),
    element(
      'div',
      { class: 'pair' },
      labelled('Full stick is', reach),
      element('div', { class: 'field' }, show_touch),
    ),
    keep_depth.box,
    keep_heading.box,
    element('div', { class: 'buttons' }, keep_place, raw_on),
    pad,
    raw_box,
    dialog,
  );

  const build_sliders = (vehicle: number, names: readonly string[]): void => {
    sliders_of = vehicle;
    inputs.length = 0;
    sliders.replaceChildren();
    names.forEach((name) => {
      const input = element('input', { type: 'range', min: -1, max: 1, step: 0.05, value: 0 });
      inputs.push(input);
      sliders.append(labelled(name, input));
    });
  };
  const zero_shares = (): void => {
    for (const input of inputs) input.value = '0';
  };

  return {
    box,
    touch_box,
    touch_is_held: () => left.is_held() || right.is_held() || raw_is_held,
    touch_lean: () =>
      raw_is_held
        ? NO_LEAN
        : {
            surge: left.lean().up,
            yaw: left.lean().right,
            sway: right.lean().right,
            heave: 0 - right.lean().up,
          },
    shares: () => (raw_box.hidden ? null : inputs.map((it) => Number(it.value))),
    zero_shares,
    let_go: () => {
      left.let_go();
      right.let_go();
      raw_is_held = false;
    },
    show_pad: (is_there) =>
      set_text(pad, is_there ? 'Gamepad: hold a shoulder button to drive.' : 'No gamepad.'),
    show: () => {
      const { session, chosen } = station;
      const vehicle = chosen === null ? undefined : session.vehicles.get(chosen);
      const helm = chosen === null ? undefined : session.helms.get(chosen);
      const mine = station.has_helm();
      set_hidden(box, session.role === 'spectator');
      const most = stick_speed_m_s(vehicle);
      for (const option of reach.options) {
        const share = Number(option.value);
        set_text(
          option,
          `${percent_text(share)}, ${speed_text(share * most, settings.speed_unit, 2)}`,
        );
      }
      const is_raw = mine && helm?.is_raw === true;
      set_hidden(raw_box, !is_raw);
      if (is_raw && vehicle !== undefined && sliders_of !== vehicle.vehicle) {
        const names = Array.from(
          { length: vehicle.thrusters },
          (_, i) => vehicle.thruster_names[i] ?? String(i + 1),
        ).map((name) => (/^\d*$/.test(name) ? `Thruster ${name}` : name));
        build_sliders(vehicle.vehicle, names);
      }
      if (!is_raw) zero_shares();
      set_disabled(raw_on, !mine || is_raw || (vehicle?.thrusters ?? 0) === 0);
      set_disabled(keep_place, !mine);
      if (!mine && dialog.open) dialog.close();
      if (mine && !had_helm && matchMedia('(pointer: coarse)').matches) set_touch(true);
      if (session.role === 'spectator') set_hidden(touch_box, true);
      had_helm = mine;
    },
  };
}
