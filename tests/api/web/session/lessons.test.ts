// The lessons: whole, and right where they state a number; the kiosk goes back when left alone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fault_of, lessons, type Lesson } from 'page/lessons/lesson';
import { class_of_address } from 'page/session/class_of_address';
import { on_curve } from 'page/panel/farm_curve';
import { read_turbines } from 'page/session/farm';
import { Idle, KIOSK_WAITS_MS } from 'page/session/idle';
import { hold_pairs, may_slide, slid_order, type Held, type SliderName } from 'page/session/slid';

const titled = (title: string): Lesson => {
  const found = lessons.find((it) => it.title.startsWith(title));
  assert.ok(found !== undefined, title);
  return found;
};
const near = (found: number, expected: number, within: number): void =>
  assert.ok(Math.abs(found - expected) <= within, `${found} is not ${expected}`);

test('every lesson is whole, and its right answer is not always at one place', () => {
  assert.equal(lessons.length, 5);
  for (const lesson of lessons) assert.equal(fault_of(lesson), '', lesson.title);
  assert.ok(new Set(lessons.map((it) => it.question.right)).size > 1);
});

test('what is wrong with a lesson is said', () => {
  const good = titled('Slack');
  assert.match(fault_of({ ...good, title: ' ' }), /empty/);
  assert.match(fault_of({ ...good, question: { ...good.question, right: 3 } }), /none of them/);
  assert.match(fault_of({ ...good, task: { ...good.task, weather: {} } }), /nothing to do/);
  const strange = ['depth'] as unknown as Lesson['task']['watch'];
  assert.match(fault_of({ ...good, task: { ...good.task, watch: strange } }), /depth/);
});

test('the numbers of the lessons are right', () => {
  const tide_h = 12.42;
  // Below a quarter of the strongest: twice arcsin(1/4) of a turn.
  near(((2 * Math.asin(0.25)) / (2 * Math.PI)) * tide_h, 1, 0.05);
  assert.match(titled('Slack').question.choices[titled('Slack').question.right]!, /1 hour/);
  // Slack comes 24 h 50 min later each day.
  const later_h = 2 * (2 * tide_h - 24);
  near(later_h, 1 + 40 / 60, 0.02);
  near(Math.sin((2 * Math.PI * later_h) / tide_h), 0.75, 0.02);
  assert.match(titled('Yesterday').question.because, /three quarters/);
  // Power by the cube, of the current through water and of the wind.
  assert.match(titled('Battery').question.choices[titled('Battery').question.right]!, /eight/);
  near((9 / 8) ** 3, 1.42, 0.005);
  assert.match(titled('How sure').question.because, /1\.42/);
  // Contrast left at twice the visibility of a black disc: exp(-2 x 4.8).
  assert.ok(Math.exp(-2 * 4.8) < 1e-4);
});

test('lessons are shown where they are asked for', () => {
  assert.deepEqual(class_of_address(''), { has_lessons: false, resets: false });
  assert.deepEqual(class_of_address('?session=a&class'), { has_lessons: true, resets: false });
  assert.deepEqual(class_of_address('?kiosk'), { has_lessons: true, resets: true });
});

test('a kiosk goes back once, when nobody has touched it for a while', () => {
  const idle = new Idle(0);
  assert.equal(idle.is_over(10 * KIOSK_WAITS_MS), false, 'nobody was there');
  idle.touch(1000);
  assert.equal(idle.is_over(999 + KIOSK_WAITS_MS), false);
  assert.equal(idle.is_over(1000 + KIOSK_WAITS_MS), true);
  assert.equal(idle.is_over(2000 + KIOSK_WAITS_MS), false, 'once');
  idle.touch(3000 + KIOSK_WAITS_MS);
  assert.equal(idle.is_over(3000 + 2 * KIOSK_WAITS_MS), true);
});

test('sliders ask for what is held, and give the rest back to the run', () => {
  const nothing = { wind: null, current: null, waves_m: null };
  const far = { visibility_m: null, water_visibility_m: null };
  assert.deepEqual(slid_order(new Map()), { ...nothing, ...far, over_s: 5 });
  const held = new Map([
    ['wind', 12],
    ['wind_from', 240],
    ['water_visibility', 0],
  ] as const);
  assert.deepEqual(slid_order(held), {
    ...nothing,
    wind: { speed_m_s: 12, from_deg: 240 },
    visibility_m: null,
    water_visibility_m: 0.5, // the end of the slider is not blindness
    over_s: 5,
  });
});

test('a wind of which nobody says how fast it is is not ordered by its direction', () => {
  const calm: Record<string, number | null> = { wind: 0, wind_from: null, current: null };
  const windy: Record<string, number | null> = { wind: 8, wind_from: 200, current: null };
  const held_with = (
    told: Record<string, number | null>,
    ...moved: [SliderName, number][]
  ): Held => {
    const held: Held = new Map(moved);
    hold_pairs(held, (name) => told[name] ?? null);
    return held;
  };
  const may = (name: SliderName, held: Held = new Map()): boolean =>
    may_slide(name, held, (it) => windy[it] ?? null);
  assert.deepEqual(
    ['wind', 'wind_from', 'current', 'visibility'].map((it) => may(it as SliderName)),
    [true, true, true, true],
  );
  assert.equal(may('current_to'), false, 'nobody says how fast');
  assert.equal(may('current_to', new Map([['current', 0.4]])), true, 'held');
  // What is moved is ordered with the other as it was told.
  assert.deepEqual(slid_order(held_with(windy, ['wind_from', 90])).wind, {
    speed_m_s: 8,
    from_deg: 90,
  });
  assert.deepEqual(slid_order(held_with(windy, ['wind', 12])).wind, {
    speed_m_s: 12,
    from_deg: 200,
  });
  assert.deepEqual(slid_order(held_with(calm, ['wind', 5])).wind, { speed_m_s: 5, from_deg: 0 });
  // And nothing where nobody says it, also by who moved it before it was gone.
  const held = held_with(windy, ['current_to', 90]);
  assert.deepEqual([slid_order(held).current, held.size], [null, 0]);
  assert.equal(slid_order(new Map([['current_to', 90]])).current, null);
});

test('the curve of a turbine is drawn to its ends, and not beyond', () => {
  const told = [
    [0, 0],
    [10, 3e6],
    [25, 5e6],
  ];
  const turbines = read_turbines({
    hub_height_m: 90,
    rotor_diameter_m: 126,
    rated_w: 5e6,
    curve: told,
    places: [],
  });
  assert.ok(turbines !== null);
  const [calm, storm] = [on_curve(turbines, 0, 0), on_curve(turbines, 25, 5e6)];
  const middle = on_curve(turbines, 12.5, 2.5e6);
  near(middle.x, (calm.x + storm.x) / 2, 1e-9);
  near(middle.y, (calm.y + storm.y) / 2, 1e-9);
  assert.ok(storm.y < calm.y && storm.x > calm.x, 'more is up and to the right');
  assert.deepEqual(on_curve(turbines, 99, 9e6), storm, 'nothing is drawn outside');
});
