import { expect, test } from 'vitest';
import { Draft } from 'page/what_if/draft';
import { changed_files, command_lines } from 'page/what_if/files';
import { limit_words, limits_of } from 'page/what_if/limits';
import { with_exchanged, with_value } from 'page/what_if/yaml_text';

const SHEET = `# A sheet of somebody's own
id: scour
agents:
  - role: surveyor
    conduct:
      limits:                                   # rov_inspection
        - {significant_wave_height_m: 1.5, source: estimate}   # from the maker
        - {current_speed_m_s: 0.5, phases: [transit, work], at_depth_m: 2}
        - {table: {peak_period_s: [5, 9]}}
        - {least_visibility_m: 500, if_missing: not_checked}
`;
const SITE = `id: bay   # the bay
shift: 06:00-18:00   # summer
tasks: [scour, blade, clean]
`;
const PLAN = `name: One boat
crews:
  - {id: blue, shift: 05:00-17:00}   # Jo and Sam
tasks:
  - {task: scour, turbines: [A01], priority: 2}   # the client waits
  - {task: blade, turbines: [A01, A02], priority: 3}
  - {task: clean, turbines: [B01]}
`;
const draft = (plan: string | null = PLAN): Draft =>
  new Draft({ site: SITE, tasks: { scour: SHEET }, plan });

test('TheLimitsOfASheetAreFoundWithTheirPlaces', () => {
  expect(
    limits_of(SHEET).map((it) => [it.role, it.variable, it.value, it.phases, it.at_depth_m]),
  ).toEqual([
    ['surveyor', 'significant_wave_height_m', 1.5, [], null],
    ['surveyor', 'current_speed_m_s', 0.5, ['transit', 'work'], 2],
    ['surveyor', 'least_visibility_m', 500, [], null],
  ]);
  expect(limits_of('id: none\n')).toEqual([]);
  expect(limits_of('')).toEqual([]);
  const where_first = 'limits: [{at_depth_m: 3, current_speed_m_s: 0.4}]\n';
  expect(limits_of(where_first)).toMatchObject([{ variable: 'current_speed_m_s', at_depth_m: 3 }]);
  expect(limits_of('limits: [{wind_speed_10m_m_s: 12}]\n')[0]?.path).toEqual([
    'limits',
    0,
    'wind_speed_10m_m_s',
  ]);
});

test('AVariableIsReadInWords', () => {
  expect(limit_words('wind_speed_10m_m_s')).toEqual({
    name: 'wind speed at 10 m at most',
    unit: 'm/s',
  });
  expect(limit_words('least_visibility_m')).toEqual({ name: 'visibility at least', unit: 'm' });
  expect(limit_words('rain_mm_h')).toEqual({ name: 'rain at most', unit: 'mm/h' });
});

test('AChangeTouchesItsOwnCharactersAlone', () => {
  const changed = draft();
  const limit = limits_of(SHEET)[0];
  changed.set_limit('scour', limit?.path ?? [], 2.25);
  expect(changed.changed).toEqual({ tasks: { scour: SHEET.replace('1.5', '2.25') } });
  changed.set_limit('scour', limit?.path ?? [], 1.5);
  expect(changed.changed).toEqual({});
  expect(changed.is_changed).toBe(false);
});

test('AShiftIsChangedOrAdded', () => {
  const changed = draft();
  changed.shift = '07:00-19:00';
  changed.set_crew_shift(0, '04:00-16:00');
  expect(changed.changed.site).toBe(SITE.replace('06:00-18:00', '07:00-19:00'));
  expect(changed.changed.plan).toBe(PLAN.replace('05:00-17:00', '04:00-16:00'));
  const added = with_value('id: bay   # the bay\n', ['shift'], '07:00-19:00');
  expect(added).toContain('# the bay');
  expect(added).toContain('shift: 07:00-19:00');
});

test('AJobMovesUpByItsPriority', () => {
  const changed = draft();
  const order = (): string =>
    changed.plan_tasks.map(({ task, priority }) => task + priority).join();
  expect(order()).toBe('blade3,scour2,clean1');
  changed.move_up(1);
  expect(order()).toBe('scour3,blade2,clean1');
  expect(changed.changed.plan).toContain('# the client waits');
  changed.move_up(2);
  expect(order()).toBe('scour3,clean2,blade1');
  changed.move_up(0);
  changed.move_up(9);
  expect(order()).toBe('scour3,clean2,blade1');
});

test('EqualPrioritiesAreToldApart', () => {
  const equal = new Draft({
    site: SITE,
    tasks: {},
    plan: 'tasks:\n  - {task: a, priority: 2}\n  - {task: b, priority: 2}\n',
  });
  equal.move_up(1);
  expect(equal.plan_tasks.map(({ task, priority }) => task + priority)).toEqual(['b3', 'a2']);
});

test('WithoutAPlanTheSitesOwnOrderChanges', () => {
  const changed = draft(null);
  expect([changed.crews, changed.plan_tasks]).toEqual([[], []]);
  changed.move_site_task_up(2);
  expect(changed.changed).toEqual({
    site: SITE.replace('[scour, blade, clean]', '[scour, clean, blade]'),
  });
  changed.move_site_task_up(0);
  expect(changed.site_tasks).toEqual(['scour', 'clean', 'blade']);
  expect(with_exchanged(SITE, ['tasks'], 0, 7)).toBe(SITE);
});

test('HoursAndTurbineAreAskedAndChangeNoFile', () => {
  const changed = draft();
  changed.asked = { turbine: 'A02', from: '2025-03-14T06:00:00Z', to: '' };
  expect(changed.changed).toEqual({});
  expect(changed.query()).toBe('from=2025-03-14T06%3A00%3A00Z&turbine=A02');
  expect(changed.hours).toBe('from=2025-03-14T06%3A00%3A00Z');
});

test('OnlyWhatIsTouchedIsAsked', () => {
  const changed = draft();
  expect(changed.touched).toBeNull();
  changed.set_limit('scour', limits_of(SHEET)[0]?.path ?? [], 2);
  expect([changed.touched, changed.query()]).toEqual([['scour'], 'task=scour']);
  changed.asked.turbine = 'A02';
  expect([changed.touched, changed.query()]).toEqual([null, 'turbine=A02']);
});

test('TheFilesAndTheLinesAreThoseOfTheCommandLine', () => {
  const changed = draft();
  changed.set_limit('scour', limits_of(SHEET)[0]?.path ?? [], 2);
  changed.move_up(1);
  const files = changed_files('bay', changed.changed);
  expect(files.map(({ name }) => name)).toEqual(['scour.yaml', 'plan_bay.yaml']);
  const asked = { turbine: 'A02', from: '', to: '' };
  expect(command_lines('bay', ['scour', 'blade'], changed.changed, asked)).toEqual([
    'slackwater windows --site bay --task scour.yaml --task blade --turbine A02',
    'slackwater plan plan_bay.yaml   # write in it: task: scour.yaml',
  ]);
  expect(command_lines('bay', ['scour'], {}, { turbine: '', from: '', to: '' })).toEqual([
    'slackwater windows --site bay',
  ]);
});
