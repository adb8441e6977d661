// The plan as rows of bars: teams, vessels, vehicles, batteries.
import type { Plan, PlanJob } from './answers';

export type BarKind = 'job' | 'reserve' | 'way' | 'charge';
export interface PlanBar {
  kind: BarKind;
  from_ms: number;
  to_ms: number;
  text: string;
  key: string; // where it stands in the plan
}
export interface PlanRow {
  group: string;
  name: string;
  bars: PlanBar[];
}

export function plan_rows(plan: Plan): PlanRow[] {
  const jobs = plan.jobs.map((job, j) => ({ job, key: `jobs.${j}` }));
  const of = (keep: (job: PlanJob) => boolean, text: (job: PlanJob) => string): PlanBar[] =>
    jobs.filter(({ job }) => keep(job)).flatMap(({ job, key }) => job_bars(job, key, text(job)));
  const sorted = (names: string[]): string[] => [...new Set(names)].sort();
  // The turbine first: a short bar shows the beginning of its text.
  const named = ({ task, turbine }: PlanJob): string => `${turbine} ${task}`;

  const teams = sorted([
    ...plan.jobs.map(({ crew }) => crew),
    ...plan.vessels.flatMap(({ crews }) => crews),
  ]);
  const vehicles = sorted(plan.jobs.flatMap((job) => job.vehicles));
  const batteries = sorted([
    ...plan.jobs.flatMap(({ packs }) => packs.map(({ battery }) => battery)),
    ...plan.charges.map(({ battery }) => battery),
  ]);
  return [
    ...teams.map((name) => ({
      group: 'Teams',
      name,
      bars: of(({ crew }) => crew === name, named),
    })),
    ...plan.vessels.map(({ vessel, ways }, v) => ({
      group: 'Vessels',
      name: vessel,
      bars: [
        ...of((job) => job.vessel === vessel, named),
        ...ways.map((way, w) =>
          bar('way', way.leaves, way.arrives, `${way.from} to ${way.to}`, `vessels.${v}.ways.${w}`),
        ),
      ],
    })),
    ...vehicles.map((name) => ({
      group: 'Vehicles',
      name,
      bars: of((job) => job.vehicles.includes(name), named),
    })),
    ...batteries.map((name) => ({
      group: 'Batteries',
      name,
      bars: [
        ...of(
          ({ packs }) => packs.some(({ battery }) => battery === name),
          (job) => `${packs_of(job, name)} out with ${job.job}`,
        ).filter(({ kind }) => kind === 'job'),
        ...charge_bars(plan, name),
      ],
    })),
  ];
}

function packs_of(job: PlanJob, name: string): string {
  const count = job.packs.find(({ battery }) => battery === name)?.count ?? 0;
  return count === 1 ? '1 pack' : `${count} packs`;
}

function charge_bars(plan: Plan, name: string): PlanBar[] {
  return plan.charges.flatMap(({ battery, charger, start, end }, c) =>
    battery === name
      ? [bar('charge', start, end, `1 pack charges at ${charger}`, `charges.${c}`)]
      : [],
  );
}

/** The job, and behind it the time that it may fall behind by. */
function job_bars(job: PlanJob, key: string, text: string): PlanBar[] {
  const made = bar('job', job.start, job.end, text, key);
  if (job.contingency_h <= 0) return [made];
  const to_ms = made.to_ms + job.contingency_h * 3_600_000;
  return [
    made,
    { ...made, kind: 'reserve', from_ms: made.to_ms, to_ms, text: `reserve of ${text}` },
  ];
}

function bar(kind: BarKind, from: string, to: string, text: string, key: string): PlanBar {
  return { kind, from_ms: Date.parse(from), to_ms: Date.parse(to), text, key };
}

/** Bars one below the other where they overlap: the lane of each. */
export function lanes_of(bars: readonly PlanBar[]): number[] {
  const free_from: number[] = [];
  const order = bars.map((_, i) => i).sort((a, b) => begin(bars, a) - begin(bars, b));
  const lanes: number[] = bars.map(() => 0);
  for (const i of order) {
    const found = free_from.findIndex((free) => free <= begin(bars, i));
    const lane = found === -1 ? free_from.length : found;
    lanes[i] = lane;
    free_from[lane] = bars[i]?.to_ms ?? 0;
  }
  return lanes;
}

function begin(bars: readonly PlanBar[], i: number): number {
  return bars[i]?.from_ms ?? 0;
}

/** Whole hours about all that is planned. */
export function plan_span(rows: readonly PlanRow[]): { from_ms: number; to_ms: number } | null {
  const bars = rows.flatMap((row) => row.bars);
  if (bars.length === 0) return null;
  const HOUR_MS = 3_600_000;
  const from_ms = Math.min(...bars.map((it) => it.from_ms));
  const to_ms = Math.max(...bars.map((it) => it.to_ms));
  return {
    from_ms: Math.floor(from_ms / HOUR_MS) * HOUR_MS,
    to_ms: Math.ceil(to_ms / HOUR_MS) * HOUR_MS,
  };
}
