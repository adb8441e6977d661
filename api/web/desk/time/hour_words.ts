// Where an hour lies, as people say it: from now, and from the issue of the forecast.
import { HOUR_MS, type Reach } from '../look/hours';
import type { Look } from '../look/look';
import { span_text } from '../look/units';

/** A link may name an hour that the forecast does not reach; empty where it does. */
export function outside_words(reach: Reach, wanted_ms: number | null, look: Look): string {
  if (wanted_ms === null) return '';
  if (wanted_ms >= reach.from_ms && wanted_ms <= reach.to_ms) return '';
  const asked = look.time(wanted_ms);
  return `The forecast does not reach ${asked}: this is the hour nearest to it.`;
}

export function hour_words(reach: Reach, issued: string, at_ms: number, now_ms: number): string {
  if (now_ms > reach.to_ms) {
    return `The forecast ended ${span_text((now_ms - reach.to_ms) / 1000)} ago. Make a new one.`;
  }
  const from_now_ms = at_ms - now_ms;
  const now =
    Math.abs(from_now_ms) <= HOUR_MS / 2
      ? 'now'
      : `${span_text(from_now_ms / 1000)} ${from_now_ms < 0 ? 'ago' : 'from now'}`;
  const issued_ms = Date.parse(issued);
  if (!Number.isFinite(issued_ms)) return now;
  const lead = span_text((at_ms - issued_ms) / 1000);
  return `${now}; ${lead} ${at_ms < issued_ms ? 'before' : 'after'} the issue`;
}
