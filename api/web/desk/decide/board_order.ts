// The board's order: what cannot be trusted first, then what cannot be done, then by name.
import type { SiteInSites, SiteStatus } from '../server/answers';
import type { Verdict } from './answers';

const STATUS: readonly SiteStatus[] = [
  'unreadable',
  'stale',
  'no_forecast',
  'degraded',
  'hindcast',
  'ok',
];
const VERDICT: readonly Verdict[] = ['no-go', 'marginal', 'go'];

/** What is known of a site's report. */
export type BoardReport =
  | { is: 'waiting' }
  | { is: 'refused'; why: string }
  | { is: 'there'; today: Verdict | null; next: Verdict; headline: string };

export interface BoardSite {
  site: SiteInSites;
  report: BoardReport;
}

/** Of both days the better is what a coordinator can still use; a missing answer is worse. */
function verdict_rank(report: BoardReport): number {
  if (report.is === 'refused') return -1;
  if (report.is === 'waiting') return VERDICT.length;
  return VERDICT.indexOf(report.today ?? report.next);
}

export function worst_first<T extends BoardSite>(sites: readonly T[]): T[] {
  return [...sites].sort(
    (a, b) =>
      STATUS.indexOf(a.site.status) - STATUS.indexOf(b.site.status) ||
      verdict_rank(a.report) - verdict_rank(b.report) ||
      a.site.name.localeCompare(b.site.name),
  );
}

export const STATUS_TEXT: Record<SiteStatus, string> = {
  ok: 'In force',
  degraded: 'Degraded',
  stale: 'Old',
  hindcast: 'Of a past day',
  unreadable: 'Cannot be read',
  no_forecast: 'No forecast',
};

/** "100 sites: 2 cannot be read, 3 old, 95 in force" */
export function counts_text(sites: readonly SiteInSites[]): string {
  const parts = STATUS.flatMap((status) => {
    const count = sites.filter((site) => site.status === status).length;
    return count === 0 ? [] : [`${count} ${STATUS_TEXT[status].toLowerCase()}`];
  });
  const all = sites.length === 1 ? '1 site' : `${sites.length} sites`;
  return parts.length === 0 ? all : `${all}: ${parts.join(', ')}`;
}
