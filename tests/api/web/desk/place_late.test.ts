// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { placePart } from 'page/place/place';
import { coverage, late_server, site_answer, two_sites } from './late';

const slack = (hour: number): unknown => ({
  depth_m: 5,
  below_m_s: 0.5,
  why_none: null,
  slack: [
    {
      from: `2025-03-13T${hour}:00:00Z`,
      to: `2025-03-13T${hour}:30:00Z`,
      begins_before: false,
      ends_after: false,
      sure_from: null,
      sure_to: null,
    },
  ],
});
const KEPT = {
  '/collections/currents/position?coords=POINT(1 51)': coverage('b', 0.99),
  '/collections/wind/position?coords=POINT(1 51)': coverage('b', 9.9),
  '/collections/waves/position?coords=POINT(1 51)': coverage('b', 1.9),
  '/collections/currents/position?coords=POINT(-2.55 48.85)': coverage('a', 0.11),
  '/collections/wind/position?coords=POINT(-2.55 48.85)': coverage('a', 1.1),
  '/collections/waves/position?coords=POINT(-2.55 48.85)': coverage('a', 0.1),
  '/collections': { collections: [] },
  '/sites/b/slack': slack(12),
};

test('NoNumberStandsUnderTheNameOfAnotherSite', async () => {
  const kept: Record<string, unknown> = { ...KEPT, '/sites/b': site_answer('b') };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'b' });
  const node = placePart(desk);
  document.body.replaceChildren(node);
  const says = (where: string): string => node.querySelector(where)?.textContent ?? '';
  await new Promise((over) => setTimeout(over, 20));
  expect(says('h2')).toContain('B01');
  expect(says('.facts')).toContain('0.99 m/s');
  expect(says('.slack')).toContain('12:00');

  desk.view.set({ site: 'a' });
  expect([says('h2'), says('.facts'), says('.slack')]).toEqual(['', '', '']);
  desk.view.set({ site: 'b' });
  await new Promise((over) => setTimeout(over, 20));
  await answer('/sites/a', site_answer('a')); // too late
  expect(says('h2')).toContain('B01');
  expect(says('.facts')).toContain('0.99 m/s');
  expect(says('.slack')).toContain('12:00');
});

test('AnotherPlaceOfTheSiteHasNoNumbersUntilTheyCome', async () => {
  const kept: Record<string, unknown> = { ...KEPT, '/sites/b': site_answer('b') };
  const { desk } = late_server(two_sites(), kept, { site: 'b' });
  const node = placePart(desk);
  document.body.replaceChildren(node);
  await new Promise((over) => setTimeout(over, 20));
  expect(node.querySelector('.facts')?.textContent).toContain('0.99 m/s');
  desk.view.set({ place: { longitude_deg: 2, latitude_deg: 52 } });
  expect(node.querySelector('h2')?.textContent).toBe('52.0000 N 2.0000 E');
  expect(node.querySelector('.facts')?.textContent).toBe('');
});
