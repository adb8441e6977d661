// The chosen place: current by depth, wind, waves and tide, over all hours and at the slider's.
import type { Desk } from '../look/desk';
import { element, scroll_region, set_hidden, set_text } from '../../look/element';
import { hour_of } from '../look/hours';
import type { Picture } from '../look/plot';
import { words_of } from '../look/top';
import { place_text } from '../look/units';
import type { SiteMap } from '../server/answers';
import { time_index, type Column } from '../server/coverage';
import { Refused } from '../server/server';
import { depth_time_chart } from './depth_time_chart';
import { datum_words, facts_of, level_table } from './facts';
import { hodograph_chart } from './hodograph_chart';
import { modelsPart } from './models_part';
import { tide_series, wave_series, wind_series } from './over_time';
import { largest_m_s, profile_at, type Level } from './profile';
import { profile_chart, type Shown } from './profile_chart';
import { series_chart, type Series } from './series_chart';
import { slackPart } from './slack';
import { fetch_water, NO_TIDE, said_by_all, type Told, type Water } from './water';

export function placePart(desk: Desk): HTMLElement {
  const { view, server, look } = desk;
  let site: SiteMap | null = null;
  let water: Water | null = null;
  let levels: Level[] = [];
  let most_m_s = 0;

  const head = element('h2');
  const when = element('p', { class: 'when' });
  const says = element('p', { class: 'note', role: 'status' });
  const facts = element('dl', { class: 'facts' });
  const column_of = (kind: keyof Water): Column | null => water?.[kind].column ?? null;
  const shown = (): Shown | null =>
    column_of('currents') === null ? null : { levels, most_m_s, depth_m: view.values.depth_m };
  const series = (kind: keyof Water, of: (column: Column) => Series) => (): Series | null => {
    const column = column_of(kind);
    return column === null ? null : of(column);
  };

  const profile = profile_chart(desk, shown);
  const hodograph = hodograph_chart(desk, shown);
  const depths = depth_time_chart(
    desk,
    () => column_of('currents'),
    () => view.values.depth_m,
  );
  const wind = series_chart(
    desk,
    'Wind',
    series('wind', (column) => wind_series(look, column)),
  );
  const waves = series_chart(
    desk,
    'Waves',
    series('waves', (column) => wave_series(look, column)),
  );
  const tide = series_chart(desk, 'Tide', series('tide', tide_series));
  const counted_from = element('p', { class: 'note' });
  const over_time = [depths, wind, waves, tide];

  const table = element('div');
  const in_numbers = element(
    'details',
    {},
    element('summary', {}, 'Current by depth as a table'),
    scroll_region('Current by depth as a table', table),
  );
  in_numbers.addEventListener('toggle', () => show_hour());

  const boxes: [keyof Water, HTMLElement, HTMLElement][] = [
    box_of('currents', 'Current by depth', [
      element(
        'div',
        { class: 'pair' },
        figure(profile, 'Line and dots: east. Dashes and diamonds: north. Bands: p10 to p90.'),
        figure(hodograph, 'Hodograph, to, seen from above. Arrow: at the depth of the map.'),
      ),
      in_numbers,
    ]),
    box_of('currents', 'Current over depth and time', [depths.node, depths.legend]),
    box_of('wind', 'Wind', [wind.node, wind.legend]),
    box_of('waves', 'Waves', [waves.node, waves.legend]),
    box_of('tide', 'Tide', [tide.node, tide.legend, counted_from]),
  ];

  const show_head = (): void => {
    const place = view.values.place ?? site?.place;
    if (place === undefined || place === null) {
      set_text(head, '');
      set_text(when, '');
      return;
    }
    const name = site === null ? '' : name_of(site, place.longitude_deg, place.latitude_deg);
    const where = place_text(place.longitude_deg, place.latitude_deg);
    set_text(head, name === '' ? where : `${name}: ${where}`);
    const at_ms = hour_of(desk);
    set_text(when, at_ms === null ? '' : `${look.time(at_ms)} ${look.zone_name}`);
  };

  const show_hour = (): void => {
    show_head();
    const at_ms = hour_of(desk);
    const column = column_of('currents');
    levels = column === null || at_ms === null ? [] : profile_at(column, time_index(column, at_ms));
    for (const each of over_time) each.mark(at_ms);
    if (water === null || at_ms === null) {
      facts.replaceChildren();
      return;
    }
    const list = facts_of(
      look,
      water,
      levels,
      view.values.depth_m,
      at_ms,
      site?.chart_datum ?? null,
    );
    const spoken = list.map(([name, value]) => `${name}: ${value}`);
    facts.replaceChildren(
      ...list.map(([name, value]) =>
        element('div', {}, element('dt', {}, name), element('dd', {}, value)),
      ),
    );
    profile.draw();
    hodograph.draw();
    profile.say(`Current by depth. ${spoken[0] ?? ''}. The table below has all depths.`);
    hodograph.say(`Hodograph. ${spoken[0] ?? ''}.`);
    for (const [pictured, word] of [
      [wind, 'Wind'],
      [waves, 'Waves'],
      [tide, 'Tide'],
    ] as const) {
      const of_it = spoken.filter((line) => line.startsWith(word)).join('. ');
      pictured.say(`${word} over the hours of the forecast. At the slider's hour: ${of_it}.`);
    }
    if (in_numbers.open) table.replaceChildren(level_table(look, levels));
  };
  const show = (): void => {
    for (const [kind, box, refused] of boxes) show_told(box, refused, water?.[kind] ?? null);
    most_m_s = column_of('currents') === null ? 0 : largest_m_s(column_of('currents') as Column);
    for (const each of over_time) each.draw();
    set_text(counted_from, datum_words(site?.chart_datum ?? null));
    show_hour();
  };
  let asked = 0;
  let of = ''; // the site and the place that the numbers belong to
  const load = async (): Promise<void> => {
    asked += 1;
    const mine = asked;
    const now = JSON.stringify([view.values.site, view.values.place]);
    if (now !== of) {
      // Never the numbers of one place under the name of another.
      of = now;
      water = null;
      if (site?.id !== view.values.site) site = null;
      show();
    }
    if (view.values.site === '') {
      set_text(says, words_of(desk));
      show();
      return;
    }
    set_text(says, 'Asking the server …');
    try {
      const next = await server.site(view.values.site);
      if (mine !== asked) return;
      site = next;
      show_head();
      const place = view.values.place ?? next.place;
      const forecast = server.forecast(next.id) ?? next.forecast;
      const came =
        forecast === null || place === null
          ? null
          : await fetch_water(server, next, forecast, place);
      if (mine !== asked) return;
      const all_refuse = came === null ? null : said_by_all(came);
      water = all_refuse === null ? came : null;
      const none = `No forecast is in force here. Make one: slackwater forecast --site ${next.id}`;
      const nearer = 'Choose a place nearer to a column, on the map or in its list.';
      const without = all_refuse === null ? none : `${all_refuse} ${nearer}`;
      set_text(says, water === null ? without : '');
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (mine !== asked) return;
      water = null;
      set_text(says, problem.detail);
    }
    show();
  };
  desk.onChange((changed) => {
    if (changed.has('place') || changed.has('site') || changed.has('forecast')) void load();
    else if (changed.has('server') && server.link.is === 'there') void load();
    else if (changed.has('sites') && view.values.site === '') set_text(says, words_of(desk));
    else if (
      ['at_ms', 'speed', 'directions', 'clock', 'sites'].some((key) => changed.has(key as 'at_ms'))
    ) {
      show_hour();
    } else if (changed.has('depth_m')) {
      depths.draw();
      show_hour();
    }
  });
  void load();
  const nodes = boxes.map(([, box]) => box.parentElement ?? box);
  return element(
    'div',
    { class: 'place-part' },
    head,
    when,
    says,
    facts,
    slackPart(desk),
    ...nodes,
    modelsPart(desk),
  );
}

function figure(chart: Picture, words: string): HTMLElement {
  return element('figure', {}, chart.node, element('figcaption', {}, words));
}

/** A heading, what is drawn, and in its place what the server said. */
function box_of(
  kind: keyof Water,
  title: string,
  inside: Node[],
): [keyof Water, HTMLElement, HTMLElement] {
  const box = element('div', { hidden: true }, ...inside);
  const refused = element('p', { class: 'problem', hidden: true });
  element('section', {}, element('h3', {}, title), refused, box);
  return [kind, box, refused];
}

function show_told(box: HTMLElement, refused: HTMLElement, told: Told | null): void {
  if (box.parentElement !== null) set_hidden(box.parentElement, told === null);
  set_hidden(box, told === null || told.column === null);
  set_hidden(refused, told === null || told.refused === null);
  set_text(refused, told?.refused ?? '');
  refused.classList.toggle('problem', told?.refused !== NO_TIDE);
}

function name_of(site: SiteMap, longitude_deg: number, latitude_deg: number): string {
  const is_here = (at: { longitude_deg: number; latitude_deg: number }): boolean =>
    Math.hypot(at.longitude_deg - longitude_deg, at.latitude_deg - latitude_deg) < 2e-5;
  const turbine = site.turbines.find(is_here);
  const column = site.columns.find(is_here);
  const names = [
    ...(turbine === undefined ? [] : [`Turbine ${turbine.id}`]),
    ...(column === undefined ? [] : [`Column ${column.location}`]),
  ];
  return names.join(', ');
}
