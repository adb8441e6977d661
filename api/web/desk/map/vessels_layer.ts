// The layer of vessels: their signs, ways and names, and what is said where there are none.
import type { GeoProjection } from 'd3-geo';
import type { Desk } from '../look/desk';
import { drawn, element, set_hidden, set_text } from '../../look/element';
import { hour_of } from '../look/hours';
import { Refused } from '../server/server';
import { fetch_traffic, type Traffic, type Vessel } from '../server/traffic';
import type { Place } from '../view';
import type { Box } from './cells';
import { box_around, place_labels, type Taken } from './labels';
import { screen, text, type Point } from './scene';
import { vessel_list } from './vessel_list';
import { vessel_sign, way_sign } from './vessel_signs';
import { last_heard_words, name_of, short_span, title_of, troubles_of } from './vessel_words';

const EVERY_MS = 10_000;
const WAIT_MS = 200; // for the next step of the slider
const AFTER_NOW_MS = 60_000;
const OUTSIDE_DEG = 0.05; // a ship beside the picture may have its way in it
const SIGN_PX = 12;
const MARKED_PX = 26; // with its ring and mark

export interface Drawing {
  to: GeoProjection;
  box: Box;
  is_shown: boolean;
  with_names: boolean;
  /** What names may not cover. */
  taken: () => Taken[];
}
export interface VesselsLayer {
  node: SVGGElement;
  says: HTMLElement;
  list: HTMLElement;
  draw: (drawing: Drawing) => void;
}

/** @param go_to  shows a place in the middle of the map */
export function vessels_layer(
  desk: Desk,
  go_to: (place: Place) => void,
  wait_ms = WAIT_MS,
): VesselsLayer {
  const { view, server, look } = desk;
  let traffic: Traffic | null = null;
  let trouble = ''; // of the question, not of the receiver
  let last: Drawing | null = null;
  let chosen: number | null = null;
  let asked = 0;
  let has_asked = false;
  let timer: ReturnType<typeof setTimeout> | undefined;

  const node = drawn('g', { class: 'vessels' });
  const says = element('p', { class: 'map-note', role: 'status', hidden: true });
  const list = vessel_list(desk, (vessel) => {
    chosen = vessel.mmsi;
    go_to({ longitude_deg: vessel.longitude_deg, latitude_deg: vessel.latitude_deg });
    redraw();
  });

  /** The slider's hour; now to ten seconds, as the server has it. */
  const wanted_ms = (): number => {
    const hour = view.values.at_ms === null ? null : hour_of(desk);
    return hour ?? Math.floor(server.now_ms() / EVERY_MS) * EVERY_MS;
  };
  const can_ask = (): boolean => view.values.site !== '' && server.heard_ms !== null;
  const is_now = (): boolean => view.values.at_ms === null;

  const redraw = (): void => {
    if (last === null) return;
    if (traffic === null || !last.is_shown) node.replaceChildren();
    else draw_vessels(node, traffic, last, desk, chosen);
  };
  const show = (): void => {
    list.show(traffic, trouble);
    const words = warning_of(traffic, server.now_ms());
    set_text(says, words);
    set_hidden(says, words === '' || last?.is_shown === false);
    redraw();
  };
  const ask = async (): Promise<void> => {
    asked += 1;
    const mine = asked;
    const { site } = view.values;
    try {
      const came = await fetch_traffic(server, site, wanted_ms());
      if (mine !== asked) return;
      traffic = came;
      trouble = '';
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (mine !== asked) return;
      traffic = null; // a ship of ten minutes ago is none
      trouble = problem.detail;
    }
    show();
    if (is_now() && (traffic === null || traffic.sources.length > 0)) ask_soon(EVERY_MS);
  };
  const ask_soon = (after_ms: number): void => {
    clearTimeout(timer);
    timer = setTimeout(() => void ask(), after_ms);
  };
  const forget = (): void => {
    asked += 1;
    traffic = null;
    trouble = '';
    clearTimeout(timer);
    show();
  };

  /** Nobody listens: another hour has no vessels either. */
  const is_deaf = (): boolean => traffic !== null && traffic.sources.length === 0;
  desk.onChange((changed) => {
    const is_other_site = changed.has('site');
    if (is_other_site) {
      chosen = null;
      forget();
    }
    if (!can_ask()) return;
    const is_first = !has_asked; // until the server has told its clock, nobody knows what now is
    const is_other_hour = changed.has('at_ms') && !is_deaf();
    if (is_first || is_other_site || is_other_hour || changed.has('server')) {
      if (is_other_hour) forget(); // what was heard at another hour
      has_asked = true;
      ask_soon(is_first || is_other_site ? 0 : wait_ms);
    }
    if (changed.has('speed') || changed.has('directions') || changed.has('clock')) show();
  });
  if (can_ask()) {
    has_asked = true;
    ask_soon(0);
  }
  const draw = (drawing: Drawing): void => {
    const was_shown = last?.is_shown;
    last = drawing;
    if (was_shown !== drawing.is_shown) show();
    else redraw();
  };
  show();
  return { node, says, list: list.node, draw };

  function warning_of(of: Traffic | null, now_ms: number): string {
    if (of === null || of.sources.length === 0) return '';
    const at_ms = Date.parse(of.at);
    if (at_ms > now_ms + AFTER_NOW_MS) return 'Vessels are not forecast: this hour is after now.';
    const broken = troubles_of(of);
    return broken.length === 0 ? '' : [...broken, last_heard_words(of, look)].join(' ');
  }
}

function draw_vessels(
  at: SVGGElement,
  traffic: Traffic,
  { to, box, with_names, taken }: Drawing,
  { look }: Desk,
  chosen: number | null,
): void {
  const seen = traffic.vessels
    .filter((vessel) => is_near(vessel, box))
    .map((vessel) => ({ vessel, here: screen(to, vessel) }));
  const ways = seen.flatMap(({ vessel, here }) => {
    if (vessel.ahead === null) return [];
    const [x, y] = screen(to, vessel.ahead);
    const way = way_sign(round(x - here[0]), round(y - here[1]));
    return [drawn('g', { transform: `translate(${here})` }, way)];
  });
  // The first of the list lie on top.
  const signs = [...seen].reverse().map(({ vessel, here }) => {
    const sign = vessel_sign(vessel);
    if (vessel.mmsi === chosen) {
      sign.append(drawn('path', { class: 'chosen', d: 'M-17,-9 v-8 h8 M17,9 v8 h-8' }));
    }
    const title = drawn('title', {}, title_of(vessel, traffic, look));
    return drawn('g', { transform: `translate(${here})` }, sign, title);
  });
  const words = with_names ? labels_of(seen, taken()) : [];
  at.replaceChildren(...ways, ...signs, ...words);
}

function labels_of(seen: { vessel: Vessel; here: Point }[], taken: Taken[]): SVGElement[] {
  const half = ({ alarm }: Vessel): number => (alarm === null ? SIGN_PX : MARKED_PX);
  const around = seen.map(({ vessel, here }) => box_around(here, half(vessel) - 4));
  const labels = seen.map(({ vessel, here }) => ({
    at: here,
    half: half(vessel),
    words: label_of(vessel),
  }));
  const made = place_labels(labels, [...taken, ...around]).map(({ at, anchor, words }) =>
    text(at, 0, 0, words, anchor === 'start' ? 'vessel-name' : `vessel-name ${anchor}`),
  );
  const marked = new Set(
    seen.filter(({ vessel }) => vessel.alarm !== null).map(({ vessel }) => label_of(vessel)),
  );
  for (const label of made) if (marked.has(label.textContent ?? '')) label.classList.add('bold');
  return made;
}

function label_of(vessel: Vessel): string {
  const age = vessel.state === 'old' ? `, ${short_span(vessel.age_s)} old` : '';
  return `${name_of(vessel)}${age}`;
}

function is_near(vessel: Vessel, { west, south, east, north }: Box): boolean {
  const turned = ((((vessel.longitude_deg - west + OUTSIDE_DEG) % 360) + 360) % 360) - OUTSIDE_DEG;
  const wide = (((east - west) % 360) + 360) % 360;
  return (
    vessel.latitude_deg > south - OUTSIDE_DEG &&
    vessel.latitude_deg < north + OUTSIDE_DEG &&
    turned < wide + OUTSIDE_DEG
  );
}

const round = (px: number): number => Math.round(px * 10) / 10;
