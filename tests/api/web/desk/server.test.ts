import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { fetch_water, NO_TIDE, said_by_all } from 'page/place/water';
import { link_words } from 'page/look/top';
import { whole_site } from 'page/server/answers';
import { Refused, Server } from 'page/server/server';
import { look } from './decide_made';

type Answer = { status?: number; body: unknown } | 'gone' | 'silent';

/** A server of answers by path; what was asked is noted. */
function made_up(answers: Record<string, Answer>): {
  server: Server;
  asked: string[];
  told: string[];
} {
  const asked: string[] = [];
  const told: string[] = [];
  const ask = async (path: string, init?: RequestInit): Promise<Response> => {
    asked.push(path);
    const found = Object.keys(answers).find(
      (start) => path === start || path.startsWith(`${start}?`),
    );
    const answer = found === undefined ? undefined : answers[found];
    if (answer === 'gone') throw new TypeError('Failed to fetch');
    if (answer === 'silent') {
      return new Promise((_, fail) => init?.signal?.addEventListener('abort', () => fail()));
    }
    if (answer === undefined) return problem(404, 'found no such thing');
    const status = answer.status ?? 200;
    return new Response(JSON.stringify(answer.body), { status });
  };
  return {
    server: new Server(
      ask,
      (what) => told.push(what),
      () => 'bay',
    ),
    asked,
    told,
  };
}
const problem = (status: number, detail: string): Response =>
  new Response(JSON.stringify({ type: 'about:blank', title: 'x', status, detail }), { status });

const sites = (instance: string): Answer => ({
  body: {
    now: '2025-03-13T06:00:00Z',
    stale_after_s: 1,
    trouble: '',
    sites: [{ id: 'bay', forecast: { instance } }],
  },
});

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

test('OneAnswerIsEnoughForAllWhoAsk', async () => {
  const { server, asked } = made_up({ '/sites/bay': { body: { id: 'bay' } } });
  await Promise.all([server.site('bay'), server.site('bay')]);
  await server.site('bay');
  expect(asked).toEqual(['/sites/bay']);
});

test('ASiteThatIsNotDescribedIsAMapWithoutThings', async () => {
  const column = { location: 'bay', longitude_deg: 1, latitude_deg: 2, bed_m: 30 };
  const { server } = made_up({ '/sites/bay': { body: { id: 'bay', columns: [column] } } });
  const site = await server.site('bay');
  expect(site).toMatchObject({ name: 'bay', turbines: [], place: { longitude_deg: 1 } });
  expect(whole_site({ id: 'x' })).toMatchObject({ place: null, columns: [], forecast: null });
});

test('ARefusalSpeaksInTheServersWordsAndIsNotKept', async () => {
  const { server, asked } = made_up({});
  await expect(server.site('bay')).rejects.toMatchObject({
    status: 404,
    detail: 'found no such thing',
  });
  await expect(server.site('bay')).rejects.toBeInstanceOf(Refused);
  expect(asked.length).toBe(2);
});

test('AServerThatWentIsToldOnceAndTriedAgainByItself', async () => {
  const answers: Record<string, Answer> = { '/sites': sites('a') };
  const { server, told, asked } = made_up(answers);
  await server.watch();
  answers['/sites'] = 'gone';
  await vi.advanceTimersByTimeAsync(30_000);
  await vi.advanceTimersByTimeAsync(6_000);
  expect(server.link.is).toBe('gone');
  expect(told.filter((what) => what === 'server').length).toBe(1);
  const before = asked.length;
  answers['/sites'] = sites('a');
  await vi.advanceTimersByTimeAsync(4_000);
  expect(asked.length).toBeGreaterThan(before);
  expect(server.link.is).toBe('there');
  expect(told.filter((what) => what === 'server').length).toBe(2);
});

test('AServerThatSaysNothingIsGone', async () => {
  const answers: Record<string, Answer> = { '/sites': sites('a') };
  const { server, told } = made_up(answers);
  await server.watch();
  answers['/sites'] = 'silent';
  await vi.advanceTimersByTimeAsync(30_000 + 20_000);
  expect(server.link).toEqual({ is: 'gone', why: null });
  const words = link_words(server, look);
  expect(words).toContain('does not answer');
  expect(words).toContain('last heard Thu 13 Mar 06:00 UTC');
  answers['/sites'] = sites('a');
  await vi.advanceTimersByTimeAsync(3_000);
  expect(link_words(server, look)).toBe('');
  expect(told.filter((what) => what === 'server').length).toBe(2);
});

test('AServerThatCannotTellItsSitesIsGoneThoughItAnswers', async () => {
  const answers: Record<string, Answer> = { '/sites': sites('a'), '/sites/bay': { body: 1 } };
  const { server, told } = made_up(answers);
  await server.watch();
  answers['/sites'] = { status: 500, body: { title: 'x', detail: 'the store cannot be read' } };
  await vi.advanceTimersByTimeAsync(31_000);
  expect(link_words(server, look)).toMatch(/^The server is in trouble: the store cannot be read\./);
  await server.site('bay'); // one good answer does not make it whole
  await vi.advanceTimersByTimeAsync(31_000);
  expect(server.link.is).toBe('gone');
  expect(told.filter((what) => what === 'server').length).toBe(1);
});

test('ALongAnswerIsNoDeadServer', async () => {
  const { server } = made_up({ '/sites': sites('a'), '/sites/bay/plan': 'silent' });
  await server.watch();
  const coming = expect(server.get('/sites/bay/plan')).rejects.toMatchObject({
    detail: 'The server gave no answer within 180 s.',
  });
  await vi.advanceTimersByTimeAsync(181_000);
  await coming;
  expect(server.link.is).toBe('there');
});

test('AnotherForecastInForceMakesAllAnswersOld', async () => {
  const answers: Record<string, Answer> = { '/sites': sites('a'), '/sites/bay': { body: 1 } };
  const { server, told, asked } = made_up(answers);
  await server.watch();
  await server.site('bay');
  answers['/sites'] = sites('b');
  await vi.advanceTimersByTimeAsync(31_000);
  expect(told).toContain('forecast');
  await server.site('bay');
  expect(asked.filter((path) => path === '/sites/bay').length).toBe(2);
});

test('AnotherForecastElsewhereIsNotToldButMakesAnswersOld', async () => {
  const of = (bay: string, cove: string): Answer => ({
    body: {
      now: '2025-03-13T06:00:00Z',
      sites: [
        { id: 'bay', forecast: { instance: bay } },
        { id: 'cove', forecast: { instance: cove } },
      ],
    },
  });
  const answers: Record<string, Answer> = { '/sites': of('a', 'a'), '/sites/cove': { body: 1 } };
  const { server, told, asked } = made_up(answers);
  await server.watch();
  await server.site('cove');
  answers['/sites'] = of('a', 'b');
  await vi.advanceTimersByTimeAsync(31_000);
  expect(told).not.toContain('forecast');
  await server.site('cove');
  expect(asked.filter((path) => path === '/sites/cove').length).toBe(2);
});

test('AnAnswerIsKeptForAMinuteAndSixtyFourAtMost', async () => {
  const { server, asked } = made_up({ '/sites/bay': { body: { id: 'bay' } } });
  const count = (): number => asked.filter((path) => path === '/sites/bay').length;
  await server.site('bay');
  await vi.advanceTimersByTimeAsync(59_000);
  await server.site('bay');
  expect(count()).toBe(1);
  await vi.advanceTimersByTimeAsync(2_000);
  await server.site('bay');
  expect(count()).toBe(2);
  for (let i = 0; i < 64; i += 1) await server.get(`/sites/bay?${i}`);
  await server.site('bay');
  expect(count()).toBe(3);
});

test('TheServersClockRules', async () => {
  const { server } = made_up({ '/sites': sites('a') });
  await server.watch();
  await vi.advanceTimersByTimeAsync(5_000);
  expect(server.now_ms()).toBe(Date.parse('2025-03-13T06:00:05Z'));
});

const SITE = whole_site({ id: 'bay', hub_height_m: 90 });
const FORECAST = {
  instance: 'a',
  day: '2025-03-12',
  issued: '2025-03-13T05:00:00Z',
  valid_from: '2025-03-13T00:00:00Z',
  valid_to: '2025-03-16T00:00:00Z',
  age_s: 0,
  degraded: false,
  headline: '',
};
const PLACE = { longitude_deg: -2.55, latitude_deg: 48.85 };

test('AtAPlaceEachAnswerStandsForItself', async () => {
  const coverage = {
    type: 'Coverage',
    domain: {
      axes: { t: { values: ['2025-03-13T00:00:00Z'] }, x: { values: [0] }, y: { values: [0] } },
    },
    ranges: { wind_speed: { shape: [1], axisNames: ['t'], values: [9] } },
  };
  const { server, asked } = made_up({
    '/collections': { body: { collections: [{ id: 'currents' }] } },
    '/collections/wind/position': { body: coverage },
    '/collections/waves/position': { body: { type: 'CoverageCollection', coverages: [] } },
  });
  const water = await fetch_water(server, SITE, FORECAST, PLACE);
  expect(water.currents).toEqual({ column: null, refused: 'found no such thing' });
  expect(water.wind.column?.values.wind_speed).toEqual([9]);
  expect(water.waves.refused).toBe('The server has no values here.');
  expect(water.tide).toEqual({ column: null, refused: NO_TIDE });
  expect(said_by_all(water)).toBeNull();
  expect(asked.find((path) => path.includes('/wind/'))).toContain('z=10%2C90');
});

test('APlaceOutOfReachIsSaidOnce', async () => {
  const { server } = made_up({ '/collections': { body: { collections: [] } } });
  const water = await fetch_water(server, SITE, FORECAST, PLACE);
  expect(said_by_all(water)).toBe('found no such thing');
});
