// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { box_of_words, overlaps, place_labels } from 'page/map/labels';
import { vessels_layer, type VesselsLayer } from 'page/map/vessels_layer';
import { vessel_sign } from 'page/map/vessel_signs';
import { short_span, title_of } from 'page/map/vessel_words';
import { projection_of } from 'page/map/projection';
import type { Traffic, Vessel } from 'page/server/traffic';
import type { ViewValues } from 'page/view';
import { late_server, NOW, TIMES, two_sites, type LateServer } from './late';

const PLACE = { longitude_deg: -2.55, latitude_deg: 48.85 };
const PAST = {
  turbine: null,
  passing: 'past',
  cpa_m: 700,
  tcpa_s: -300,
  in_words: 'goes away, past at 700 m from the site 5 min ago',
} as const;
const vessel = (mmsi: number, more: Partial<Vessel> = {}): Vessel => ({
  ...PLACE,
  mmsi,
  name: `SHIP ${mmsi}`,
  class: 'A',
  kind: 'cargo ship',
  length_m: 90,
  state: 'fresh',
  reported: { ...PLACE, time: NOW },
  age_s: 20,
  dead_reckoned: true,
  speed_m_s: 5,
  to_direction_deg: 90,
  heading_deg: null,
  distance_m: 2300,
  bearing_deg: 270,
  ahead: { longitude_deg: -2.52, latitude_deg: 48.85 },
  to_site: PAST,
  to_turbine: null,
  told: PAST,
  alarm: null,
  ...more,
});
const NEAR = {
  turbine: 'A01',
  passing: 'closing',
  cpa_m: 210,
  tcpa_s: 720,
  in_words: 'passes 210 m from A01 in 12 min',
} as const;
const MARKED = { to_turbine: NEAR, told: NEAR, alarm: 'closing' } as const;
const OLD: Partial<Vessel> = {
  told: null,
  state: 'old',
  age_s: 2520,
  dead_reckoned: false,
  ahead: null,
  to_site: null,
};

const told = (vessels: Vessel[], more: Partial<Traffic> = {}): Traffic => ({
  site: 'a',
  at: NOW,
  in_words: `${vessels.length} vessels within 50.0 km.`,
  sources: [{ file: 'live.nmea', trouble: null }],
  last_heard: '2025-03-13T05:59:50Z',
  limits: { cpa_m: 500, tcpa_s: 1800 },
  rule: { reach_m: 50_000, shown_s: 3600, way_s: 360 },
  vessels,
  too_old: 0,
  left_out: 0,
  ...more,
});

const CAMERA = { ...PLACE, zoom: 12 };
const TO = projection_of(CAMERA, { width: 600, height: 400 });
const BOX = { west: -2.65, south: 48.8, east: -2.45, north: 48.9 };

let layer: VesselsLayer;
let gone_to: unknown = null;
const start = (values: Partial<ViewValues> = {}): LateServer => {
  vi.useFakeTimers({ now: Date.parse(NOW), toFake: ['Date', 'setInterval'] });
  const late = late_server(two_sites(), {}, { site: 'a', ...values });
  layer = vessels_layer(late.desk, (place) => (gone_to = place), 0);
  layer.draw({ to: TO, box: BOX, is_shown: true, with_names: true, taken: () => [] });
  document.body.replaceChildren(layer.list, layer.says);
  return late;
};
const soon = (): Promise<void> => new Promise((over) => setTimeout(over, 5));
const list_text = (): string => layer.list.textContent ?? '';
const signs = (kind: string): number => layer.node.querySelectorAll(kind).length;

beforeEach(() => {
  gone_to = null;
});
afterEach(() => {
  vi.useRealTimers();
});

test('FreshOldAndMarkedVesselsDifferByShape', () => {
  const shape = (more: Partial<Vessel>): string => {
    const sign = vessel_sign(vessel(1, more));
    return [...sign.querySelectorAll('*')].map((it) => it.getAttribute('d') ?? 'o').join('|');
  };
  expect(shape(MARKED)).not.toBe(shape({}));
  expect(shape({ to_direction_deg: null })).not.toBe(shape({})); // no bow: nobody knows where
  expect(vessel_sign(vessel(1, OLD)).getAttribute('class')).toBe('vessel old');
  const turned = vessel_sign(vessel(1, { heading_deg: 123 })).querySelector('.hull');
  expect(turned?.getAttribute('transform')).toContain('rotate(123)');
  const over_ground = vessel_sign(vessel(1)).querySelector('.hull');
  expect(over_ground?.getAttribute('transform')).toContain('rotate(90)');
});

test('TheMapShowsWhatTheServerTellsAndTheListSaysItInWords', async () => {
  const { answer } = start();
  await soon();
  await answer('/sites/a/traffic', told([vessel(1, MARKED), vessel(2), vessel(3, OLD)]));
  expect(signs('.vessel')).toBe(3);
  expect(signs('.vessel.old')).toBe(1);
  expect(signs('.vessel.marked')).toBe(1);
  expect(signs('.vessel-way')).toBe(2);
  const rows = [...layer.list.querySelectorAll('tbody tr')].map((row) =>
    [...row.children].map((cell) => cell.textContent),
  );
  expect(rows[0]).toEqual([
    'SHIP 1',
    '210 m from A01',
    'in 12 min',
    '! nearer than 500 m within 30 min',
    '5.0 m/s to 090°',
    '2300 m, 270° of it',
    'cargo ship, 90 m',
    '20 s before, carried on',
  ]);
  expect(rows[1]?.slice(1, 4)).toEqual(['700 m from the site', 'past, 5 min ago', '']);
  expect(rows[2]?.slice(1, 4)).toEqual(['not told: old', '–', '']);
  expect(rows[2]?.[7]).toBe('42 min before, old');
  expect(layer.list.querySelector('summary')?.textContent).toContain('3, 1 marked');
  expect(layer.says.hidden).toBe(true);
});

test('UnitsAreTheReadersAndAPressOnANameShowsIt', async () => {
  const { desk, answer } = start({ speed: 'knots', directions: 'compass' });
  await soon();
  await answer('/traffic', told([vessel(1)]));
  expect(list_text()).toContain('9.7 kn to E');
  desk.view.set({ speed: 'm/s' });
  expect(list_text()).toContain('5.0 m/s to E');
  layer.list.querySelector<HTMLButtonElement>('tbody button')?.click();
  expect(gone_to).toEqual(PLACE);
  expect(signs('.chosen')).toBe(1);
});

test('WithoutALogItSaysOnceWhatToDoAndIsQuiet', async () => {
  const { desk, answer, waiting } = start();
  await soon();
  const words = 'No log of AIS is given. Start slackwater serve with --ais FILE to see vessels.';
  await answer('/traffic', told([], { sources: [], in_words: words, last_heard: null }));
  expect(list_text().split('--ais').length).toBe(2);
  expect(layer.list.querySelector('summary')?.textContent).toBe('Vessels: no AIS log is given');
  expect(layer.says.hidden).toBe(true);
  desk.view.tell(new Set(['sites']));
  desk.view.set({ at_ms: Date.parse(TIMES[1] ?? '') }); // the slider stays without a question
  await soon();
  expect(waiting).toEqual([]);
  expect(list_text()).toContain('--ais');
});

test('NothingIsAskedBeforeTheServerHasToldItsClock', async () => {
  const { desk, waiting } = start();
  await soon();
  waiting.length = 0;
  const early = late_server(two_sites(), {}, { site: 'a' });
  early.desk.server.heard_ms = null;
  vessels_layer(early.desk, () => undefined, 0);
  await soon();
  expect(early.waiting).toEqual([]);
  early.desk.server.heard_ms = desk.server.heard_ms;
  early.desk.view.tell(new Set(['sites']));
  await soon();
  expect(early.waiting.map(({ path }) => path)).toEqual([`/sites/a/traffic?at=${NOW}`]);
});

test('ABrokenLogIsSaidOnTheMapWithWhenVesselsWereHeardLast', async () => {
  const { answer } = start();
  await soon();
  const trouble = 'The log live.nmea is not there; it is looked for every second.';
  await answer('/traffic', told([vessel(3, OLD)], { sources: [{ file: 'live.nmea', trouble }] }));
  expect(layer.says.hidden).toBe(false);
  expect(layer.says.textContent).toBe(
    `${trouble} The receiver last heard something at Thu 13 Mar 05:59 UTC, 10 s before.`,
  );
});

test('AnHourAfterNowSaysThatNothingIsForecastAndOneBeforeAsksForThatHour', async () => {
  const { desk, waiting, answer } = start({ at_ms: Date.parse(TIMES[1] ?? '') });
  await soon();
  expect(waiting.map(({ path }) => path)).toEqual([`/sites/a/traffic?at=${TIMES[1] ?? ''}`]);
  await answer('/traffic', told([], { at: TIMES[1] ?? '' }));
  expect(layer.says.textContent).toBe('Vessels are not forecast: this hour is after now.');
  desk.view.set({ at_ms: Date.parse(TIMES[0] ?? '') });
  await soon();
  await answer(`at=${TIMES[0] ?? ''}`, told([vessel(1)]));
  expect(layer.says.hidden).toBe(true);
  expect(signs('.vessel')).toBe(1);
});

test('AnAnswerThatComesLateIsNotShownAtAnotherHourOrSite', async () => {
  const { desk, answer } = start();
  await soon();
  desk.view.set({ site: 'b' });
  await soon();
  await answer('/sites/a/traffic', told([vessel(1)]));
  expect(signs('.vessel')).toBe(0);
  await answer('/sites/b/traffic', told([vessel(2), vessel(3)], { site: 'b' }));
  expect(signs('.vessel')).toBe(2);
  desk.view.set({ at_ms: Date.parse(TIMES[1] ?? '') });
  expect(signs('.vessel')).toBe(0); // at once: it is another hour
});

test('ARefusalLeavesNoVesselOfBefore', async () => {
  const { desk, answer } = start();
  await soon();
  await answer('/traffic', told([vessel(1)]));
  desk.view.tell(new Set(['server']));
  desk.server.forget();
  await soon();
  await answer('/traffic', { title: 'x', detail: 'the rule cannot be read' }, 500);
  expect(signs('.vessel')).toBe(0);
  expect(list_text()).toContain('the rule cannot be read');
});

test('HostileNamesAreTextOnly', async () => {
  const { answer } = start();
  await soon();
  const names = ['<img src=x onerror=1>', '"&<>\'/ABCDEFGHIJKLMN', 'WWWWWWWWWWWWWWWWWWWW'];
  await answer('/traffic', told(names.map((name, i) => vessel(i + 1, { name }))));
  expect(document.querySelector('img')).toBeNull();
  expect(layer.node.querySelector('img')).toBeNull();
  for (const name of names) expect(list_text()).toContain(name);
});

test('TheFocusOfTheKeyboardStaysOnItsVesselWhenTheOrderChanges', async () => {
  const { desk, answer } = start();
  await soon();
  await answer('/traffic', told([vessel(1), vessel(2)]));
  const second = layer.list.querySelectorAll<HTMLButtonElement>('tbody button')[1];
  second?.focus();
  desk.server.forget();
  desk.view.tell(new Set(['server']));
  await soon();
  await answer('/traffic', told([vessel(2), vessel(1)]));
  expect(document.activeElement).toBe(second);
  expect(layer.list.querySelectorAll('tbody button')[0]).toBe(second);
});

test('NamesDoNotLieOverEachOtherAndTheFirstHasItsPlace', () => {
  const labels = Array.from({ length: 40 }, (_, i) => ({
    at: [100 + 3 * i, 100 + 2 * i] as [number, number],
    half: 12,
    words: `A SHIP WITH NUMBER ${i}`,
  }));
  const column = { left: 110, right: 180, top: 90, bottom: 110 };
  const placed = place_labels(labels, [column]);
  expect(placed.length).toBeGreaterThan(3);
  expect(placed[0]?.words).toBe('A SHIP WITH NUMBER 0');
  const boxes = placed.map(({ at, anchor, words }) => box_of_words(at, anchor, words));
  for (const [i, box] of boxes.entries()) {
    expect(overlaps(box, column)).toBe(false);
    for (const other of boxes.slice(i + 1)) expect(overlaps(box, other)).toBe(false);
  }
});

test('WhatStandsUnderThePointerHasTheServersWordsAndTheLimit', () => {
  const { look } = late_server(two_sites(), {}, { site: 'a' }).desk;
  const lines = title_of(vessel(1, MARKED), told([]), look).split('\n');
  expect(lines[0]).toBe('SHIP 1');
  expect(lines.at(-1)).toBe('passes 210 m from A01 in 12 min: nearer than 500 m within 30 min');
  expect(title_of(vessel(1), told([]), look)).toContain('past at 700 m from the site 5 min ago');
  expect(title_of(vessel(1, OLD), told([]), look)).toContain('no closest approach');
  expect(short_span(7500)).toBe('2 h 5 min');
});
