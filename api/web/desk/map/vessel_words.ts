// What is said of a vessel, in the reader's units.
import type { Look } from '../look/look';
import { is_known, NOT_KNOWN } from '../look/units';
import type { Traffic, Vessel } from '../server/traffic';

export const name_of = ({ name, mmsi }: Vessel): string => name ?? `MMSI ${mmsi}`;

export function kind_of({ kind, length_m, class: speaker }: Vessel): string {
  const what = kind ?? (speaker === 'B' ? 'small craft' : NOT_KNOWN);
  return is_known(length_m) ? `${what}, ${Math.round(length_m)} m` : what;
}

/** "40 s", "12 min", "3 h 20 min": of a place seconds count. */
export function short_span(span_s: number): string {
  const seconds = Math.round(Math.abs(span_s));
  if (seconds < 120) return `${seconds} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 120 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

export function distance_text(metres: number): string {
  return metres < 10_000 ? `${Math.round(metres)} m` : `${(metres / 1000).toFixed(1)} km`;
}

/** The limit for which a vessel is marked; empty where it is not. */
export function limit_words({ alarm }: Vessel, { limits }: Traffic): string {
  if (alarm === null) return '';
  const near = `nearer than ${distance_text(limits.cpa_m)}`;
  return alarm === 'inside' ? near : `${near} within ${short_span(limits.tcpa_s)}`;
}

export function movement_words({ speed_m_s, to_direction_deg }: Vessel, look: Look): string {
  if (!is_known(speed_m_s)) return 'speed not known';
  return `${look.speed(speed_m_s)} to ${look.direction(to_direction_deg)}`;
}

export function age_words({ age_s, state }: Vessel): string {
  return `${state === 'old' ? 'old, ' : ''}heard ${short_span(age_s)} before`;
}

/** Of what stands under the pointer. */
export function title_of(vessel: Vessel, traffic: Traffic, look: Look): string {
  const limit = limit_words(vessel, traffic);
  const told = vessel.told === null ? 'no closest approach' : vessel.told.in_words;
  const lines = [
    name_of(vessel),
    kind_of(vessel),
    movement_words(vessel, look),
    `${age_words(vessel)}${vessel.dead_reckoned ? ', carried on since then' : ''}`,
    limit === '' ? told : `${told}: ${limit}`,
  ];
  return lines.join('\n');
}

/** What is wrong with the logs, each a sentence. */
export const troubles_of = ({ sources }: Traffic): string[] =>
  sources.flatMap(({ trouble }) => trouble ?? []);

/** When anything was heard last, by the reader's clock. */
export function last_heard_words({ at, last_heard }: Traffic, look: Look): string {
  if (last_heard === null) return 'Nothing was heard by then.';
  const heard_ms = Date.parse(last_heard);
  const before = short_span((Date.parse(at) - heard_ms) / 1000);
  const at_time = `${look.time(heard_ms)} ${look.zone_name}`;
  return `The receiver last heard something at ${at_time}, ${before} before.`;
}

/** How things stand, as the list begins. */
export function state_words(traffic: Traffic, look: Look): string {
  if (traffic.sources.length === 0) return traffic.in_words;
  const { vessels, too_old, left_out, rule } = traffic;
  const within = `within ${distance_text(rule.reach_m)} of the site`;
  const said = [...troubles_of(traffic), last_heard_words(traffic, look)];
  if (vessels.length === 0) said.push(`No vessel ${within}.`);
  if (left_out > 0)
    said.push(`The nearest ${vessels.length} of ${vessels.length + left_out} ${within}.`);
  if (too_old > 0) {
    said.push(`${too_old} more were silent for over ${short_span(rule.shown_s)}: not shown.`);
  }
  return said.join(' ');
}
