import { expect, test } from 'vitest';
import { first_view, hash_of, read_hash, View, type Changed, type ViewValues } from 'page/view';

const FULL: ViewValues = {
  site: 'saint_brieuc',
  at_ms: Date.UTC(2025, 2, 14, 6),
  depth_m: 12.5,
  place: { longitude_deg: -2.5405, latitude_deg: 48.8509 },
  panel: 'what_if',
  map: { longitude_deg: -2.6, latitude_deg: 48.7, zoom: 9.25 },
  cells: 'product-of_somebody/x',
  palette: 'night',
  speed: 'knots',
  clock: 'site',
  directions: 'compass',
};

test('ALinkReproducesTheView', () => {
  expect(read_hash(hash_of(FULL), first_view())).toEqual(FULL);
  expect(read_hash(hash_of(first_view()), FULL)).toMatchObject({ panel: 'decide', depth_m: 5 });
  expect(hash_of(FULL)).toContain('at=2025-03-14T06:00:00Z');
});

test('OfALinkOnlyWhatIsSoundIsTaken', () => {
  const otherwise = first_view();
  const of = (hash: string): ViewValues => read_hash(hash, otherwise);
  expect(of('#at=yesterday&depth=-3&place=95,7&panel=x&map=1,2&palette=red')).toEqual(otherwise);
  expect(of('#place=48.85,')).toEqual(otherwise);
  expect(of('#%E0%A4%A')).toEqual(otherwise);
  expect(of('')).toEqual(otherwise);
});

test('ASiteWithAnOddNameIsKept', () => {
  const view = { ...first_view(), site: 'a&b=c #1' };
  expect(read_hash(hash_of(view), first_view()).site).toBe('a&b=c #1');
});

test('OnlyWhatChangedIsTold', () => {
  const view = new View(first_view());
  const told: Changed[] = [];
  view.listen((changed) => told.push(changed));
  view.set({ depth_m: 5, place: null });
  expect(told).toEqual([]);
  view.set({ depth_m: 10, panel: 'place' });
  expect(told).toEqual([new Set(['depth_m', 'panel'])]);
  view.set({ place: { longitude_deg: 1, latitude_deg: 2 } });
  view.set({ place: { longitude_deg: 1, latitude_deg: 2 } });
  expect(told.length).toBe(2);
});
