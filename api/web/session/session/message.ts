// What the server says, read from JSON with suspicion: a field that is missing or of another kind
// becomes null or empty, one that is not known is left out. The contract: api/docs/session_wire.md.

import { as_list, as_number, as_object, as_text, type Json } from './json';
import { read_mounts, type Mount } from './thrust';

export { as_list, as_number, as_object, as_text, type Json };
export type Role = 'spectator' | 'operator' | 'supervisor';
/** A seat's number, or the name of an agent. */
export type Holder = number | string;

export interface Point {
  east_m: number;
  north_m: number;
  up_m: number;
}
export interface Waypoint extends Point {
  speed_m_s: number | null;
}
export interface Vehicle {
  vehicle: number;
  name: string;
  model: string;
  kind: string;
  length_m: number;
  width_m: number;
  thrusters: number;
  thruster_names: string[];
  mounts: Mount[]; // none: not told
  most_speed_m_s: number | null; // of shared; null: as fast as it can
  cruise_m_s: number | null;
  stand_off_m: number | null;
  fence_m: number | null;
  home: Point | null;
  tether: (Point & { length_m: number }) | null;
  zone: (Point & { radius_m: number }) | null; // watched for animals
}
export interface Structure {
  name: string;
  east_m: number;
  north_m: number;
  radius_m: number;
  bottom_m: number;
  top_m: number;
}
export interface Seat {
  seat: number;
  name: string;
  role: string;
  is_here: boolean;
  kept_until: number | null;
}
export type HelmState = 'free' | 'held' | 'requested' | 'allowed' | 'lost';
export interface Helm {
  vehicle: number;
  state: HelmState;
  holder: Holder | null;
  asker: Holder | null;
  until: number | null;
  mode: string;
  cause: string;
  home_at: number | null;
  is_raw: boolean;
}
export interface Run {
  state: string;
  by: Holder | null;
  time_s: number;
  /** Of a recording; a live run goes at its own pace. */
  is_playing: boolean;
  rate: number;
}
export interface Limit {
  name: string;
  value: number;
  limit: number;
  unit: string;
}
export interface Status {
  vehicle: number;
  doing: string;
  phase: string;
  cause: string;
  halt: string;
  task: string;
  tasks: string;
  reserve: number | string | null;
  home_by: number | string | null;
  waypoints: Waypoint[];
  limits: Limit[];
  /** Left; nothing: not told. */
  margin_s: number | null;
  /** All that stand, where the status tells them; nothing: they are told apart. */
  alarms: Omit<Alarm, 'vehicle'>[] | null;
  camera: CameraPointing | null;
}
/** What a camera saw last; its pixels are fetched. */
export interface Picture {
  vehicle: number;
  sensor: string;
  number: number;
  time_s: number;
  at: number; // of its moment, on the session's clock
  wide: number;
  high: number;
}
export interface CameraPointing {
  pan_deg: number;
  tilt_deg: number;
  zoom: number;
}
export interface Alarm {
  vehicle: number;
  with: string;
  level: string;
  cpa_m: number | null;
  cpa_s: number | null;
  mmsi: number | null;
  acknowledged_by: string; // empty: nobody has
}
export interface Action {
  number: number;
  at: string;
  time_s: number;
  step: number;
  seat: number | null;
  who: string;
  role: string;
  what: string;
  vehicle: Holder | null;
  before: string;
  after: string;
  taken: boolean;
  why: string;
}
export interface Answer {
  id: number;
  taken: boolean;
  reason: string;
  text: string;
  step: number | null;
  shaped: Shaped;
}
/** What the vehicle's own conduct made of a stick: null where it left it alone. */
export interface Shaped {
  speed: Shaping;
  stand_off: Shaping;
  fence: Shaping;
}
export type Shaping = number | boolean | null;

function holder_of(value: unknown): Holder | null {
  return typeof value === 'string' && value !== '' ? value : as_number(value);
}
function number_or_text(value: unknown): number | string | null {
  return typeof value === 'string' && value !== '' ? value : as_number(value);
}
function list_of<T>(value: unknown, read: (it: Json) => T | null): T[] {
  const made: T[] = [];
  for (const it of as_list(value)) {
    const object = as_object(it);
    const read_it = object === null ? null : read(object);
    if (read_it !== null) made.push(read_it);
  }
  return made;
}

export function read_point(value: unknown): Point | null {
  const it = as_object(value);
  if (it === null) return null;
  const east_m = as_number(it.east_m);
  const north_m = as_number(it.north_m);
  if (east_m === null || north_m === null) return null;
  return { east_m, north_m, up_m: as_number(it.up_m) ?? 0 };
}
/** Each as east, north, up. */
export function read_nodes(value: unknown): Point[] {
  const nodes: Point[] = [];
  for (const one of as_list(value)) {
    const [east_m, north_m, up_m] = as_list(one).map(as_number);
    if (east_m != null && north_m != null && up_m != null) nodes.push({ east_m, north_m, up_m });
  }
  return nodes;
}
export function read_waypoints(value: unknown): Waypoint[] {
  return list_of(value, (it) => {
    const point = read_point(it);
    return point && { ...point, speed_m_s: as_number(it.speed_m_s) };
  });
}

export function read_vehicle(it: Json): Vehicle | null {
  const vehicle = as_number(it.vehicle);
  if (vehicle === null) return null;
  const tether = as_object(it.tether);
  const anchor = read_point(tether);
  const zone = as_object(it.zone);
  const centre = read_point(zone);
  const thruster_names = as_list(it.thruster_names).map(as_text);
  return {
    vehicle,
    name: as_text(it.name) || `Vehicle ${vehicle}`,
    model: as_text(it.model),
    kind: as_text(it.kind).toLowerCase(),
    length_m: as_number(it.length_m) ?? 1,
    width_m: as_number(it.width_m) ?? 0.6,
    thrusters: as_number(it.thrusters) ?? thruster_names.length,
    thruster_names,
    mounts: read_mounts(it.mounts),
    most_speed_m_s: as_number(it.most_speed_m_s),
    cruise_m_s: as_number(it.cruise_m_s),
    stand_off_m: as_number(it.stand_off_m),
    fence_m: as_number(it.fence_m),
    home: read_point(it.home),
    tether: anchor && { ...anchor, length_m: as_number(tether?.length_m) ?? 0 },
    zone: centre && { ...centre, radius_m: as_number(zone?.radius_m) ?? 0 },
  };
}
export function read_vehicles(value: unknown): Vehicle[] {
  return list_of(value, read_vehicle);
}
export function read_structures(value: unknown): Structure[] {
  return list_of(value, (it) => {
    const point = read_point(it);
    return (
      point && {
        name: as_text(it.name),
        east_m: point.east_m,
        north_m: point.north_m,
        radius_m: as_number(it.radius_m) ?? 1,
        bottom_m: as_number(it.bottom_m) ?? 0,
        top_m: as_number(it.top_m) ?? 0,
      }
    );
  });
}
export function read_seats(value: unknown): Seat[] {
  return list_of(value, (it) => {
    const seat = as_number(it.seat);
    if (seat === null) return null;
    return {
      seat,
      name: as_text(it.name) || `Seat ${seat}`,
      role: as_text(it.role),
      is_here: it.is_here !== false,
      kept_until: as_number(it.kept_until),
    };
  });
}
const HELM_STATES: readonly string[] = ['free', 'held', 'requested', 'allowed', 'lost'];
export function read_helm(it: Json): Helm | null {
  const vehicle = as_number(it.vehicle);
  const state = as_text(it.state);
  if (vehicle === null || !HELM_STATES.includes(state)) return null;
  return {
    vehicle,
    state: state as HelmState,
    holder: holder_of(it.holder),
    asker: holder_of(it.asker),
    until: as_number(it.until),
    mode: as_text(it.mode),
    cause: word_of(it.cause),
    home_at: as_number(it.home_at),
    is_raw: it.is_raw === true,
  };
}
export function read_helms(value: unknown): Helm[] {
  return list_of(value, read_helm);
}
export function read_run(it: Json): Run {
  return {
    state: as_text(it.state),
    by: holder_of(it.by),
    time_s: as_number(it.time_s) ?? 0,
    is_playing: it.is_playing === true,
    rate: as_number(it.rate) ?? 1,
  };
}
/** A word of the wire; `none` says that there is nothing to say. */
function word_of(value: unknown): string {
  const text = as_text(value);
  return text === 'none' ? '' : text;
}
export function read_statuses(value: unknown): Status[] {
  return list_of(value, read_status);
}
/** What of a status changes each second, of several vehicles: [vehicle, reserve, margin_s] each. */
export function read_reserves(value: unknown): Pick<Status, 'vehicle' | 'reserve' | 'margin_s'>[] {
  return as_list(value).flatMap((row) => {
    const [of, reserve, margin_s] = as_list(row);
    const vehicle = as_number(of);
    if (vehicle === null) return [];
    return [{ vehicle, reserve: number_or_text(reserve), margin_s: as_number(margin_s) }];
  });
}
export function read_status(it: Json): Status | null {
  const vehicle = as_number(it.vehicle);
  if (vehicle === null) return null;
  return {
    vehicle,
    doing: as_text(it.doing),
    phase: word_of(it.phase),
    cause: word_of(it.cause),
    halt: word_of(it.halt),
    task: as_text(it.task),
    tasks: as_text(it.tasks),
    reserve: number_or_text(it.reserve),
    home_by: number_or_text(it.home_by),
    waypoints: read_waypoints(it.waypoints),
    margin_s: as_number(it.margin_s),
    alarms: Array.isArray(it.alarms)
      ? list_of(it.alarms, (alarm) => {
          const mmsi = as_text(alarm.mmsi);
          const name =
            as_text(alarm.with) ||
            as_text(alarm.name) ||
            (mmsi === '' ? 'a vessel' : `MMSI ${mmsi}`);
          return {
            with: name,
            level: as_text(alarm.level) || (alarm.is_lost === true ? 'lost from sight' : 'close'),
            cpa_m: as_number(alarm.cpa_m),
            cpa_s: as_number(alarm.cpa_s),
            mmsi: as_number(alarm.mmsi),
            acknowledged_by: as_text(alarm.acknowledged_by),
          };
        })
      : null,
    camera: read_camera(as_object(it.camera)),
    limits: list_of(it.limits, (limit) => {
      const value = as_number(limit.value);
      const most = as_number(limit.limit);
      if (value === null || most === null) return null;
      return { name: as_text(limit.name), value, limit: most, unit: as_text(limit.unit) };
    }),
  };
}
export function read_picture(it: Json): Picture | null {
  const [vehicle, number, at] = [as_number(it.vehicle), as_number(it.number), as_number(it.at)];
  const sensor = as_text(it.sensor);
  if (vehicle === null || number === null || at === null || sensor === '') return null;
  const time_s = as_number(it.time_s) ?? 0;
  return {
    vehicle,
    sensor,
    number,
    time_s,
    at,
    wide: as_number(it.wide) ?? 640,
    high: as_number(it.high) ?? 360,
  };
}
export function read_pictures(value: unknown): Picture[] {
  return list_of(value, read_picture);
}
function read_camera(it: Json | null): CameraPointing | null {
  if (it === null) return null;
  const [pan_deg, tilt_deg] = [as_number(it.pan_deg) ?? 0, as_number(it.tilt_deg) ?? 0];
  return { pan_deg, tilt_deg, zoom: as_number(it.zoom) ?? 1 };
}
export function read_action(it: Json): Action | null {
  const number = as_number(it.number);
  if (number === null) return null;
  const told = (value: unknown): string =>
    typeof value === 'object' && value !== null ? JSON.stringify(value) : as_text(value);
  return {
    number,
    at: as_text(it.at),
    time_s: as_number(it.time_s) ?? 0,
    step: as_number(it.step) ?? 0,
    seat: as_number(it.seat),
    who: as_text(it.who),
    role: as_text(it.role),
    what: as_text(it.what),
    vehicle: holder_of(it.vehicle),
    before: told(it.before),
    after: told(it.after),
    taken: it.taken !== false,
    why: as_text(it.why),
  };
}
export function read_actions(value: unknown): Action[] {
  return list_of(value, read_action);
}
export function read_answer(it: Json): Answer | null {
  const id = as_number(it.id);
  if (id === null) return null;
  const listed = as_list(it.shaped).map(as_text); // also taken: a list of names
  const shaped = as_object(it.shaped) ?? {};
  const shaping = (name: string): Shaping => {
    const value = shaped[name];
    if (typeof value === 'boolean') return value ? true : null;
    return as_number(value) ?? (listed.includes(name) ? true : null);
  };
  return {
    id,
    taken: it.taken === true,
    reason: as_text(it.reason),
    text: as_text(it.text),
    step: as_number(it.step),
    shaped: { speed: shaping('speed'), stand_off: shaping('stand_off'), fence: shaping('fence') },
  };
}
