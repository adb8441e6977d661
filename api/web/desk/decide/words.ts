// The answers in words, short and always the same ones.
import { is_known, percent_text } from '../look/units';
import type { Past, Range, Start, Verdict } from './answers';
import { told, type Answer } from './answer';
import { hour_on } from './clock';

const FEW_MORNINGS = 10;
const FEW_GOES = 5;
/** The rules of go and marginal, where the answer does not tell them. */
export const RULES = { go: 0.9, marginal: 0.5 };

export const VERDICT: Record<Verdict, string> = {
  go: 'Go',
  marginal: 'Marginal',
  'no-go': 'No-go',
};

/** In whole percents; what does not reach a rule never reads as if it did. */
export function percent_of(share: number, { go, marginal } = RULES): number {
  const percent = Math.round(100 * share);
  const misses = (rule: number): boolean => share < rule && percent >= Math.round(100 * rule);
  return misses(go) || misses(marginal) ? percent - 1 : percent;
}

/** Neither 0 nor 100 %: no forecast knows that much. */
export function chance_text(probability: number | null | undefined): string {
  if (!is_known(probability)) return percent_text(probability);
  if (probability < 0.005) return 'under 1 %';
  return probability >= 0.995 ? 'over 99 %' : `${percent_of(probability)} %`;
}

/** The chance; and what it counts as, where flights in the twin succeed less often. */
export function chance_nodes(
  answer: Answer<unknown>,
  key: string,
  { probability, worth }: { probability: number; worth: number },
): (Node | string)[] {
  const chance = told(answer, `${key}.probability`, chance_text);
  if (!(worth < probability)) return [chance];
  return [chance, ', counts as ', told(answer, `${key}.worth`, chance_text)];
}

export function interval_text(interval: Range | null | undefined): string {
  if (!interval) return '';
  const [low, high] = interval.map((end) => chance_text(end).replace(' %', '\u00a0%'));
  return low === high ? `${low}` : `${low?.replace('\u00a0%', '')} to ${high}`;
}

/** Where the answers have a time inside a text, the hour alone, in the view's zone. */
export function with_hours(text: string, zone: string, day: string): string {
  return text.replace(/\d{4}-\d\d-\d\dT\d\d:\d\d(:\d\d)?Z/g, (time) => hour_on(time, zone, day));
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
export function binding_text(start: Start, zone: string, day: string): string {
  if (start.forbidden !== null) return `Closed: ${start.forbidden}.`;
  const { binding } = start;
  if (binding === null) return 'No limit is near.';
  const who = binding.worker === null ? '' : ` (${binding.worker})`;
  const at = hour_on(binding.time, zone, day);
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
