// The slider of hours: over all that the forecast reaches, with the issue time and now marked.
import type { Desk } from '../look/desk';
import { button, element, set_hidden, set_text } from '../../look/element';
import { HOUR_MS, hour_of, hour_within, reach_of, time_ticks, type Reach } from '../look/hours';
import { hour_words, outside_words } from './hour_words';

const LOOK_AT_CLOCK_MS = 20_000;

export function timePart(desk: Desk): HTMLElement {
  const { view, server, look } = desk;
  const slider = element('input', {
    type: 'range',
    step: HOUR_MS / 1000,
    'aria-label': 'Hour of the forecast',
  });
  const scale = element('div', { class: 'time-scale', 'aria-hidden': 'true' });
  const flags = element('div', { class: 'time-flags', 'aria-hidden': 'true' });
  const chosen = element('output', { class: 'time-chosen' });
  const words = element('p', { class: 'note time-words' });
  const step = (hours: number): void => {
    const reach = reach_of(server.forecast(view.values.site));
    const at_ms = hour_of(desk);
    if (reach !== null && at_ms !== null) {
      view.set({ at_ms: hour_within(reach, at_ms + hours * HOUR_MS) });
    }
  };
  const buttons = [
    button('− 1 h', () => step(-1), { 'aria-label': '− 1 h, back' }),
    button('+ 1 h', () => step(1), { 'aria-label': '+ 1 h, on' }),
    button('Now', () => view.set({ at_ms: null })),
  ];
  slider.addEventListener('input', () => view.set({ at_ms: Number(slider.value) * 1000 }));

  const scale_of = (reach: Reach): void => {
    slider.min = String(reach.from_ms / 1000);
    slider.max = String(reach.to_ms / 1000);
    const share = (at_ms: number): number =>
      (at_ms - reach.from_ms) / (reach.to_ms - reach.from_ms);
    const marks = time_ticks(reach, look.zone, scale.clientWidth - 22).map(
      ({ at_ms, text, is_day }) => mark(is_day ? 'tick day' : 'tick', text, share(at_ms)),
    );
    const raised: HTMLElement[] = [];
    const issued_ms = Date.parse(server.forecast(view.values.site)?.issued ?? '');
    const now_ms = server.now_ms();
    if (share(issued_ms) >= 0 && share(issued_ms) <= 1) {
      raised.push(mark('flag issued', 'issued', share(issued_ms)));
    }
    if (share(now_ms) >= 0 && share(now_ms) <= 1)
      raised.push(mark('flag now', 'now', share(now_ms)));
    scale.replaceChildren(...marks);
    flags.replaceChildren(...raised);
  };
  const show = (with_scale: boolean): void => {
    const forecast = server.forecast(view.values.site);
    const reach = reach_of(forecast);
    const at_ms = hour_of(desk);
    for (const each of [slider, ...buttons]) each.disabled = reach === null;
    set_hidden(scale, reach === null);
    set_hidden(flags, reach === null);
    if (reach === null || at_ms === null || forecast === null) {
      set_text(chosen, 'No hour');
      set_text(words, 'There is no forecast to move in.');
      return;
    }
    if (with_scale) scale_of(reach);
    slider.value = String(at_ms / 1000);
    set_text(chosen, `${look.time(at_ms)} ${look.zone_name}`);
    const outside = outside_words(reach, view.values.at_ms, look);
    const where = hour_words(reach, forecast.issued, at_ms, server.now_ms());
    set_text(words, outside === '' ? where : `${outside} ${where}`);
    slider.setAttribute('aria-valuetext', `${chosen.textContent}, ${words.textContent}`);
    buttons[2]?.setAttribute('aria-pressed', String(view.values.at_ms === null));
  };
  desk.onChange((changed) => {
    const is_only_hour = [...changed].every((what) => what === 'at_ms');
    const is_of_time = ['at_ms', 'site', 'sites', 'forecast', 'clock'].some((what) =>
      changed.has(what as 'clock'),
    );
    if (is_of_time) show(!is_only_hour);
  });
  setInterval(() => show(true), LOOK_AT_CLOCK_MS);
  new ResizeObserver(() => show(true)).observe(scale);
  show(true);
  return element(
    'div',
    { class: 'time' },
    element('div', { class: 'time-says' }, chosen, words),
    element('div', { class: 'time-slides' }, flags, slider, scale),
    element('div', { class: 'time-steps', role: 'group', 'aria-label': 'Step' }, ...buttons),
  );
}

function mark(kind: string, text: string, share: number): HTMLElement {
  const made = element('span', { class: kind }, text);
  if (share < 0.04) made.classList.add('first');
  if (share > 0.96) made.classList.add('last');
  made.style.left = `calc(var(--thumb) / 2 + ${share} * (100% - var(--thumb)))`;
  return made;
}
