// The scrubber of a log that is watched again: where the head is, what was done when, and how fast
// it goes on.
import { button, by_id, element, labelled, set_disabled } from '../../look/element';
import { ready_canvas } from '../look/canvas';
import { set_hidden, set_text } from '../../look/element';
import { colours } from '../look/palette';
import { zone_of } from '../look/settings';
import { time_text } from '../look/units';
import {
  key_time_s,
  next_action_s,
  previous_action_s,
  rate_text,
  RATES,
  Seeker,
  share_of,
  time_of,
  value_text,
  way_text,
} from '../session/playback';
import { line } from '../view/draw';
import type { Panel, Station } from '../station';

const THUMB_PX = 18; // as in page.css: its middle goes from half of it to half of it

export interface PlaybackBar extends Panel {
  toggle(): void;
  seek(time_s: number): void;
  /** The link is new or gone. */
  forget(): void;
}

export function playback_bar(station: Station): PlaybackBar {
  const seeker = new Seeker(
    (time_s, on_answer) => station.ask('Seek', { do: 'seek', time_s }, on_answer),
    () => performance.now(),
    (wait_ms, run) => void setTimeout(run, wait_ms),
  );
  const head_s = (): number => seeker.shown_s(station.session.run.time_s);
  const seek = (time_s: number | null): void => {
    if (time_s === null) return;
    seeker.want(time_s);
    show();
  };
  const play = (): void => {
    station.ask('Play', { do: 'play', rate: Number(rate.value) }, () => undefined);
  };
  const toggle = (): void => {
    if (station.session.run.is_playing) station.ask('Pause', { do: 'pause' }, () => undefined);
    else play();
  };

  const marks = element('canvas', { class: 'marks', 'aria-hidden': 'true' });
  const range = element('input', { type: 'range', step: 'any', 'aria-label': 'Time of the run' });
  range.addEventListener('input', () => seek(Number(range.value)));
  range.addEventListener('keydown', (event) => {
    const { playback } = station.session;
    if (playback === null || event.ctrlKey || event.altKey || event.metaKey) return;
    const time_s = key_time_s(event.key, head_s(), playback);
    if (time_s === null) return;
    event.preventDefault();
    seek(time_s);
  });
  const play_button = button('Play', toggle, { class: 'strong play' });
  const previous = button('Previous action', () => seek(before()));
  const next = button('Next action', () => seek(after()));
  const rate = element('select');
  for (const it of RATES) rate.append(element('option', { value: it }, rate_text(it)));
  rate.value = '1';
  rate.addEventListener('change', () => {
    if (station.session.run.is_playing) play();
  });
  const time = element('span', { class: 'head-time' });
  const way = element('span', { class: 'note way-text' });
  const legend = element(
    'p',
    { class: 'note legend' },
    '▼ an action, × one that was refused.',
    element('span', { class: 'space-hint' }, ' Space plays and pauses.'),
  );
  const box = element(
    'div',
    { class: 'playback-row' },
    element('div', { class: 'scrub' }, marks, range),
    element(
      'div',
      { class: 'playback-tools' },
      play_button,
      element('div', { class: 'buttons' }, previous, next),
      labelled('Rate', rate),
      element('p', { class: 'head' }, time, ' ', way),
      legend,
    ),
  );
  let drawn = '';

  const after = (): number | null => {
    const { session } = station;
    return session.playback && next_action_s(session.actions, head_s(), session.playback);
  };
  const before = (): number | null => {
    const { session } = station;
    const going = session.run.is_playing ? session.run.rate : 0;
    return (
      session.playback && previous_action_s(session.actions, head_s(), session.playback, going)
    );
  };

  const show = (): void => {
    const { session, settings } = station;
    const { playback } = session;
    set_hidden(by_id('playback'), playback === null);
    if (playback === null) return;
    const now_s = head_s();
    const zone = zone_of(settings);
    set_attribute(range, 'min', String(playback.from_s));
    set_attribute(range, 'max', String(playback.to_s));
    if (range.value !== String(now_s)) range.value = String(now_s);
    set_attribute(range, 'aria-valuetext', value_text(now_s, session.start_utc_ms, playback, zone));
    set_text(play_button, session.run.is_playing ? 'Pause' : 'Play');
    set_disabled(previous, before() === null);
    set_disabled(next, after() === null);
    const utc_ms = session.start_utc_ms + 1000 * now_s;
    set_text(time, Number.isNaN(utc_ms) ? '' : time_text(utc_ms, zone, true));
    set_text(way, way_text(now_s, playback));
    const key = JSON.stringify([
      session.actions.length,
      session.id,
      marks.clientWidth,
      settings.palette,
    ]);
    if (key === drawn) return;
    drawn = key;
    draw();
  };

  const draw = (): void => {
    const { session } = station;
    const ready = ready_canvas(marks);
    if (ready === null || session.playback === null) return;
    const { context, width, height } = ready;
    const lane = height / 2; // those refused above, those taken below
    const c = colours();
    for (const action of session.actions) {
      const share = share_of(time_of(action, session.playback), session.playback);
      const x = THUMB_PX / 2 + share * (width - THUMB_PX);
      if (action.taken) {
        context.fillStyle = c.accent;
        context.beginPath();
        context.moveTo(x - 5, lane + 1);
        context.lineTo(x + 5, lane + 1);
        context.lineTo(x, height - 1);
        context.fill();
        continue;
      }
      for (const slope of [-1, 1])
        line(
          context,
          [
            { x: x - 4, y: lane / 2 - 4 * slope },
            { x: x + 4, y: lane / 2 + 4 * slope },
          ],
          c.alarm,
          2.5,
        );
    }
  };

  return { box, show, toggle, seek, forget: () => seeker.forget() };
}

function set_attribute(node: HTMLElement, name: string, value: string): void {
  if (node.getAttribute(name) !== value) node.setAttribute(name, value);
}
