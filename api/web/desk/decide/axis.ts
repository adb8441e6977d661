// Hours across a drawing, as shares of its width: it needs no redrawing when the page is resized.
import { hour_text } from '../look/units';

const HOUR_MS = 3_600_000;

export class Axis {
  constructor(
    readonly from_ms: number,
    readonly to_ms: number,
  ) {}

  share(at_ms: number): number {
    return (at_ms - this.from_ms) / (this.to_ms - this.from_ms);
  }
  x(at_ms: number): string {
    return `${(100 * this.share(at_ms)).toFixed(3)}%`;
  }
  width(span_ms: number): string {
    return `${((100 * span_ms) / (this.to_ms - this.from_ms)).toFixed(3)}%`;
  }
  holds(at_ms: number): boolean {
    return at_ms >= this.from_ms && at_ms <= this.to_ms;
  }

  /** Whole hours of the zone's clock, eight of them at most. */
  ticks(zone: string): { at_ms: number; text: string }[] {
    const hours = (this.to_ms - this.from_ms) / HOUR_MS;
    const every = [1, 2, 3, 6, 12, 24].find((step) => hours / step <= 8) ?? 24;
    const ticks: { at_ms: number; text: string }[] = [];
    for (let at = Math.ceil(this.from_ms / HOUR_MS) * HOUR_MS; at <= this.to_ms; at += HOUR_MS) {
      const text = hour_text(at, zone);
      if (Number(text.slice(0, 2)) % every !== 0) continue;
      ticks.push({ at_ms: at, text: text.replace(/:00$/, '') });
    }
    return ticks;
  }
}
