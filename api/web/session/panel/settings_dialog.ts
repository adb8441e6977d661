// How this browser shows things. Nothing of it is sent; opening it drops no helm.
import { button, element, labelled } from '../../look/element';
import { use_palette } from '../look/palette';
import { keep_settings, type Palette, type Settings } from '../look/settings';
import type { SpeedUnit } from '../look/units';

export function settings_dialog(settings: Settings, on_change: () => void): HTMLDialogElement {
  const choice = (
    options: readonly (readonly [string, string])[],
    value: string,
  ): HTMLSelectElement => {
    const made = element(
      'select',
      {},
      ...options.map(([key, text]) => element('option', { value: key }, text)),
    );
    made.value = value;
    return made;
  };
  const palette = choice(
    [
      ['day', 'Day'],
      ['dusk', 'Dusk'],
      ['night', 'Night'],
    ],
    settings.palette,
  );
  const speed = choice(
    [
      ['m/s', 'm/s'],
      ['knots', 'Knots'],
    ],
    settings.speed_unit,
  );
  const zone = choice(
    [
      ['utc', 'UTC'],
      ['site', 'Site time'],
    ],
    settings.zone,
  );
  const offset = element('input', {
    type: 'number',
    min: -14,
    max: 14,
    step: 0.25,
    value: settings.site_offset_hours,
  });
  const check = (text: string, is_on: boolean): { field: HTMLInputElement; box: HTMLElement } => {
    const field = element('input', { type: 'checkbox' });
    field.checked = is_on;
    return { field, box: element('label', { class: 'check' }, field, text) };
  };
  const narrows = check('In a headset: narrow the view while moved', settings.headset_narrows);
  const sits = check('In a headset: I sit', settings.headset_is_seated);
  const change = (): void => {
    settings.headset_narrows = narrows.field.checked;
    settings.headset_is_seated = sits.field.checked;
    settings.palette = palette.value as Palette;
    settings.speed_unit = speed.value as SpeedUnit;
    settings.zone = zone.value === 'site' ? 'site' : 'utc';
    const hours = Number(offset.value);
    if (Number.isFinite(hours) && Math.abs(hours) <= 14) settings.site_offset_hours = hours;
    keep_settings(settings);
    use_palette(settings.palette);
    on_change();
  };
  for (const field of [palette, speed, zone, offset, narrows.field, sits.field])
    field.addEventListener('change', change);
  const dialog = element('dialog', { 'aria-labelledby': 'settings-title' });
  dialog.append(
    element('h2', { id: 'settings-title' }, 'Settings'),
    labelled('Colours', palette),
    labelled('Speed in', speed),
    labelled('Times in', zone),
    labelled('Site time is ahead of UTC by, hours', offset),
    narrows.box,
    sits.box,
    element(
      'div',
      { class: 'buttons' },
      button('Close', () => dialog.close(), { class: 'strong' }),
    ),
  );
  return dialog;
}
