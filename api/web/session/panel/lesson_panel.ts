// Lessons for classes and visitors: a question, something to do, and what happens, live. The
// weather is set by the supervisor's hand, for all in the session, and says so where it is shown.
import { button, element, set_disabled, set_hidden, set_text } from '../../look/element';
import type { Lesson, Watched } from '../lessons/lesson';
import { level_text, metres_text, percent_text, span_text, speed_text } from '../look/units';
import type { Panel, Station } from '../station';
import { farm_curve } from './farm_curve';
import { farm_text } from './weather_panel';
import { weather_sliders } from './weather_sliders';

const SETTLES_S = 10;
const NAMES: Record<Watched, string> = {
  wind: 'Wind at 10 m',
  waves: 'Waves',
  current: 'Current, surface',
  water_visibility: 'One sees under water',
  farm: 'The farm makes',
  speed: 'Speed over ground',
  level: 'Level',
  charge: 'Charge',
  reserve: 'Until it must turn for home',
};

export interface LessonPanel extends Panel {
  /**
   * Back to the beginning, the weather as the run has it by itself. False: that could not be said,
   * and the weather is as it was.
   */
  reset(): boolean;
}

export function watched_text(station: Station, what: Watched): string {
  const { session, chosen, settings } = station;
  const { weather } = session;
  const pose = chosen === null ? undefined : session.poses.get(chosen);
  const unit = settings.speed_unit;
  switch (what) {
    case 'wind':
      return speed_text(weather?.wind_m_s ?? null, unit);
    case 'waves':
      return metres_text(weather?.waves_m ?? null, 1);
    case 'current':
      return speed_text(weather?.current_m_s ?? null, unit, 2);
    case 'water_visibility':
      return metres_text(weather?.water_visibility_m ?? null, 1);
    case 'farm':
      return weather?.farm == null ? 'no turbines here' : farm_text(weather.farm, weather, unit);
    case 'speed':
      return speed_text(
        pose === undefined ? null : Math.hypot(pose.east_m_s, pose.north_m_s),
        unit,
        2,
      );
    case 'level':
      return level_text(pose?.up_m ?? null);
    case 'charge':
      return percent_text(pose?.charge ?? null);
    case 'reserve': {
      const margin_s = chosen === null ? null : (session.statuses.get(chosen)?.margin_s ?? null);
      return margin_s === null ? 'not told' : span_text(margin_s);
    }
  }
}

export function lesson_panel(station: Station, lessons: readonly Lesson[]): LessonPanel {
  let open: Lesson | null = null;
  let is_led = false;
  const inside = element('div', {});
  const sliders = weather_sliders(station);
  const curve = farm_curve();
  const box = element(
    'section',
    { class: 'lessons' },
    element('h2', {}, 'Lessons'),
    inside,
    curve.box,
    sliders.box,
  );
  let watched: { what: Watched; value: HTMLElement }[] = [];
  let doing: HTMLButtonElement | null = null;

  const lead = (weather: Record<string, unknown>): boolean =>
    station.ask('Weather', { do: 'weather', ...weather, over_s: SETTLES_S });
  const show_list = (): void => {
    open = null;
    watched = [];
    doing = null;
    inside.replaceChildren(
      element(
        'ul',
        {},
        ...lessons.map((it) =>
          element(
            'li',
            {},
            button(it.title, () => begin(it)),
          ),
        ),
      ),
    );
  };
  const reset = (): boolean => {
    if ((is_led || sliders.holds()) && !lead({})) return false;
    is_led = false;
    sliders.let_go();
    show_list();
    return true;
  };
  const begin = (lesson: Lesson): void => {
    open = lesson;
    const { question } = lesson;
    const answer = element('p', { role: 'status' });
    const next = element('div', {});
    const choices = question.choices.map((text, nth) =>
      button(text, () => {
        const is_right = nth === question.right;
        set_text(answer, `${is_right ? 'Yes.' : 'Not quite.'} ${question.because}`);
        if (next.childElementCount === 0) next.append(...task_of(lesson));
      }),
    );
    inside.replaceChildren(
      element('h3', { tabindex: -1 }, lesson.title),
      element('p', {}, lesson.says),
      element('p', {}, element('strong', {}, question.asks)),
      element('div', { class: 'buttons' }, ...choices),
      answer,
      next,
      element('div', { class: 'buttons' }, button('Back to the lessons', reset)),
    );
    inside.querySelector('h3')?.focus();
  };
  const task_of = (lesson: Lesson): HTMLElement[] => {
    const list = element('dl', { class: 'facts' });
    watched = lesson.task.watch.map((what) => {
      const value = element('dd');
      list.append(element('dt', {}, NAMES[what]), value);
      return { what, value };
    });
    const happens = element('p', {});
    doing = button('Do it', () => {
      if (!lead(lesson.task.weather)) return;
      is_led = true;
      set_text(happens, lesson.happens);
    });
    const who = element('p', { class: 'note' }, 'Only a supervisor of the session can do this.');
    set_hidden(who, station.is_supervisor());
    const buttons = element('div', { class: 'buttons' }, doing);
    return [element('p', {}, lesson.task.says), buttons, who, list, happens];
  };
  show_list();

  return {
    box,
    reset,
    show: () => {
      set_hidden(box, station.session.playback !== null);
      if (doing !== null) set_disabled(doing, !station.is_supervisor());
      sliders.show();
      const { turbines, weather } = station.session;
      curve.show(turbines, weather, station.settings.speed_unit);
      if (open === null) return;
      for (const { what, value } of watched) set_text(value, watched_text(station, what));
    },
  };
}
