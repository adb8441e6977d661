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
  const change = (): void => {
    settings.palette = palette.value as Palette;
    settings.speed_unit = speed.value as SpeedUnit;
    settings.zone = zone.value === 'site' ? 'site' : 'utc';
    const hours = Number(offset.value);
    if (Number.isFinite(hours) && Math.abs(hours) <= 14) settings.site_offset_hours = hours;
    keep_settings(settings);
    use_palette(settings.palette);
    on_change();
  };
  for (const field of [palette, speed, zone, offset]) field.addEventListener('change', change);
  const dialog = element('dialog', { 'aria-labelledby': 'settings-title' });
  dialog.append(
    element('h2', { id: 'settings-title' }, 'Settings'),
    labelled('Colours', palette),
    labelled('Speed in', speed),
    labelled('Times in', zone),
    labelled('Site time is ahead of UTC by, hours', offset),
    element(
      'div',
      { class: 'buttons' },
      button('Close', () => dialog.close(), { class: 'strong' }),
    ),
  );
  return dialog;
}
