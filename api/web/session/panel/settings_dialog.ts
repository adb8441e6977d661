// How this browser shows things. Nothing of it is sent; opening it drops no helm.
import { button, element, labelled } from '../../look/element';
import { use_palette } from '../look/palette';
import { keep_settings, type Palette, type Settings } from '../look/settings';
import type { SpeedUnit } from '../look/units';

export interface SettingsDialog {
  readonly node: HTMLDialogElement;
  open(): void;
}

export function settings_dialog(settings: Settings, on_change: () => void): SettingsDialog {
  const choice = (options: readonly (readonly [string, string])[]): HTMLSelectElement =>
    element('select', {}, ...options.map(([key, text]) => element('option', { value: key }, text)));
  const palette = choice([
    ['day', 'Day'],
    ['dusk', 'Dusk'],
    ['night', 'Night'],
  ]);
  const speed = choice([
    ['m/s', 'm/s'],
    ['knots', 'Knots'],
  ]);
  const zone = choice([
    ['utc', 'UTC'],
    ['site', 'Site time'],
  ]);
  const offset = element('input', {
    type: 'number',
    min: -14,
    max: 14,
    step: 0.25,
  });
  const check = (text: string): { field: HTMLInputElement; box: HTMLElement } => {
    const field = element('input', { type: 'checkbox' });
    return { field, box: element('label', { class: 'check' }, field, text) };
  };
  const narrows = check('In a headset: narrow the view while moved');
  const sits = check('In a headset: sitting');
  /** They may have changed elsewhere, as on a headset's board. */
  const fill = (): void => {
    palette.value = settings.palette;
    speed.value = settings.speed_unit;
    zone.value = settings.zone;
    offset.value = String(settings.site_offset_hours);
    narrows.field.checked = settings.headset_narrows;
    sits.field.checked = settings.headset_is_seated;
  };

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
  return {
    node: dialog,
    open: () => {
      fill();
      dialog.showModal();
    },
  };
}
