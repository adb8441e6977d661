// When the current at the place and depth is slack, as the server says it: the next times first.
import type { Desk } from '../look/desk';
import { element, set_text } from '../../look/element';
import { hour_of, reach_of } from '../look/hours';
import type { Look } from '../look/look';
import type { Place } from '../view';
import { Refused, type Server } from '../server/server';

export interface Slack {
  readonly from: string;
  readonly to: string;
  readonly begins_before: boolean;
  readonly ends_after: boolean;
  readonly sure_from: string | null;
  readonly sure_to: string | null;
}
export interface SlackAnswer {
  readonly depth_m: number;
  readonly below_m_s: number;
  readonly slack: readonly Slack[];
  readonly why_none: string | null;
}
const MOST_SHOWN = 4;

export function slack_path(site: string, place: Place, depth_m: number): string {
  const asked = new URLSearchParams({
    depth: String(depth_m),
    longitude: String(place.longitude_deg),
    latitude: String(place.latitude_deg),
  });
  return `/sites/${encodeURIComponent(site)}/slack?${asked}`;
}

/** Refusals are told elsewhere: null. */
export async function fetch_slack(server: Server, path: string): Promise<SlackAnswer | null> {
  try {
    return await server.get<SlackAnswer>(path);
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    return null;
  }
}

/** Those that are not over at an hour, in words. @param end_ms  of the forecast */
export function slack_text(look: Look, answer: SlackAnswer, at_ms: number, end_ms: number): string {
  if (answer.why_none !== null) return answer.why_none;
  const ahead = answer.slack.filter(({ to }) => Date.parse(to) >= at_ms);
  const below = `below ${look.speed(answer.below_m_s, 2)}`;
  if (ahead.length === 0) {
    return `no likely slack (${below}) until ${look.time(end_ms)} ${look.zone_name}`;
  }
  const times = ahead.slice(0, MOST_SHOWN).map((one) => {
    const from = one.begins_before ? 'the beginning' : look.time(Date.parse(one.from));
    const to = one.ends_after ? 'the end' : look.hour(Date.parse(one.to));
    return `likely ${from} to ${to} (${sure_text(look, one)})`;
  });
  return `${below}, ${look.zone_name}: ${times.join('; ')}`;
}

/** The hours are of the likely speed; there are fewer in which nearly all futures are slack. */
function sure_text(look: Look, { sure_from, sure_to }: Slack): string {
  if (sure_from === null || sure_to === null) return 'at no time nearly sure';
  return `nearly sure ${look.hour(Date.parse(sure_from))} to ${look.hour(Date.parse(sure_to))}`;
}

export function slackPart(desk: Desk): HTMLElement {
  const { view, server, look } = desk;
  const line = element('p', { class: 'slack' });
  let answer: SlackAnswer | null = null;
  let asked = 0;
  let of = ''; // what the answer belongs to
  const show = (): void => {
    const at_ms = hour_of(desk);
    const reach = reach_of(server.forecast(view.values.site));
    if (answer === null || at_ms === null || reach === null) set_text(line, '');
    else {
      const words = slack_text(look, answer, at_ms, reach.to_ms);
      set_text(line, `Slack at ${answer.depth_m} m: ${words}`);
    }
  };
  const load = async (): Promise<void> => {
    asked += 1;
    const mine = asked;
    const { site, place, depth_m } = view.values;
    const now = JSON.stringify([site, place, depth_m]);
    if (now !== of) {
      of = now;
      answer = null;
      show();
    }
    const where = site === '' ? null : (place ?? (await place_of(server, site)));
    const came =
      where === null ? null : await fetch_slack(server, slack_path(site, where, depth_m));
    if (mine !== asked) return;
    answer = came;
    show();
  };
  desk.onChange((changed) => {
    const is_other = (['place', 'site', 'forecast', 'depth_m'] as const).some((key) =>
      changed.has(key),
    );
    if (is_other || (changed.has('server') && server.link.is === 'there')) void load();
    else show();
  });
  void load();
  return line;
}

async function place_of(server: Server, site: string): Promise<Place | null> {
  try {
    return (await server.site(site)).place;
  } catch (problem) {
    if (!(problem instanceof Refused)) throw problem;
    return null;
  }
}
