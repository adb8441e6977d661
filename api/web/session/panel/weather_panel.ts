// The weather as the vehicles have it, what of it is set by hand, and what the farm makes of it. A
// supervisor sets it here.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import { metres_text, NOT_KNOWN, span_text, speed_text } from '../look/units';
import type { Weather } from '../session/around';
import type { Panel, Station } from '../station';

const LINES = [
  ['wind', 'Wind at 10 m'],
  ['waves', 'Waves'],
  ['current', 'Current, surface'],
  ['visibility', 'Visibility'],
  ['water_visibility', 'Under water'],
] as const;

export function weather_panel(station: Station): Panel {
  const list = element('dl', { class: 'facts' });
  const values = new Map<string, HTMLElement>();
  for (const [key, name] of LINES) {
    const value = element('dd');
    values.set(key, value);
    list.append(element('dt', {}, name), value);
  }
  const farm_name = element('dt', {}, 'The farm makes');
  const farm_value = element('dd');
  list.append(farm_name, farm_value);
  const led = element('p', { class: 'led' });

  const number = (most: number, step: number): HTMLInputElement =>
    element('input', { type: 'number', min: 0, max: most, step });
  const wind = number(60, 0.5);
  const wind_from = number(360, 1);
  const waves = number(15, 0.1);
  const current = number(5, 0.05);
  const current_to = number(360, 1);
  const visibility = number(100000, 1);
  const water_visibility = number(200, 0.05);
  const over = number(3600, 1);
  over.value = '60';
  const form = element(
    'form',
    { class: 'inline' },
    element('p', { class: 'note' }, 'An empty field is as the run has it by itself.'),
    element('div', { class: 'pair' }, labelled('Wind, m/s', wind), labelled('From, °', wind_from)),
    element(
      'div',
      { class: 'pair' },
      labelled('Current, m/s', current),
      labelled('Towards, °', current_to),
    ),
    element('div', { class: 'pair' }, labelled('Waves, m', waves), labelled('Within, s', over)),
    element(
      'div',
      { class: 'pair' },
      labelled('Visibility, m', visibility),
      labelled('Under water, m', water_visibility),
    ),
    element(
      'div',
      { class: 'buttons' },
      element('button', { type: 'submit', class: 'strong' }, 'Set the weather'),
    ),
  );
  const value_of = (field: HTMLInputElement): number | null =>
    field.value.trim() === '' ? null : Number(field.value);
  const lead = (message: Record<string, unknown>): void => {
    station.ask('Weather', { do: 'weather', ...message });
  };
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const vector = (speed: HTMLInputElement, angle: HTMLInputElement, name: string): unknown =>
      value_of(speed) === null
        ? null
        : { speed_m_s: value_of(speed), [name]: value_of(angle) ?? 0 };
    lead({
      wind: vector(wind, wind_from, 'from_deg'),
      current: vector(current, current_to, 'to_deg'),
      waves_m: value_of(waves),
      visibility_m: value_of(visibility),
      water_visibility_m: value_of(water_visibility),
      over_s: value_of(over),
    });
  });
  const back = button('Back to the run’s own', () => lead({ over_s: value_of(over) }));
  const hands = element(
    'details',
    {},
    element('summary', {}, 'Set the weather'),
    form,
    element('div', { class: 'buttons' }, back),
  );
  const box = element(
    'section',
    { class: 'weather' },
    element('h2', {}, 'Weather'),
    led,
    list,
    hands,
  );

  return {
    box,
    show: () => {
      const { weather } = station.session;
      set_hidden(box, weather === null);
      set_hidden(hands, !station.is_supervisor());
      if (weather === null) return;
      const unit = station.settings.speed_unit;
      const words: Record<string, string> = {
        wind: vector_text(speed_text(weather.wind_m_s, unit), 'from', weather.wind_from_deg),
        waves: waves_text(weather),
        current: vector_text(
          speed_text(weather.current_m_s, unit, 2),
          'to',
          weather.current_to_deg,
        ),
        visibility: weather.visibility_m === null ? '' : metres_text(weather.visibility_m),
        water_visibility:
          weather.water_visibility_m === null ? '' : metres_text(weather.water_visibility_m, 1),
      };
      for (const [key, value] of values) {
        const text = words[key] ?? '';
        const is_led = weather.led.includes(key);
        set_text(value, is_led ? `${text} · set by hand` : text);
        value.classList.toggle('led', is_led);
        set_hidden(value, text === '');
        const term = value.previousElementSibling;
        if (term instanceof HTMLElement) set_hidden(term, text === '');
      }
      const { farm } = weather;
      set_hidden(farm_name, farm === null);
      set_hidden(farm_value, farm === null);
      if (farm !== null) set_text(farm_value, farm_text(farm, weather, unit));
      const is_led = weather.led.length > 0;
      set_hidden(led, !is_led && weather.settles_in_s === 0);
      set_text(led, led_text(weather));
      set_disabled(back, !is_led);
    },
  };
}

function vector_text(speed: string, way: 'from' | 'to', direction_deg: number | null): string {
  if (direction_deg === null || speed === NOT_KNOWN) return speed;
  return `${speed} ${way} ${String(Math.round(direction_deg) % 360).padStart(3, '0')}°`;
}

function waves_text(weather: Weather): string {
  const height = metres_text(weather.waves_m, 1);
  if (weather.waves_m === null || weather.waves_m === 0) return height;
  const period = weather.waves_period_s === null ? '' : `, ${weather.waves_period_s.toFixed(1)} s`;
  return vector_text(height + period, 'from', weather.waves_from_deg);
}

export function farm_text(
  farm: NonNullable<Weather['farm']>,
  weather: Pick<Weather, 'hub_wind_m_s'>,
  unit: Parameters<typeof speed_text>[1],
): string {
  const share = Math.round((100 * farm.power_w) / farm.rated_w);
  const makes = (farm.power_w / 1e6).toFixed(1);
  const most = (farm.rated_w / 1e6).toFixed(0);
  const wind = speed_text(weather.hub_wind_m_s, unit);
  return `${makes} MW of ${most} MW (${share} %), ${farm.turbines} turbines at ${wind}`;
}

export function led_text(weather: Pick<Weather, 'led' | 'led_by' | 'settles_in_s'>): string {
  const settles =
    weather.settles_in_s > 0 ? ` It is so in ${span_text(weather.settles_in_s)}.` : '';
  if (weather.led.length === 0) return `The weather goes back to the run’s own.${settles}`;
  const who = weather.led_by === '' ? 'a supervisor' : weather.led_by;
  const what = weather.led.map((it) => it.replaceAll('_', ' ')).join(', ');
  return `Set by ${who}: ${what}.${settles}`;
}
