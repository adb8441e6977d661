// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { plan_gantt } from 'page/decide/plan_gantt';
import { lanes_of, plan_rows, plan_span, type PlanBar } from 'page/decide/plan_rows';
import { answer, job, plan } from './decide_made';

const bar = (from: number, to: number): PlanBar => ({
  kind: 'job',
  from_ms: from,
  to_ms: to,
  text: '',
  key: '',
});

test('ThereIsARowForEachTeamVesselVehicleAndBattery', () => {
  const rows = plan_rows(
    plan({
      charges: [
        {
          battery: 'rov_pack',
          charger: 'deck',
          start: '2025-03-14T07:30:00Z',
          end: '2025-03-14T10:30:00Z',
        },
      ],
    }),
  );
  expect(rows.map(({ group, name, bars }) => [group, name, bars.map(({ kind }) => kind)])).toEqual([
    ['Teams', 'blue', ['job', 'reserve']],
    ['Teams', 'green', []],
    ['Vessels', 'ctv1', ['job', 'reserve', 'way']],
    ['Vehicles', 'rov1', ['job', 'reserve']],
    ['Batteries', 'rov_pack', ['job', 'charge']],
  ]);
  expect(plan_span(rows)).toEqual({
    from_ms: Date.UTC(2025, 2, 14, 5),
    to_ms: Date.UTC(2025, 2, 14, 11),
  });
});

test('WhatOverlapsLiesInLanes', () => {
  expect(lanes_of([bar(0, 10), bar(5, 15), bar(10, 20), bar(12, 13)])).toEqual([0, 1, 0, 2]);
  expect(lanes_of([bar(5, 15), bar(0, 10)])).toEqual([1, 0]);
  expect(lanes_of([])).toEqual([]);
});

test('WhatWasLeftIsToldWithItsReason', () => {
  const left = [
    { job: 'clean@F01', task: 'clean', turbine: 'F01', priority: 4, why: 'no start reaches 50 %' },
  ];
  const made = plan_gantt(
    answer(plan({ left, proven: false, bound: 5 })),
    '',
    plan({ left }),
    'UTC',
  );
  expect(made.node.querySelector('.left')?.textContent).toBe(
    'clean@F01 (priority 4): no start reaches 50 %',
  );
  expect(made.node.textContent).toContain('1 of 2 jobs planned, worth 1.78');
});

test('APlanThatLeavesAllSaysSo', () => {
  const empty = plan({ jobs: [], vessels: [], value: 0 });
  const made = plan_gantt(answer(empty), '', empty, 'UTC');
  expect(made.node.textContent).toContain('Nothing is planned for that day.');
  expect(made.node.querySelector('.bars')).toBeNull();
  made.at(0);
});

test('APlanInsideAReportKeepsItsPlaceInTheKeys', () => {
  const inside = plan({ jobs: [job()] });
  const { node } = plan_gantt(answer({ plan: inside }), 'plan.', inside, 'UTC');
  const said = node.querySelector('[data-key="plan.jobs.0.start"]');
  expect(said?.getAttribute('data-value')).toBe('2025-03-14T06:00:00Z');
});
