// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import type { Answer } from 'page/decide/answer';
import { Refused } from 'page/server/server';
import type { Limit } from 'page/what_if/limits';
import {
  days_text,
  history_limit,
  price_of,
  type Priced,
  type Workability,
} from 'page/what_if/price';

const limit = (variable: string, value: number, at_depth_m: number | null = null): Limit => ({
  path: ['limits', 0, variable],
  role: 'surveyor',
  variable,
  value,
  phases: [],
  at_depth_m,
});
const priced = (of: Limit, was: number): Priced => ({
  site: 'bay',
  limit: of,
  was,
  shown_depth_m: 20,
  duration_h: 1.5,
  contingency_h: 0.5,
});

/** A history that allows the more, the higher the number in the limit is. */
function history(asked: string[]): (path: string) => Promise<Answer<Workability>> {
  return async (from) => {
    asked.push(from);
    const bound = Number(/%3C%3D([\d.]+)/.exec(from)?.[1]);
    const by_month = [
      { month: 3, workability: bound },
      { month: 4, workability: null },
    ];
    const last = '2025-03-13T00:00:00Z';
    return { from, body: { first: '2025-03-03T00:00:00Z', last, source: 'site bay', by_month } };
  };
}
const rows = (node: HTMLElement): (string | null)[][] =>
  [...node.querySelectorAll('tbody tr')].map((row) =>
    [...row.children].map((it) => it.textContent),
  );

test('ThePriceIsAskedAsTheHistoryCallsIt', async () => {
  expect(history_limit('significant_wave_height_m', 1.5)).toBe(
    'sea_surface_wave_significant_height<=1.5 m',
  );
  expect(history_limit('deck_motion_m', 1.5)).toBeNull();
  const asked: string[] = [];
  await price_of(history(asked), priced(limit('wind_speed_m_s', 0.75), 0.5));
  expect(asked).toEqual([
    '/workability?limit=wind_speed%3C%3D0.5+m%2Fs&duration=90min&contingency=30min',
    '/workability?limit=wind_speed%3C%3D0.75+m%2Fs&duration=90min&contingency=30min',
  ]);
});

test('ThePriceIsDaysOfEachMonth', async () => {
  expect(days_text(0.5, 4)).toBe('15.0 days (50 %)');
  const node = await price_of(history([]), priced(limit('significant_wave_height_m', 0.75), 0.5));
  expect(rows(node)).toEqual([
    ['Mar', '15.5 days (50 %)', '23.3 days (75 %)'],
    ['Apr', '–', '–'],
  ]);
  expect(node.textContent).toContain('less than a year');
  expect(node.textContent).not.toContain('depth');
});

test('OfACurrentTheDepthIsTheSheetsElseTheOneThatIsChosenAndItIsSaid', async () => {
  const asked: string[] = [];
  const at_1 = priced(limit('current_speed_m_s', 0.75, 1), 0.5);
  const node = await price_of(history(asked), at_1);
  expect(asked[1]).toContain('limit=sea_water_speed%3C%3D0.75+m%2Fs');
  expect(asked.every((path) => path.endsWith('&depth=1'))).toBe(true);
  expect(node.textContent).toContain('The current is that at 1 m, as the sheet has it.');
  expect(rows(node)[0]).toEqual(['Mar', '15.5 days (50 %)', '23.3 days (75 %)']);
  asked.length = 0;
  const free = await price_of(history(asked), priced(limit('current_speed_m_s', 0.75), 0.5));
  expect(asked.every((path) => path.endsWith('&depth=20'))).toBe(true);
  expect(free.textContent).toContain('at 20 m, the depth chosen at the map');
});

test('WithoutAHistoryItIsSaidWhatToIngest', async () => {
  const detail = 'site bay: found no sea_water_speed; there is wind_speed';
  const none = (): Promise<never> => Promise.reject(new Refused(404, detail));
  const of = priced(limit('current_speed_m_s', 0.75), 0.5);
  const node = await price_of(none, of);
  expect(node.textContent).toContain(`no history of "current speed at most": ${detail}`);
  const lines = [...node.querySelectorAll('code')].map((it) => it.textContent);
  expect(lines[0]).toBe('slackwater forecast --site bay --print-downloads --history 365d');
  expect(lines[1]).toContain('slackwater ingest');
  const wrong = (): Promise<never> => Promise.reject(new Refused(400, 'found --depth 500'));
  expect((await price_of(wrong, of)).textContent).toContain('not be worked out: found --depth 500');
  const unknown = await price_of(none, priced(limit('deck_motion_m', 2), 1));
  expect(unknown.textContent).toContain('its price is not known');
});
