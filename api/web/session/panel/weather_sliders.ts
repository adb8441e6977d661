// Wind, sea, current and how far one sees as sliders, for classes. A slider goes with the weather
// until somebody moves it; then it holds, and says so, until it is let go.
import { button, element, labelled, set_disabled, set_hidden, set_text } from '../../look/element';
import { notice } from '../look/notice';
import { metres_text, speed_text, type SpeedUnit } from '../look/units';
import type { Weather } from '../session/around';
import { hold_pairs, may_slide, slid_order, type Held, type SliderName } from '../session/slid';
import type { Station } from '../station';

const SENDS_EVERY_MS = 300; // while a slider is dragged

interface Slider {
  name: SliderName;
  label: string;
  group: string; // by its name in what is led
  most: number;
  step: number;
  of: (weather: Weather) => number | null;
  text: (value: number, unit: SpeedUnit) => string;
}

const degrees = (value: number): string => `${String(Math.round(value) % 360).padStart(3, '0')}°`;
const SLIDERS: readonly Slider[] = [
  {
    name: 'wind',
    label: 'Wind at 10 m',
    group: 'wind',
    most: 30,
    step: 0.5,
    of: (it) => it.wind_m_s,
    text: (value, unit) => speed_text(value, unit),
  },
  {
    name: 'wind_from',
    label: 'Wind from',
    group: 'wind',
    most: 359,
    step: 1,
    of: (it) => it.wind_from_deg,
    text: degrees,
  },
  {
    name: 'waves',
    label: 'Waves',
    group: 'waves',
    most: 6,
    step: 0.1,
    of: (it) => it.waves_m,
    text: (value) => metres_text(value, 1),
  },
  {
    name: 'current',
    label: 'Current',
    group: 'current',
    most: 2,
    step: 0.05,
    of: (it) => it.current_m_s,
    text: (value, unit) => speed_text(value, unit, 2),
  },
  {
    name: 'current_to',
    label: 'Current towards',
    group: 'current',
    most: 359,
    step: 1,
    of: (it) => it.current_to_deg,
    text: degrees,
  },
  {
    name: 'visibility',
    label: 'One sees, in air',
    group: 'visibility',
    most: 20_000,
    step: 100,
    of: (it) => it.visibility_m,
    text: (value) => metres_text(value),
  },
  {
    name: 'water_visibility',
    label: 'One sees, under water',
    group: 'water_visibility',
    most: 30,
    step: 0.5,
    of: (it) => it.water_visibility_m,
    text: (value) => metres_text(value, 1),
  },
];

export interface WeatherSliders {
  readonly box: HTMLElement;
  /** A slider holds something of the weather. */
  holds(): boolean;
  /** All go with the weather again; nothing is asked for. */
  let_go(): void;
  show(): void;
}

interface Row {
  slider: Slider;
  field: HTMLInputElement;
  value: HTMLElement;
  mark: HTMLElement;
}

export function weather_sliders(station: Station): WeatherSliders {
  const held: Held = new Map();
  const seen_led = new Set<string>();
  let is_new = false;
  let sent_ms = -Infinity;

  const rows: Row[] = SLIDERS.map((slider) => {
    const { most, step } = slider;
    const field = element('input', { type: 'range', min: 0, max: most, step });
    const row = { slider, field, value: element('output', {}), mark: element('span', {}) };
    row.mark.className = 'led';
    field.addEventListener('input', () => {
      held.set(slider.name, Number(field.value));
      is_new = true;
    });
    return row;
  });
  const back = button('All by itself', () => {
    if (station.ask('Weather', { do: 'weather', ...slid_order(new Map()) })) let_go();
  });
  const who = element('p', { class: 'note' }, 'Only a supervisor of the session can move these.');
  const box = element(
    'details',
    { class: 'own-weather' },
    element('summary', {}, 'Your own weather'),
    who,
    ...rows.map(({ slider, field, value, mark }) =>
      element('div', { class: 'slid' }, labelled(slider.label, field), value, mark),
    ),
    element('div', { class: 'buttons' }, back),
  );

  function let_go(): void {
    held.clear();
    seen_led.clear();
    is_new = false;
  }

  /** What was led and is so no longer was given back by somebody: its sliders are free. */
  function mind_others(led: readonly string[]): void {
    for (const { slider } of rows) {
      if (led.includes(slider.group)) seen_led.add(slider.group);
      else if (!is_new && seen_led.has(slider.group)) held.delete(slider.name);
    }
    for (const group of seen_led) if (!is_new && !led.includes(group)) seen_led.delete(group);
  }

  function told(name: SliderName): number | null {
    const { weather } = station.session;
    const slider = SLIDERS.find((it) => it.name === name);
    return weather === null ? null : (slider?.of(weather) ?? null);
  }

  function send(): void {
    const now_ms = performance.now();
    if (!is_new || now_ms < sent_ms + SENDS_EVERY_MS) return;
    sent_ms = now_ms;
    is_new = false;
    hold_pairs(held, told);
    const is_sent = station.ask('Weather', { do: 'weather', ...slid_order(held) }, (answer) => {
      if (answer.taken) return; // it is seen where it is shown
      let_go();
      notice(`Weather: refused. ${answer.text || answer.reason}`, 'alarm');
    });
    if (!is_sent) let_go();
  }

  return {
    box,
    holds: () => held.size > 0,
    let_go,
    show: () => {
      const { weather } = station.session;
      const is_supervisor = station.is_supervisor();
      set_hidden(who, is_supervisor);
      if (weather === null) return;
      mind_others(weather.led);
      send();
      for (const { slider, field, value, mark } of rows) {
        set_disabled(field, !is_supervisor || !may_slide(slider.name, held, told));
        const is_held = held.has(slider.name);
        const is = is_held ? (held.get(slider.name) ?? null) : slider.of(weather);
        if (!is_held) field.value = String(is ?? 0);
        const text = is === null ? 'nobody says' : slider.text(is, station.settings.speed_unit);
        set_text(value, text);
        field.setAttribute('aria-valuetext', text);
        set_text(mark, is_held || weather.led.includes(slider.group) ? 'set by hand' : '');
      }
      set_disabled(back, !is_supervisor || (held.size === 0 && weather.led.length === 0));
    },
  };
}
