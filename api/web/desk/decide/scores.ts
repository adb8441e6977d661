// Which scores of `verify` are shown: of each day of lead the newest forecast that has truth.
import type { Score } from './answers';

export const VARIABLES: readonly (readonly [string, string])[] = [
  ['sea_water_velocity', 'Current'],
  ['wind', 'Wind'],
  ['sea_surface_wave_significant_height', 'Wave height'],
];
const DAY_H = 24;

/** A score and where it stands in the answer. */
export interface Found {
  score: Score;
  key: string;
  rmse: number | null;
}
export interface LeadDay {
  lead_h: readonly [number, number];
  issued: string;
  truth: string;
  by_method: Map<string, Found>;
}

/** Pooled over the columns, and of all depths: what a person means by "the error". */
function is_whole({ column, depth_m, height_above_bed_m }: Score): boolean {
  if (column !== null || (height_above_bed_m ?? null) !== null) return false;
  return depth_m === null || (depth_m[0] === 0 && depth_m[1] >= 1e5);
}

function found_of(score: Score, index: number): Found {
  const has_unit = 'rmse_m_s' in score;
  const key = `${index}.${has_unit ? 'rmse_m_s' : 'rmse'}`;
  return { score, key, rmse: (has_unit ? score.rmse_m_s : score.rmse) ?? null };
}

/** Issued forecasts before hindcasts: they are never mixed. */
function kept(scores: readonly Score[], variable: string): Found[] {
  const all = scores
    .map((score, i) => found_of(score, i))
    .filter(({ score }) => score.variable === variable && is_whole(score));
  const issued = all.filter(({ score }) => score.origin !== 'hindcast');
  return issued.length > 0 ? issued : all;
}

export function lead_days(scores: readonly Score[], variable: string): LeadDay[] {
  const newest = new Map<number, LeadDay>();
  const all = kept(scores, variable).filter(
    ({ score: { lead_h } }) => lead_h[1] - lead_h[0] === DAY_H,
  );
  for (const found of all) {
    const { lead_h, issued, method, truth } = found.score;
    const before = newest.get(lead_h[0]);
    if (before === undefined || issued > before.issued) {
      newest.set(lead_h[0], { lead_h, issued, truth, by_method: new Map([[method, found]]) });
    } else if (issued === before.issued) before.by_method.set(method, found);
  }
  return [...newest.values()].sort((a, b) => a.lead_h[0] - b.lead_h[0]);
}

/** Our forecast first, then the other models, then the simple methods by their names. */
export function methods_of(days: readonly LeadDay[]): string[] {
  const rank = (method: string): number => ['forecast', 'provider'].indexOf(method) >>> 0;
  const all = new Set(days.flatMap(({ by_method }) => [...by_method.keys()]));
  return [...all].sort((a, b) => rank(a) - rank(b) || a.localeCompare(b));
}

export interface HourlyLine {
  method: string;
  points: { lead_h: number; found: Found }[];
}

/** Hour by hour over the first day of lead, of one issue. */
export function hourly(scores: readonly Score[], variable: string, issued: string): HourlyLine[] {
  const lines = new Map<string, HourlyLine>();
  for (const found of kept(scores, variable)) {
    const { lead_h, method } = found.score;
    if (found.score.issued !== issued || lead_h[1] - lead_h[0] !== 1 || found.rmse === null)
      continue;
    const line = lines.get(method) ?? { method, points: [] };
    line.points.push({ lead_h: lead_h[1], found });
    lines.set(method, line);
  }
  for (const { points } of lines.values()) points.sort((a, b) => a.lead_h - b.lead_h);
  return [...lines.values()].sort((a, b) => a.method.localeCompare(b.method));
}
