// The answers in words, short and always the same ones.
import { hour_text, is_known, percent_text } from '../look/units';
import type { Past, Range, Start, Verdict } from './answers';
import { ms_of } from './answer';

const FEW_MORNINGS = 10;
const FEW_GOES = 5;

export const VERDICT: Record<Verdict, string> = {
  go: 'Go',
  marginal: 'Marginal',
  'no-go': 'No-go',
};

/** Neither 0 nor 100 %: no forecast knows that much. */
export function chance_text(probability: number | null | undefined): string {
  if (!is_known(probability)) return percent_text(probability);
  if (probability < 0.005) return 'under 1 %';
  return probability >= 0.995 ? 'over 99 %' : percent_text(probability);
}

export function interval_text(interval: Range | null | undefined): string {
  if (!interval) return '';
  return `${Math.round(100 * interval[0])} to ${Math.round(100 * interval[1])}\u00a0%`;
}

/** Where the answers have a time inside a text, the hour alone, in the view's zone. */
export function with_hours(text: string, zone: string): string {
  return text.replace(/\d{4}-\d\d-\d\dT\d\d:\d\d(:\d\d)?Z/g, (time) =>
    hour_text(ms_of(time), zone),
  );
}

export function counted(n: number, one: string, many = `${one}s`): string {
  return `${n} ${n === 1 ? one : many}`;
}

/** How often past goes held. */
export function past_text(past: Past | null): string {
  if (past === null || past.mornings === 0) {
    return (
      'No past morning could be held against what came. Nobody knows yet how well these ' +
      'chances do here.'
    );
  }
  const over = `over ${counted(past.mornings, 'past morning')}`;
  const few = past.mornings < FEW_MORNINGS || past.goes < FEW_GOES;
  const goes =
    past.goes === 0
      ? `no start was a go ${over}`
      : `of ${counted(past.goes, 'go', 'goes')} ${past.goes_held} held ${over}`;
  const others =
    past.others_that_held === 0
      ? ''
      : `; on ${counted(past.others_that_held, 'other morning')} the best start held`;
  return few ? `Too few to judge by: ${goes}${others}.` : `Of past mornings: ${goes}${others}.`;
}

/** What stops a start, or comes nearest to it. */
export function binding_text(start: Start, zone: string): string {
  if (start.forbidden !== null) return `Closed: ${start.forbidden}.`;
  const { binding } = start;
  if (binding === null) return 'No limit is near.';
  const who = binding.worker === null ? '' : ` (${binding.worker})`;
  const at = hour_text(ms_of(binding.time), zone);
  const share = is_known(binding.share) ? Math.round(100 * binding.share) : null;
  const then = binding.bound_then?.text ? ` The limit then: ${binding.bound_then.text}.` : '';
  if (binding.exceeded) {
    const up_to = share === null ? '' : `; the forecast reaches ${share} % of it`;
    return (
      `${binding.limit}${who}: exceeded at ${at} in ${binding.futures} of ${start.futures} ` +
      `futures${up_to}.${then}`
    );
  }
  const reached = share === null ? '' : `: ${share} % of it reached at ${at}`;
  return `${binding.limit}${who}${reached}.${then}`;
}

export function allowed_text(allowed: boolean | null, why_not_known: string | null): string {
  if (allowed === null) return why_not_known ?? 'no answer';
  return allowed ? 'allows it' : 'does not allow it';
}
