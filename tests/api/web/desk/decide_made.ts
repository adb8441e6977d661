// Small answers made by hand, for the tests of decide/ and what_if/.
import type { Answer } from 'page/decide/answer';
import type {
  Best,
  Plan,
  PlanJob,
  Report,
  ReportTask,
  Start,
  Windows,
  WindowsTask,
} from 'page/decide/answers';
import { Look } from 'page/look/look';
import { first_view, View } from 'page/view';

export const look = new Look(new View(first_view()));

export const answer = <T>(body: T, from = '/sites/bay/report'): Answer<T> => ({ from, body });

export function best(some: Partial<Best> = {}): Best {
  return {
    start: '2025-03-14T06:30:00Z',
    probability: 0.8934724776523347,
    worth: 0.8934724776523347,
    interval_95: [0.651, 0.9888],
    stopped_by:
      'wind at 10 m at most 12 m/s, exceeded at 2025-03-14T05:40:00Z in 153 of 1993 futures',
    flown: null,
    ...some,
  };
}

export function report_task(some: Partial<ReportTask> = {}): ReportTask {
  return {
    task: 'scour',
    name: 'Scour survey',
    turbines: ['A01'],
    verdict: 'marginal',
    best: best(),
    windows: [],
    would_help: null,
    past: null,
    not_checked: [],
    assumed: [],
    ...some,
  };
}

export function report(some: Partial<Report> = {}): Report {
  return {
    site: 'bay',
    site_name: 'The bay',
    day: '2025-03-14',
    from: '2025-03-14T00:00:00Z',
    to: '2025-03-15T00:00:00Z',
    verdict: 'no-go',
    headline: 'No go for any of 1 task on Fri 14 Mar.',
    futures: 25,
    forecast: {
      name: 'bay 2025-03-12',
      sha256: 'efe11b41e9ec739392fc',
      issued: '2025-03-13T05:00:00Z',
      degraded: false,
      headline: 'Currents calibrated on 2025-03-12.',
    },
    tasks: [],
    left_out: [],
    today: null,
    plan: null,
    no_plan: null,
    trust: [],
    verified: 'Nothing is verified yet.',
    notes: [],
    ...some,
  };
}

export function start(hour: number, worth: number, some: Partial<Start> = {}): Start {
  return {
    start: `2025-03-14T${String(hour).padStart(2, '0')}:00:00Z`,
    probability: worth,
    worth,
    interval_95: [worth / 2, (1 + worth) / 2],
    futures: 25,
    futures_held: Math.round(25 * worth),
    threshold: worth > 0.5,
    alpha: null,
    forbidden: null,
    unforecast: null,
    binding: null,
    twin: null,
    ...some,
  };
}

export function windows_task(some: Partial<WindowsTask> = {}): WindowsTask {
  return {
    task: 'scour',
    name: 'Scour survey',
    turbines: ['A01'],
    verdict: 'go',
    duration_h: 1.5,
    contingency_h: 0.5,
    not_checked: [],
    assumed: [],
    past: null,
    starts: [],
    windows: [],
    windows_by_threshold: [],
    windows_by_alpha: null,
    no_alpha: 'the table has no factor',
    limits: [],
    ...some,
  };
}

export function windows(tasks: WindowsTask[], some: Partial<Windows> = {}): Windows {
  return {
    from: '2025-03-14T06:00:00Z',
    to: '2025-03-14T12:00:00Z',
    every_min: 60,
    verdict: 'go',
    rules: { go: 0.9, marginal: 0.5, alpha: 'a table' },
    tasks,
    left_out: [],
    notes: [],
    ...some,
  };
}

export function job(some: Partial<PlanJob> = {}): PlanJob {
  return {
    job: 'scour@A01',
    task: 'scour',
    turbine: 'A01',
    priority: 2,
    start: '2025-03-14T06:00:00Z',
    end: '2025-03-14T07:30:00Z',
    contingency_h: 0.5,
    probability: 0.89,
    vessel: 'ctv1',
    crew: 'blue',
    vehicles: ['rov1'],
    packs: [{ battery: 'rov_pack', count: 1 }],
    ...some,
  };
}

export function plan(some: Partial<Plan> = {}): Plan {
  return {
    plan: 'One boat',
    day: '2025-03-14',
    value: 1.78,
    bound: 1.78,
    gap: 0,
    proven: true,
    least_probability: 0.5,
    jobs: [job()],
    left: [],
    vessels: [
      {
        vessel: 'ctv1',
        crews: ['blue', 'green'],
        ways: [
          {
            from: 'Port',
            to: 'A01',
            leaves: '2025-03-14T05:10:00Z',
            arrives: '2025-03-14T06:00:00Z',
          },
        ],
      },
    ],
    charges: [],
    ...some,
  };
}
