// What is drawn on the map: land, zones, cables, turbines, columns with their water, the place.
import type { GeoProjection } from 'd3-geo';
import type { Look } from '../look/look';
import { drawn } from '../../look/element';
import { is_known } from '../look/units';
import type { Area, SiteMap } from '../server/answers';
import type { Place } from '../view';
import { beside_barbs_px, current_arrow, wave_arrow, wind_barb } from './arrows';
import type { Weather } from './field';
import { place_sign, port_sign, turbine_sign, type Shown } from './legend';

export type Point = [number, number];
const AREA_NAME_PX = 90;

export function line_through(points: Point[], to: GeoProjection): string {
  return points
    .map((point) => to(point))
    .filter((point) => point !== null)
    .map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(1)},${y.toFixed(1)}`)
    .join('');
}

/** The things that do not change with the hour. */
export function draw_things(
  at: SVGGElement,
  site: SiteMap,
  to: GeoProjection,
  names: boolean,
  look: Look,
  seen_ms: number, // when the server said what is in force
): void {
  const line = (points: Point[]): string => line_through(points, to);
  const made: SVGElement[] = [];
  for (const area of site.areas) {
    const shape = drawn('path', { class: `area ${area.kind}`, d: `${line(area.ring)}Z` });
    const words = area_words(area, look, seen_ms);
    shape.append(drawn('title', {}, `${words}\n${area.reason}`));
    made.push(shape);
    const corners = area.ring.map((point) => to(point)).filter((point) => point !== null);
    const west = Math.min(...corners.map(([x]) => x));
    const north = Math.min(...corners.map(([, y]) => y));
    const is_wide = Math.max(...corners.map(([x]) => x)) - west > AREA_NAME_PX;
    if (names && is_wide) made.push(text([west, north], 2, -6, words, 'name'));
  }
  for (const { id, points } of site.cables) {
    const cable = drawn('path', { class: 'cable', d: line(points) });
    cable.append(drawn('title', {}, `Cable ${id}`));
    made.push(cable);
  }
  const turbines = site.turbines.map((turbine) => ({ turbine, at: screen(to, turbine) }));
  const has_room = turbines.every(
    (a, i) =>
      i > 60 ||
      turbines.every((b, j) => i === j || Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) > 30),
  );
  for (const { turbine, at: here } of turbines) {
    const sign = turbine_sign(turbine.landing_deg);
    sign.append(drawn('title', {}, turbine_words(turbine, look)));
    made.push(drawn('g', { transform: `translate(${here})` }, sign));
    if (names && has_room) made.push(text(here, 0, -14, turbine.id, 'name middle'));
  }
  for (const port of site.ports) {
    const here = screen(to, port);
    made.push(drawn('g', { transform: `translate(${here})` }, port_sign()));
    if (names) made.push(text(here, 0, 22, port.name, 'name middle'));
  }
  at.replaceChildren(...made);
}

function turbine_words({ id, landing_deg }: SiteMap['turbines'][number], look: Look): string {
  return is_known(landing_deg)
    ? `${id}, boat landing on its ${look.direction(landing_deg)} side`
    : id;
}

/** Up, right, down, left: where words stand beside a column. */
const SIDES: readonly (readonly [number, number, string])[] = [
  [0, -12, 'middle'],
  [12, 5, 'start'],
  [0, 22, 'middle'],
  [-12, 5, 'end'],
];

/** Of the four sides the one that is farthest from all that points away from the column. */
export function free_side(directions_deg: (number | null)[]): number {
  const pointed = directions_deg.filter((degrees) => degrees !== null);
  const room = (side: number): number =>
    Math.min(180, ...pointed.map((degrees) => Math.abs(((degrees - side * 90 + 540) % 360) - 180)));
  return [0, 1, 2, 3].reduce((best, side) => (room(side) > room(best) ? side : best), 2);
}

export function area_words(area: Area, look: Look, seen_ms: number): string {
  const { id, kind, to_direction_deg, in_force_now, below_height_m } = area;
  const below = is_known(below_height_m) ? ` below ${look.metres(below_height_m)}` : '';
  const lane = `traffic lane, to ${look.direction(to_direction_deg)}`;
  const what = kind === 'traffic_lane' ? lane : `keep out${below}`;
  const when = `not in force at ${look.hour(seen_ms)} ${look.zone_name}`;
  return `${id}: ${what}${in_force_now ? '' : `, ${when}`}`;
}

const LABELS_UP_TO = 12;
const ARROWS_APART_PX = 46;
const NAMES_APART_PX = 90;

/** The things of the hour, at each column; barbs and wave arrows only where they have room. */
export function draw_water(
  at: SVGGElement,
  site: SiteMap,
  to: GeoProjection,
  shown: Shown,
  look: Look,
  weather_at: (place: Place) => Weather,
): void {
  const made: SVGElement[] = [];
  const taken: Point[] = [];
  const with_labels = shown.names && site.columns.length <= LABELS_UP_TO;
  for (const column of site.columns) {
    const here = screen(to, column);
    const weather = weather_at(column);
    const apart_px = Math.min(
      Infinity,
      ...taken.map(([x, y]) => Math.hypot(x - here[0], y - here[1])),
    );
    const has_room = apart_px > ARROWS_APART_PX;
    const signs: (SVGElement | null)[] = [];
    if (has_room) {
      taken.push(here);
      const is_south = column.latitude_deg < 0;
      if (shown.waves) {
        const wind_from = shown.wind ? weather.wind_from_deg : null;
        const beside_px = beside_barbs_px(wind_from, weather.wave_from_deg, is_south);
        signs.push(wave_arrow(weather.wave_height_m, weather.wave_from_deg, beside_px));
      }
      if (shown.wind) signs.push(wind_barb(weather.wind_m_s, weather.wind_from_deg, is_south));
    }
    if (shown.current) signs.push(current_arrow(weather.current_m_s, weather.current_to_deg));
    signs.push(drawn('circle', { class: 'column', r: 4 }));
    made.push(
      drawn(
        'g',
        { transform: `translate(${here})` },
        ...signs.filter((sign) => sign !== null),
        drawn('title', {}, [column.location, ...lines_of(weather, shown, look)].join('\n')),
      ),
    );
    if (!shown.names || apart_px < NAMES_APART_PX) continue;
    const lines = is_known(column.bed_m) ? [`bed ${look.metres(column.bed_m)}`] : [];
    if (!with_labels) {
      const [right, down, anchor] = SIDES[
        free_side([weather.wind_from_deg, weather.wave_from_deg, weather.current_to_deg])
      ] ?? [0, 22, 'middle'];
      made.push(...lines.map((line) => text(here, right, down, line, anchor)));
      continue;
    }
    // Words stand to leeward, where no barb is.
    const is_left = (weather.wind_from_deg ?? 270) < 180;
    lines.push(...lines_of(weather, shown, look));
    lines.forEach((line, i) =>
      made.push(text(here, is_left ? -14 : 14, 18 + 16 * i, line, is_left ? 'end' : 'start')),
    );
  }
  at.replaceChildren(...made);
}

function lines_of(weather: Weather, shown: Shown, look: Look): string[] {
  const lines: string[] = [];
  if (shown.current) {
    lines.push(
      `current ${look.speed(weather.current_m_s, 2)} to ${look.direction(weather.current_to_deg)}`,
    );
  }
  if (shown.wind) {
    lines.push(
      `wind ${look.speed(weather.wind_m_s)} from ${look.direction(weather.wind_from_deg)}`,
    );
  }
  if (shown.waves) {
    const height = look.metres(weather.wave_height_m, 1);
    lines.push(`waves ${height} from ${look.direction(weather.wave_from_deg)}`);
  }
  return lines;
}

export function draw_place(at: SVGGElement, place: Place | null, to: GeoProjection): void {
  if (place === null) at.replaceChildren();
  else
    at.replaceChildren(drawn('g', { transform: `translate(${screen(to, place)})` }, place_sign()));
}

/** Whole tenths of a pixel; far outside where the projection has no answer. */
export function screen(to: GeoProjection, { longitude_deg, latitude_deg }: Place): Point {
  const [x, y] = to([longitude_deg, latitude_deg]) ?? [-1e4, -1e4];
  return [Math.round(x * 10) / 10, Math.round(y * 10) / 10];
}

export function text(
  [x, y]: Point,
  right: number,
  down: number,
  words: string,
  kind: string,
): SVGElement {
  return drawn('text', { class: kind, x: x + right, y: y + down }, words);
}
