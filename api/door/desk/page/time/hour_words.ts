// Where an hour lies, as people say it: from now, and from the issue of the forecast.
import { HOUR_MS, type Reach } from '../look/hours';
import { span_text } from '../look/units';

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
