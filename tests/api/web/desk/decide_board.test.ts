// @vitest-environment happy-dom
import { afterEach, expect, test, vi } from 'vitest';
import { Board } from 'page/decide/board';
import { counts_text, worst_first, type BoardSite } from 'page/decide/board_order';
import { OneByOne } from 'page/decide/one_by_one';
import type { Desk } from 'page/look/desk';
import { Look } from 'page/look/look';
import type { SiteInSites, SiteStatus } from 'page/server/answers';
import { Refused } from 'page/server/server';
import { first_view, View } from 'page/view';
import { report } from './decide_made';
import { late_server, two_sites } from './late';

afterEach(() => vi.useRealTimers());

function site(id: string, status: SiteStatus = 'ok'): SiteInSites {
  return {
    id,
    name: `Site ${id}`,
    place: { longitude_deg: 0, latitude_deg: 50 },
    time_zone: null,
    status,
    in_words: `words of ${id}`,
    forecast: null,
    report: `/sites/${id}/report`,
    report_page: null,
  };
}
const there = (today: 'go' | 'no-go' | null, next: 'go' | 'marginal'): BoardSite['report'] => ({
  is: 'there',
  today,
  next,
  headline: '',
});

test('TheWorstIsFirst', () => {
  const sites: BoardSite[] = [
    { site: site('a'), report: there('go', 'go') },
    { site: site('b', 'stale'), report: there('go', 'go') },
    { site: site('c'), report: there('no-go', 'go') },
    { site: site('d', 'unreadable'), report: { is: 'refused', why: '' } },
    { site: site('e'), report: there(null, 'marginal') },
    { site: site('f'), report: { is: 'waiting' } },
    { site: site('g', 'degraded'), report: { is: 'waiting' } },
    { site: site('h'), report: { is: 'refused', why: '' } },
  ];
  expect(
    worst_first(sites)
      .map((it) => it.site.id)
      .join(''),
  ).toBe('dbghceaf');
});

test('SitesAreCountedByHowTheirForecastsAre', () => {
  expect(counts_text([site('a'), site('b', 'stale')])).toBe('2 sites: 1 old, 1 in force');
  expect(counts_text([])).toBe('0 sites');
});

test('ReportsAreAskedForOneByOne', async () => {
  let running = 0;
  let most = 0;
  const done: number[] = [];
  const queue = new OneByOne<number>(async (what) => {
    running += 1;
    most = Math.max(most, running);
    await Promise.resolve();
    running -= 1;
    done.push(what);
  });
  queue.add([1, 2, 3]);
  queue.add([3, 4]);
  await new Promise((over) => setTimeout(over, 5));
  expect([most, done]).toEqual([1, [1, 2, 3, 4]]);
});

function desk_of(sites: SiteInSites[], asked: string[]): Desk {
  const view = new View({ ...first_view(), site: 's1' });
  const server = {
    sites: { now: '', stale_after_s: 0, trouble: '', sites },
    get: (path: string) => {
      asked.push(path);
      if (path.includes('s3/')) return Promise.reject(new Refused(503, 'the file is cut off'));
      return Promise.resolve(report({ verdict: 'go' }));
    },
  };
  return { view, server, look: new Look(view), onChange: () => {} } as unknown as Desk;
}

test('AHundredSitesAreAskedForOnlyOnceSomebodyLooks', async () => {
  const asked: string[] = [];
  const sites = Array.from({ length: 100 }, (_, i) => site(`s${i}`, i === 7 ? 'stale' : 'ok'));
  const board = new Board(desk_of(sites, asked));
  document.body.append(board.node);
  board.show();
  expect(asked).toEqual([]);
  const details = board.node.querySelector('details') as HTMLDetailsElement;
  expect(details.querySelector('summary')?.textContent).toBe(
    'All sites: 100 sites: 1 old, 99 in force',
  );
  details.open = true;
  details.dispatchEvent(new Event('toggle'));
  await new Promise((over) => setTimeout(over, 50));
  expect(asked.length).toBe(100);
  expect(asked[0]).toBe('/sites/s7/report');
  const bodies = [...board.node.querySelectorAll('tbody')];
  expect(bodies.length).toBe(100);
  // What to do is the server's to say, once.
  expect(bodies[0]?.textContent?.match(/words of s7/g)?.length).toBe(1);
  expect(bodies[0]?.textContent).not.toContain('slackwater forecast');
  expect(bodies[1]?.textContent).toContain('the file is cut off');
  const search = board.node.querySelector('input') as HTMLInputElement;
  search.value = 's42';
  search.dispatchEvent(new Event('input'));
  expect(bodies.filter(({ hidden }) => !hidden).length).toBe(1);
});

function opened_board(desk: Desk): Board {
  const board = new Board(desk);
  document.body.replaceChildren(board.node);
  board.show();
  const details = board.node.querySelector('details') as HTMLDetailsElement;
  details.open = true;
  details.dispatchEvent(new Event('toggle'));
  return board;
}

test('AVerdictIsAskedForAgainAfterTenMinutesAndARefusalAfterOne', async () => {
  vi.useFakeTimers();
  const asked: string[] = [];
  const board = opened_board(desk_of([site('s1'), site('s3')], asked));
  const after = async (ms: number): Promise<string[]> => {
    asked.length = 0;
    await vi.advanceTimersByTimeAsync(ms);
    board.show();
    await vi.advanceTimersByTimeAsync(0);
    return [...asked];
  };
  await vi.advanceTimersByTimeAsync(0);
  expect(asked).toEqual(['/sites/s1/report', '/sites/s3/report']);
  expect(await after(30_000)).toEqual([]);
  expect(await after(31_000)).toEqual(['/sites/s3/report']);
  expect(await after(9 * 60_000)).toEqual(['/sites/s3/report', '/sites/s1/report']);
});

test('WhatIsSaidOfAnOldForecastDoesNotLandAtTheNewOne', async () => {
  const { desk, answer, waiting } = late_server(two_sites(), {}, { site: 'a' });
  const board = opened_board(desk);
  const sites = two_sites();
  const [a] = sites.sites;
  if (a?.forecast) a.forecast = { ...a.forecast, instance: 'i2' };
  const old = waiting[0];
  void desk.server.watch();
  await waiting[1]?.answer(sites);
  board.show();
  await old?.answer(report({ headline: 'of the old one' }));
  await answer('/sites/b/report', report({ headline: 'of b' }));
  expect(board.node.textContent).toContain('of b');
  expect(board.node.textContent).not.toContain('of the old one');
  expect(waiting.map(({ path }) => path)).toEqual(['/sites/a/report']);
});
