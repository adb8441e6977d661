// What is looked at, and how: the whole of it stands in the address, so that a link shows the same.
import type { Directions, SpeedUnit } from './look/units';
import type { Place } from './position';
import { NO_TRIAL, type Trial } from './trial';

export type { Place };

export type Palette = 'day' | 'dusk' | 'night';
export type Panel = 'decide' | 'place' | 'what_if';

export interface ViewValues {
  site: string; // '' until the server has named its sites
  at_ms: number | null; // the slider's hour; null: now, as the server has it
  depth_m: number;
  place: Place | null; // null: the site's own
  panel: Panel;
  map: (Place & { zoom: number }) | null; // null: all that lies at the site
  cells: string; // the product whose cells the map shows; '' none
  palette: Palette;
  speed: SpeedUnit;
  clock: 'utc' | 'site';
  directions: Directions;
}
/** What of the view changed; "forecast": another one is in force; "server": it went or is back;
    "trial": what is tried out on the map. */
export type Changed = ReadonlySet<keyof ViewValues | 'sites' | 'forecast' | 'server' | 'trial'>;

/** What a person keeps from one view to the next. */
export const KEPT = ['palette', 'speed', 'clock', 'directions'] as const;
export type Kept = Pick<ViewValues, (typeof KEPT)[number]>;

export function first_view(kept: Partial<Kept> = {}): ViewValues {
  return {
    site: '',
    at_ms: null,
    depth_m: 5,
    place: null,
    panel: 'decide',
    map: null,
    cells: '',
    palette: 'day',
    speed: 'm/s',
    clock: 'utc',
    directions: 'degrees',
    ...kept,
  };
}

const one_of = <T extends string>(text: string | null, of: readonly T[], otherwise: T): T =>
  of.find((value) => value === text) ?? otherwise;

/** Takes of a link what is sound, and `otherwise` for the rest. */
export function read_hash(hash: string, otherwise: ViewValues): ViewValues {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const at_ms = Date.parse(given.get('at') ?? '');
  const depth_m = Number(given.get('depth') ?? NaN);
  const place = read_place(given.get('place'));
  const map = read_place(given.get('map'));
  const zoom = Number(given.get('map')?.split(',')[2] ?? NaN);
  return {
    site: given.get('site') ?? otherwise.site,
    at_ms: Number.isFinite(at_ms) ? at_ms : otherwise.at_ms,
    depth_m: Number.isFinite(depth_m) && depth_m >= 0 ? depth_m : otherwise.depth_m,
    place: place ?? otherwise.place,
    panel: one_of(given.get('panel'), ['decide', 'place', 'what_if'], otherwise.panel),
    map: map !== null && zoom > 0 && zoom < 30 ? { ...map, zoom } : otherwise.map,
    cells: given.get('cells') ?? otherwise.cells,
    palette: one_of(given.get('palette'), ['day', 'dusk', 'night'], otherwise.palette),
    speed: one_of(given.get('speed'), ['m/s', 'knots'], otherwise.speed),
    clock: one_of(given.get('clock'), ['utc', 'site'], otherwise.clock),
    directions: one_of(given.get('directions'), ['degrees', 'compass'], otherwise.directions),
  };
}

function read_place(text: string | null): Place | null {
  const [latitude, longitude] = (text ?? '').split(',');
  const latitude_deg = latitude ? Number(latitude) : NaN;
  const longitude_deg = longitude ? Number(longitude) : NaN;
  const sound = Math.abs(latitude_deg) <= 90 && Math.abs(longitude_deg) <= 180;
  return sound ? { longitude_deg, latitude_deg } : null;
}

export function hash_of(values: ViewValues): string {
  const place = (of: Place): string =>
    `${of.latitude_deg.toFixed(5)},${of.longitude_deg.toFixed(5)}`;
  const said: string[] = [];
  const say = (key: string, text: string): unknown =>
    said.push(`${key}=${encodeURIComponent(text).replace(/%(2C|3A|2F)/g, decodeURIComponent)}`);
  if (values.site !== '') say('site', values.site);
  if (values.at_ms !== null) say('at', time_of_ms(values.at_ms));
  say('depth', String(values.depth_m));
  if (values.place !== null) say('place', place(values.place));
  say('panel', values.panel);
  if (values.map !== null) say('map', `${place(values.map)},${values.map.zoom.toFixed(2)}`);
  if (values.cells !== '') say('cells', values.cells);
  for (const key of KEPT) say(key, values[key]);
  return `#${said.join('&')}`;
}

/** As the server writes times: whole seconds, Z. */
export function time_of_ms(utc_ms: number): string {
  return new Date(utc_ms).toISOString().replace(/\.\d+Z$/, 'Z');
}

/** The view, with those who want to hear of its changes. */
export class View {
  /** Of the view alone: no link holds it. */
  trial: Trial = NO_TRIAL;
  private readonly listeners: ((changed: Changed) => void)[] = [];

  constructor(private now: ViewValues) {}

  get values(): Readonly<ViewValues> {
    return this.now;
  }
  set(some: Partial<ViewValues>): void {
    const next = { ...this.now, ...some };
    const keys = Object.keys(next) as (keyof ViewValues)[];
    const changed = keys.filter(
      (key) => JSON.stringify(next[key]) !== JSON.stringify(this.now[key]),
    );
    if (changed.length === 0) return;
    this.now = next;
    this.tell(new Set(changed));
  }
  try_out(trial: Trial): void {
    if (JSON.stringify(trial) === JSON.stringify(this.trial)) return;
    this.trial = trial;
    this.tell(new Set(['trial']));
  }
  tell(changed: Changed): void {
    for (const listener of this.listeners) listener(changed);
  }
  listen(listener: (changed: Changed) => void): void {
    this.listeners.push(listener);
  }
}
