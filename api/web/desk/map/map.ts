// The map of the site: a camera over layers of SVG; hands move it, a click chooses the place.
import type { Desk } from '../look/desk';
import { button, drawn, element, set_hidden, set_text } from '../../look/element';
import { hour_of } from '../look/hours';
import type { SiteMap } from '../server/answers';
import { words_of } from '../look/top';
import { Refused } from '../server/server';
import type { Place } from '../view';
import { draw_bed, fetch_bed, type Bed } from './bed';
import type { Box } from './cells';
import { cells_layer } from './cells_layer';
import { coast_path, fetch_coast } from './coast';
import { column_table } from './column_table';
import { fetch_field, weather_at, type Field, type Weather } from './field';
import { listen_to_hands } from './hands';
import { beside, box_around, boxes_of_texts } from './labels';
import { legend, type Shown } from './legend';
import {
  fit,
  place_at,
  projection_of,
  scale_bar,
  zoomed,
  type Camera,
  type Size,
} from './projection';
import { draw_place, draw_things, draw_water, screen } from './scene';
import { draw_trial } from './trial_signs';
import { depth_choice, place_choice } from './tools';
import { vessels_layer } from './vessels_layer';

const SNAP_PX = 14;
const THING_PX = 8; // half of a sign that no name covers
const LOOK_AGAIN_MS = 600_000; // zones come into force
const TRY_AGAIN_MS = 20_000;
const COAST_ZOOM = 8.5; // some hundred kilometres
const NO_FIELD: Field = { of: { currents: [], wind: [], waves: [] }, refused: [] };

export function mapPart(desk: Desk): HTMLElement {
  const { view, server, look } = desk;
  let site: SiteMap | null = null;
  let seen_ms = NaN; // when the site was described, by the server's clock
  let field = NO_FIELD;
  let bed: Bed | null = null;
  let size = { width: 0, height: 0 };
  const shown: Shown = {
    current: true,
    wind: true,
    waves: true,
    vessels: true,
    bed: true,
    names: true,
  };

  const coast = drawn('path', { class: 'land' });
  const depths = drawn('g', { class: 'bed' });
  const [things, trial] = [drawn('g'), drawn('g')];
  const [water, place] = [drawn('g', { class: 'water' }), drawn('g')];
  const cells = cells_layer(desk);
  const vessels = vessels_layer(desk, (at) => view.set({ map: { ...camera(), ...at } }));
  const aim = drawn('path', { class: 'aim', d: 'M-9,0 H9 M0,-9 V9' });
  const bar = drawn('g', { class: 'scale-bar' });
  const picture = drawn(
    'svg',
    {
      class: 'picture',
      tabindex: 0,
      role: 'application',
      'aria-label':
        'Map, north up. Arrow keys move it, plus and minus zoom, 0 shows all, Enter takes the ' +
        'place in the middle. The table of columns says the same in words.',
    },
    ...[depths, coast, things, trial, cells.node, water, vessels.node, place, aim, bar],
  );
  const says = element('p', { class: 'map-says', role: 'status', hidden: true });
  /** Where to look while the site is not described yet. */
  const named = (): Place | null =>
    server.sites?.sites.find(({ id }) => id === view.values.site)?.place ?? null;
  const camera = (): Camera =>
    view.values.map ?? fit(places_of(site, view.values.place ?? named()), size);
  const weather = (at: Place): Weather =>
    weather_at(field, at, hour_of(desk) ?? NaN, view.values.depth_m);

  const table = column_table(desk, () => site, weather);
  const signs = legend(desk, shown, () => draw());
  signs.node.querySelector('.note')?.before(cells.legend);
  const depth = depth_choice(desk);
  const where = place_choice(desk);

  const draw_vessels = (): void => {
    if (size.width < 2) return;
    const to = projection_of(camera(), size);
    vessels.draw({
      to,
      box: box_of(camera(), size),
      is_shown: shown.vessels,
      with_names: shown.names,
      taken: () => [
        ...beside(size),
        ...[things, water].flatMap((group) => boxes_of_texts(group)),
        ...[...(site?.turbines ?? []), ...(site?.columns ?? [])].map((thing) =>
          box_around(screen(to, thing), THING_PX),
        ),
      ],
    });
  };
  const draw_hour = (): void => {
    table.show();
    if (site === null) {
      water.replaceChildren();
      draw_vessels();
    }
    if (site === null || size.width < 2) return;
    const to = projection_of(camera(), size);
    cells.draw(to, box_of(camera(), size));
    draw_water(water, site, to, shown, look, weather);
    draw_vessels();
    signs.say(
      weather(site.columns[0] ?? { longitude_deg: NaN, latitude_deg: NaN }).current_depth_m,
    );
  };
  const draw = (): void => {
    if (size.width < 2) return;
    const from = camera();
    const to = projection_of(from, size);
    if (bed === null || !shown.bed) depths.replaceChildren();
    else draw_bed(depths, bed, to, size);
    coast.setAttribute('d', coast_path(to, box_of(from, size)));
    if (site === null) things.replaceChildren();
    else draw_things(things, site, to, shown.names, look, seen_ms);
    draw_trial(trial, view.trial, to);
    draw_place(place, view.values.place ?? site?.place ?? null, to);
    aim.setAttribute('transform', `translate(${size.width / 2} ${size.height / 2})`);
    draw_bar(bar, from, size.height);
    draw_hour();
  };
  let frame = 0;
  const draw_soon = (): void => {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(draw);
  };
  const say = (words: string): void => {
    set_text(says, words);
    set_hidden(says, words === '');
  };

  const load_coast = async (): Promise<void> => {
    try {
      await fetch_coast(server);
      draw();
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem; // a map without coast shows the site
    }
  };
  const load_bed = async (id: string): Promise<void> => {
    const came = await fetch_bed(server, id);
    if (view.values.site !== id) return;
    bed = typeof came === 'string' ? null : came;
    signs.say_bed(came);
    draw();
  };
  const show_site = (next: SiteMap | null): void => {
    // An old forecast's arrows do not stay, and never those of another site.
    const is_same = next?.id === site?.id && in_force(next) === in_force(site);
    if (!is_same) field = NO_FIELD;
    if (next?.id !== site?.id) {
      bed = null;
      signs.say_bed(null);
    }
    site = next;
    seen_ms = server.now_ms();
    depth.show(site);
    where.show(site);
    draw();
  };
  let asked = 0;
  let asked_ms = 0;
  const is_due = (): boolean =>
    Date.now() - asked_ms > (site === null ? TRY_AGAIN_MS : LOOK_AGAIN_MS);
  const load = async (): Promise<void> => {
    asked += 1;
    const mine = asked;
    asked_ms = Date.now();
    const id = view.values.site;
    if (site !== null && site.id !== id) {
      show_site(null);
      say('');
    }
    if (id === '') {
      say(words_of(desk));
      return;
    }
    try {
      const next = await server.site(id);
      if (mine !== asked) return;
      const has_field = field !== NO_FIELD && field.refused.length === 0;
      show_site(next);
      if (bed === null) void load_bed(id);
      if (has_field && field !== NO_FIELD) return; // it is only the site that was looked at again
      const came = await fetch_field(server, next);
      if (mine !== asked) return;
      field = came;
      say(field.refused.join(' '));
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (mine !== asked) return;
      if (site === null) say(`The map has no data: ${problem.detail}`);
    }
    draw();
    void cells.load();
    void load_coast(); // last: it weighs more than all the rest
  };

  listen_to_hands(picture, {
    camera,
    size: () => size,
    move: (map) => view.set({ map }),
    show_all: () => view.set({ map: null }),
    choose: (x, y) => {
      const to = projection_of(camera(), size);
      const near = [...(site?.columns ?? []), ...(site?.turbines ?? [])].find((thing) => {
        const [right, down] = screen(to, thing);
        return Math.hypot(right - x, down - y) < SNAP_PX;
      });
      const { longitude_deg, latitude_deg } = near ?? place_at(camera(), size, x, y);
      // Who tries something out goes on with that.
      const panel = view.values.panel === 'what_if' ? 'what_if' : 'place';
      view.set({ place: { longitude_deg, latitude_deg }, panel });
    },
  });
  const zoom = (by: number): void =>
    view.set({ map: zoomed(camera(), size, by, size.width / 2, size.height / 2) });
  const buttons = element(
    'div',
    { class: 'map-zoom', role: 'group', 'aria-label': 'Zoom' },
    button('+', () => zoom(1), { 'aria-label': 'Zoom in' }),
    button('−', () => zoom(-1), { 'aria-label': 'Zoom out' }),
    button('Coast', () => view.set({ map: { ...camera(), zoom: COAST_ZOOM } })),
    button('All', () => view.set({ map: null }), { 'aria-label': 'Show all of the site' }),
  );

  desk.onChange((changed) => {
    if (changed.has('site') || changed.has('forecast')) void load();
    else if (changed.has('sites') && (view.values.site === '' || is_due())) void load();
    else if (changed.has('server') && server.link.is === 'there' && site === null) void load();
    if (changed.has('map') || changed.has('place') || changed.has('trial')) draw_soon();
    else if (!changed.has('panel')) draw_hour();
    if (changed.has('depth_m')) depth.show(site);
    if (changed.has('place')) where.show(site);
  });
  new ResizeObserver(() => {
    size = { width: picture.clientWidth, height: picture.clientHeight };
    draw();
  }).observe(picture);
  void load();

  const notes = element('div', { class: 'map-notes' }, vessels.says, cells.says);
  return element(
    'div',
    { class: 'map' },
    element('div', { class: 'map-tools' }, depth.node, where.node, cells.choice, buttons),
    element('div', { class: 'map-view' }, picture, says, notes, signs.node),
    vessels.list,
    table.node,
    cells.table,
  );
}

const in_force = (site: SiteMap | null): string => site?.forecast?.instance ?? '';

function box_of(from: Camera, size: Size): Box {
  const { longitude_deg: west, latitude_deg: north } = place_at(from, size, 0, 0);
  const corner = place_at(from, size, size.width, size.height);
  return { west, north, east: corner.longitude_deg, south: corner.latitude_deg };
}

function places_of(site: SiteMap | null, place: Place | null): Place[] {
  const of_points = (points: [number, number][]): Place[] =>
    points.map(([longitude_deg, latitude_deg]) => ({ longitude_deg, latitude_deg }));
  const places = [
    ...(site === null || site.place === null ? [] : [site.place]),
    ...(site?.columns ?? []),
    ...(site?.turbines ?? []),
    ...(site?.cables ?? []).flatMap(({ points }) => of_points(points)),
    ...(site?.areas ?? []).flatMap(({ ring }) => of_points(ring)),
  ];
  return places.length > 0 ? places : [place ?? { longitude_deg: 0, latitude_deg: 50 }];
}

function draw_bar(at: SVGGElement, camera: Camera, height: number): void {
  const { px, text } = scale_bar(camera, 120);
  at.replaceChildren(
    drawn('path', { d: `M12,${height - 18} v6 h${px} v-6` }),
    drawn('text', { x: 12, y: height - 22 }, text),
  );
}
