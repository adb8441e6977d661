// What the server says of a site's days, as far as this folder shows it. api/docs/json.md,
// windows.md, report.md, plan.md and decisions.md say what each key means.

export type Verdict = 'go' | 'marginal' | 'no-go';
export type Range = readonly [number, number];

export interface Past {
  mornings: number;
  said_by_futures: number;
  held: number;
  goes: number;
  goes_held: number;
  others_that_held: number;
}

export interface Best {
  start: string;
  probability: number;
  worth: number;
  interval_95: Range;
  stopped_by: string;
  flown: { probability: number; interval_95: Range; flights: number } | null;
}

export interface ReportTask {
  task: string;
  name: string;
  turbines: string[];
  verdict: Verdict;
  best: Best | null;
  windows: { from: string; to: string; worth: { min: number; max: number } }[];
  would_help: {
    limits: { without: string; worker: string | null; start: string; probability: number }[];
  } | null;
  past: Past | null;
  not_checked: string[];
  assumed: string[];
}

export interface LeftOut {
  task: string;
  why: string;
}

/** The hours left of today, or the day after. */
export interface Day {
  from: string;
  to: string;
  verdict: Verdict;
  headline: string;
  tasks: ReportTask[];
  left_out: LeftOut[];
}

export interface Trust {
  variable: string;
  unit: string;
  forecasts: number;
  rmse: number;
  outcome: 'ahead' | 'tie' | 'beaten' | 'alone';
  best_rival: string | null;
  rival_rmse: number | null;
}

export interface Report extends Day {
  site: string;
  site_name: string;
  day: string;
  futures: number;
  forecast: { name: string; sha256: string; issued: string; degraded: boolean; headline: string };
  today: Day | null;
  plan: Plan | null;
  no_plan: string | null;
  trust: Trust[];
  verified: string;
  notes: string[];
}

export interface Binding {
  limit: string;
  worker: string | null;
  exceeded: boolean;
  futures: number;
  time: string;
  share: number | null;
  bound_then: { text: string | null } | null;
}

export interface Start {
  start: string;
  probability: number;
  worth: number;
  interval_95: Range;
  futures: number;
  futures_held: number;
  threshold: boolean;
  alpha: boolean | null;
  forbidden: string | null;
  unforecast: string | null;
  binding: Binding | null;
  twin: {
    probability: number;
    interval_95: Range;
    flights: number;
    stopped_by: string | null;
  } | null;
}

export interface Window {
  from: string;
  to: string;
  best: string;
}

export interface WindowsTask {
  task: string;
  name: string;
  turbines: string[];
  verdict: Verdict;
  duration_h: number;
  contingency_h: number;
  not_checked: string[];
  assumed: string[];
  past: Past | null;
  starts: Start[];
  best?: { start: string } | null; // by the server's own order of starts
  windows: Window[];
  windows_by_threshold: Window[];
  windows_by_alpha: Window[] | null;
  no_alpha: string | null;
  limits: { worker: string | null; limit: string; variable: string | null; bound: number | null }[];
}

export interface Windows {
  from: string;
  to: string;
  every_min: number;
  verdict: Verdict;
  rules: { go: number; marginal: number; alpha: string };
  tasks: WindowsTask[];
  left_out: LeftOut[];
  notes: string[];
}

export interface PlanJob {
  job: string;
  task: string;
  turbine: string;
  priority: number;
  start: string;
  end: string;
  contingency_h: number;
  probability: number;
  vessel: string;
  crew: string;
  vehicles: string[];
  packs: { battery: string; count: number }[];
}

export interface Plan {
  plan: string;
  day: string;
  value: number;
  bound: number;
  gap: number;
  proven: boolean;
  least_probability: number | null;
  jobs: PlanJob[];
  left: { job: string; task: string; turbine: string; priority: number; why: string }[];
  vessels: {
    vessel: string;
    crews: string[];
    ways: { from: string; to: string; leaves: string; arrives: string }[];
  }[];
  charges: { battery: string; charger: string; start: string; end: string }[];
}

/** One score of `verify`; waves have theirs without "_m_s". */
export interface Score {
  variable: string;
  unit: string;
  day: string;
  issued: string;
  origin: string;
  column: number | null;
  depth_m: Range | null;
  height_above_bed_m?: Range | null;
  lead_h: Range;
  method: string;
  truth: string;
  rmse_m_s?: number | null;
  rmse?: number | null;
}

export interface Decision {
  id: number;
  task: string;
  turbine: string | null;
  start: string;
  decided: 'go' | 'no_go';
  by: string;
  recorded_at: string;
  late: boolean;
  counts: boolean;
  note: string | null;
  hand_over: string | null;
  said: { probability: number | null; verdict: Verdict | null; why_nothing: string | null };
  came: {
    outcome: 'held' | 'did_not_hold' | 'not_known_yet' | 'cannot_be_known';
    broken: string | null;
    broken_at: string | null;
    why: string | null;
    not_checked: string[];
  };
}

export interface Decisions {
  decisions: Decision[];
  record: { text: string | null };
}

export interface Sources {
  issued: string;
  day: string;
  sources: { quantity: string; product: string; run: string; text: string }[];
}
