// Where and when we are: the run, its time, the age of the picture, the link, this seat.
import { button, element, set_hidden, set_text } from '../../look/element';
import { zone_of } from '../look/settings';
import { age_grade, age_text, seconds_left, time_text } from '../look/units';
import { rate_text } from '../session/playback';
import { holder_name, run_utc_ms, type Session } from '../session/state';
import type { LinkState } from '../session/wire';
import type { Panel, Station } from '../station';

export function run_text(session: Session): string {
  const by = session.run.by === null ? '' : ` by ${holder_name(session, session.run.by)}`;
  switch (session.run.state) {
    case 'running':
      return 'Running';
    case 'paused':
      return `Paused${by}`;
    case 'stalled':
      return `Stalled${by}`;
    case 'recorded':
      return session.run.is_playing
        ? `Recording, plays ${rate_text(session.run.rate)}`
        : 'Recording, paused';
    case 'over':
      return 'Over';
    default:
      return 'Run not known';
  }
}

export function top_bar(
  station: Station,
  link: () => LinkState,
  open_settings: () => void,
  leave: () => void,
): Panel {
  const title = element('h1', {}, 'Session');
  const run = element('span', { class: 'badge run' });
  // Whoever comes later must not take it for the forecast's.
  const weather = element('span', { class: 'badge made-up' }, 'Weather set by hand');
  const time = element('span', { class: 'time' });
  const age = element('span', { class: 'badge age' });
  const who = element('span', { class: 'who' });
  const cut = element('span', { class: 'cut', role: 'status' });
  const leave_button = button('Leave', leave);
  const box = element(
    'div',
    { class: 'top-row' },
    title,
    run,
    weather,
    time,
    age,
    cut,
    who,
    element('span', { class: 'buttons' }, button('Settings', open_settings), leave_button),
  );
  return {
    box,
    show: () => {
      const { session, settings } = station;
      const state = link();
      const is_in = state.is === 'seated' || state.is === 'cut';
      for (const it of [run, time, age, who, leave_button]) set_hidden(it, !is_in);
      const is_recorded = session.playback !== null;
      for (const it of [age, who, leave_button]) if (is_recorded) set_hidden(it, true);
      set_text(title, is_in && session.id !== '' ? session.id : 'Session');
      set_text(run, run_text(session));
      run.dataset.state = session.run.state;
      set_hidden(weather, !is_in || (session.weather?.led.length ?? 0) === 0);
      const utc_ms = run_utc_ms(session);
      set_text(
        time,
        Number.isNaN(utc_ms)
          ? `${session.run.time_s.toFixed(0)} s`
          : time_text(utc_ms, zone_of(settings), true),
      );
      const age_ms = station.picture_age_ms();
      set_text(age, Number.isNaN(age_ms) ? 'No picture yet' : `Picture ${age_text(age_ms)} old`);
      age.dataset.grade = age_grade(age_ms);
      set_text(who, `${session.name}, ${session.role}`);
      set_hidden(cut, state.is !== 'cut');
      if (state.is === 'cut') {
        const left = seconds_left(state.kept_until_ms, performance.now());
        // Each 5 s in words: a reader is not told each second.
        const seat = is_recorded
          ? ''
          : left > 0
            ? `Your seat is kept ${left > 5 ? Math.ceil(left / 5) * 5 : left} s.`
            : 'Your seat may be gone; you then get a new one.';
        set_text(cut, `No link. Trying again. ${seat}`);
      }
    },
  };
}
