// The vessels in words: the marked ones first, then the nearest; each can be shown on the map.
import type { Desk } from '../look/desk';
import { button, element, scroll_region, set_hidden, set_text } from '../../look/element';
import { NOT_KNOWN } from '../look/units';
import type { Approach, Traffic, Vessel } from '../server/traffic';
import {
  distance_text,
  kind_of,
  limit_words,
  movement_words,
  name_of,
  short_span,
  state_words,
} from './vessel_words';

const HEADS = [
  'Vessel',
  'Closest approach',
  'When',
  'Why marked',
  'Over ground',
  'Off the site',
  'What',
  'Last report',
];

interface Row {
  node: HTMLElement;
  name: HTMLButtonElement;
  cells: HTMLElement[];
  vessel: Vessel;
}

export function vessel_list(
  { look }: Desk,
  on_choose: (vessel: Vessel) => void,
): { node: HTMLElement; show: (traffic: Traffic | null, trouble: string) => void } {
  const rows = new Map<number, Row>();
  const title = element('summary', {}, 'Vessels');
  const note = element('p', { class: 'note' });
  const rule = element('p', { class: 'note' });
  const body = element('tbody');
  const head = element('tr', {}, ...HEADS.map((words) => element('th', { scope: 'col' }, words)));
  const table = element('table', {}, element('thead', {}, head), body);
  const region = scroll_region('Vessels as a table', table);
  const node = element('details', { class: 'columns vessel-list' }, title, note, region, rule);

  const row_of = (vessel: Vessel): Row => {
    const known = rows.get(vessel.mmsi);
    if (known !== undefined) {
      known.vessel = vessel;
      return known;
    }
    const name = button('', () => on_choose(made.vessel), { class: 'link' });
    const cells = HEADS.slice(1).map(() => element('td'));
    const tr = element('tr', {}, element('th', { scope: 'row' }, name), ...cells);
    const made: Row = { node: tr, name, cells, vessel };
    rows.set(vessel.mmsi, made);
    return made;
  };
  const show = (traffic: Traffic | null, trouble: string): void => {
    set_text(title, title_words(traffic, trouble, look));
    const is_followed = traffic !== null && traffic.sources.length > 0;
    set_text(note, trouble !== '' || traffic === null ? trouble : state_words(traffic, look));
    set_hidden(note, note.textContent === '');
    set_text(rule, is_followed ? rule_words(traffic) : '');
    const vessels = traffic?.vessels ?? [];
    set_hidden(rule, vessels.length === 0);
    set_hidden(region, vessels.length === 0);
    const now = vessels.map((vessel) => row_of(vessel));
    const there = new Set(vessels.map(({ mmsi }) => mmsi));
    for (const mmsi of rows.keys()) if (!there.has(mmsi)) rows.delete(mmsi);
    if (traffic !== null) for (const row of now) fill(row, traffic);
    keep_order(body, now);
  };
  const fill = ({ node: tr, name, cells, vessel }: Row, traffic: Traffic): void => {
    tr.classList.toggle('marked', vessel.alarm !== null);
    set_text(name, name_of(vessel));
    name.setAttribute('aria-label', `${name_of(vessel)}, show on the map`);
    const approach = vessel.told;
    const limit = limit_words(vessel, traffic);
    const bearing = look.direction(vessel.bearing_deg);
    const texts = [
      approach === null ? no_approach(vessel) : where_words(approach),
      approach === null ? NOT_KNOWN : when_words(approach),
      limit === '' ? '' : `! ${limit}`,
      movement_words(vessel, look),
      `${distance_text(vessel.distance_m)}, ${bearing} of it`,
      kind_of(vessel),
      report_words(vessel),
    ];
    texts.forEach((words, i) => set_text(cells[i] ?? tr, words));
  };
  return { node, show };
}

function title_words(traffic: Traffic | null, trouble: string, look: Desk['look']): string {
  if (trouble !== '') return 'Vessels: not known';
  if (traffic === null) return 'Vessels';
  if (traffic.sources.length === 0) return 'Vessels: no AIS log is given';
  const at = `Vessels at ${look.time(Date.parse(traffic.at))} ${look.zone_name}`;
  const count = traffic.vessels.length;
  const marked = traffic.vessels.filter(({ alarm }) => alarm !== null).length;
  if (count === 0) return `${at}: none`;
  return `${at}: ${count}${marked > 0 ? `, ${marked} marked` : ''}`;
}

function rule_words({ limits, rule }: Traffic): string {
  const near = `${distance_text(limits.cpa_m)} in the next ${short_span(limits.tcpa_s)}`;
  return (
    `Marked: will pass the site or a turbine nearer than ${near}, or lies nearer. ` +
    'Closest approach: with the speed and course of the last report. A vessel whose last report ' +
    `is old is shown where it last was. The dashes on the map are the way in ` +
    `${short_span(rule.way_s)}. Small craft may carry no AIS. Not for navigation.`
  );
}

const where_words = (approach: Approach): string =>
  `${distance_text(approach.cpa_m)} from ${approach.turbine ?? 'the site'}`;

function when_words({ passing, tcpa_s }: Approach): string {
  if (passing === 'still') return 'lies still';
  const span = short_span(tcpa_s);
  return passing === 'closing' ? `in ${span}` : `past, ${span} ago`;
}

const no_approach = ({ state }: Vessel): string =>
  state === 'old' ? 'not told: old' : 'not told: course or speed not known';

function report_words({ age_s, state, dead_reckoned }: Vessel): string {
  const age = `${short_span(age_s)} before`;
  if (state === 'old') return `${age}, old`;
  return dead_reckoned ? `${age}, carried on` : age;
}

/** Only moves what stands elsewhere, and gives back the focus that moving takes away. */
function keep_order(body: HTMLElement, rows: Row[]): void {
  const wanted = rows.map(({ node }) => node);
  const is_so =
    body.children.length === wanted.length && wanted.every((tr, i) => body.children[i] === tr);
  if (is_so) return;
  const focused = rows.find(({ name }) => name === document.activeElement);
  body.replaceChildren(...wanted);
  focused?.name.focus();
}
