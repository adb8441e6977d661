// @vitest-environment happy-dom
import { geoMercator } from 'd3-geo';
import { expect, test } from 'vitest';
import { draw_trial } from 'page/map/trial_signs';
import { ring_around } from 'page/trial';
import { Draft } from 'page/what_if/draft';
import { whatIfPart } from 'page/what_if/what_if';
import { late_server, site_answer, two_sites } from './late';

const SITE = `id: bay   # the bay
turbines:
  - {id: A01, latitude_deg: 48.85, longitude_deg: -2.55}   # the first
  - id: NEW1
    latitude_deg: 48.86
    longitude_deg: -2.54
areas:
  - {id: terns, kind: exclusion, polygon: [{latitude_deg: 1, longitude_deg: 2}]}
tasks: [scan]
`;
const HERE = { longitude_deg: -2.5512345, latitude_deg: 48.8412345 };
const draft = (site = SITE): Draft => new Draft({ site, tasks: {}, plan: null });

test('AMovedTurbineIsTheOnlyChangeInTheText', () => {
  const made = draft();
  expect(made.trial).toEqual({ turbines: [], zones: [] });
  made.move_turbine('A01', HERE);
  expect(made.changed.site).toBe(
    SITE.replace('48.85,', '48.84123,').replace('-2.55}', '-2.55123}'),
  );
  expect(made.trial.turbines).toEqual([
    { id: 'A01', place: { longitude_deg: -2.55123, latitude_deg: 48.84123 }, is_new: false },
  ]);
  expect(made.touched).toBeNull(); // any task may answer otherwise
  made.move_turbine('A01', { longitude_deg: -2.55, latitude_deg: 48.85 });
  expect(made.trial.turbines).toEqual([]); // back where it stood
  made.move_turbine('nobody', HERE);
  expect(made.trial.turbines).toEqual([]);
});

test('ANewTurbineHasAnIdThatNobodyHas', () => {
  const made = draft();
  expect([made.add_turbine(HERE), made.add_turbine(HERE)]).toEqual(['NEW2', 'NEW3']);
  expect(made.turbines.map(({ id }) => id)).toEqual(['A01', 'NEW1', 'NEW2', 'NEW3']);
  expect(made.trial.turbines.map(({ is_new }) => is_new)).toEqual([true, true]);
  expect(made.changed.site).toContain('# the first');
  const bare = draft('id: bay\n');
  bare.add_turbine(HERE);
  bare.add_zone(HERE, 100);
  expect(bare.trial.turbines.length).toBe(1);
  expect(bare.trial.zones.length).toBe(1);
});

test('AZoneIsARingOfItsRadius', () => {
  const made = draft();
  made.add_zone(HERE, 500);
  const [zone] = made.trial.zones;
  expect(zone?.id).toBe('trial1');
  for (const [longitude, latitude] of zone?.ring ?? []) {
    const north = (latitude - HERE.latitude_deg) * 111_195;
    const turn = (HERE.latitude_deg * Math.PI) / 180;
    const east = (longitude - HERE.longitude_deg) * 111_195 * Math.cos(turn);
    expect(Math.abs(Math.hypot(north, east) - 500)).toBeLessThan(1); // five digits
  }
  expect(new Set(ring_around(HERE, 500).map(String)).size).toBe(24);
  expect(made.trial.zones.length).toBe(1); // those of the site are true
});

test('OnTrialIsDrawnAsSuchInWords', () => {
  const at = document.createElementNS('http://www.w3.org/2000/svg', 'g');
  const made = draft();
  made.move_turbine('A01', HERE);
  made.add_zone(HERE, 500);
  draw_trial(at, made.trial, geoMercator());
  expect([...at.querySelectorAll('text')].map((it) => it.textContent)).toEqual(['A01, on trial']);
  expect(at.querySelector('path.trial title')?.textContent).toContain('keep out, on trial');
});

test('ATurbineIsMovedToThePlaceThatIsChosenAndTheServerIsAsked', async () => {
  const kept = {
    '/texts': { site: SITE, tasks: { scan: 'id: scan\n' }, plan: null },
    '/windows': { tasks: [] },
    '/plan': {},
  };
  const { desk, waiting, answer } = late_server(two_sites(), kept, { site: 'a' });
  const part = whatIfPart(desk);
  await answer('/sites/a', site_answer('a'));
  const settled = (): Promise<void> => new Promise((over) => setTimeout(over, 400));
  await settled();
  const press = (words: string): void =>
    [...part.querySelectorAll('button')].find((it) => it.textContent === words)?.click();
  const move = [...part.querySelectorAll('button')].find((it) => it.textContent === 'Move it here');
  expect(move?.disabled).toBe(true); // no place is chosen
  desk.view.set({ place: HERE });
  expect(move?.disabled).toBe(false);
  press('Move it here');
  expect(desk.view.trial.turbines.map(({ id }) => id)).toEqual(['A01']);
  await settled();
  const question = waiting.find(({ path }) => path.includes('what-if'));
  expect(question?.sent).toContain('48.84123');
  await answer('what-if', { title: 'no' }, 500);
  press('Add a turbine here');
  const choices = [...part.querySelectorAll('option')].map((it) => it.value);
  expect(choices.filter((id) => id === 'NEW2').length).toBe(2); // to move, and to ask about
  press('Back to what is true');
  expect(desk.view.trial.turbines).toEqual([]);
});
