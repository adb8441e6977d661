// The session as the server tells it. Nothing is decided or guessed here: each message replaces
// what it is about, and a message or a field that is not known is left out.
import { read_vessels, read_weather, type Vessel, type Weather } from './around';
import type { Frame, Pose } from './frame';
import * as read from './message';
import type {
  Action,
  Alarm,
  Helm,
  Holder,
  Json,
  Picture,
  Point,
  Role,
  Run,
  Seat,
  Status,
  Structure,
  Vehicle,
} from './message';
import { read_bed, type Bed } from './bed';
import { read_looks, read_notes, type Look, type Note } from './gathering';
import { read_turbines, type Turbines } from './farm';
import {
  read_findings,
  read_surfaces,
  take_covered,
  type Finding,
  type Surface,
} from './inspected';
import { read_cables, read_moorings, type Cable, type Mooring } from './laid';
import { read_playback, type Playback } from './playback';
import { read_sea, type Sea } from './sea';
import { read_thrust, read_thrusts } from './thrust';

const ACTIONS_KEPT = 400;
const WORDS_KEPT = 50;

export interface Said {
  name: string;
  text: string;
}

export interface Session {
  id: string;
  seat: number | null;
  name: string;
  role: Role;
  start_utc_ms: number; // not a number until it is told
  step_s: number;
  vehicles: Map<number, Vehicle>;
  structures: Structure[];
  seats: Map<number, Seat>;
  run: Run;
  helms: Map<number, Helm>;
  statuses: Map<number, Status>;
  poses: Map<number, Pose>;
  alarms: Map<string, Alarm>;
  /** Of each camera the last, by vehicle and sensor. */
  pictures: Map<string, Picture>;
  weather: Weather | null;
  /** Null: calm, or a recording whose waves nobody knows any more. */
  sea: Sea | null;
  /** Null: nobody knows it, or it is not told. */
  bed: Bed | null;
  cables: Cable[];
  moorings: Mooring[];
  vessels: Vessel[];
  turbines: Turbines | null;
  /** Of wind, waves and current, its name; null: they are made up; undefined: not told. */
  forecast: string | null | undefined;
  /** Why a recording tells nothing of waves, wind, current, turbines, traffic; empty: it does. */
  water_missing: string;
  /** Of each vehicle on a tether its nodes, from the top to it. */
  lines: Map<number, Point[]>;
  /** What its thrusters do, from -1 to 1, by vehicle. */
  thrusts: Map<number, number[]>;
  /** What is inspected, by vehicle and surface. */
  surfaces: Map<string, Surface>;
  findings: Map<number, Finding[]>;
  looks: Look[];
  notes: Note[];
  actions: Action[];
  said: Said[];
  frame: Frame | null;
  frames_left_out: number;
  /** Of a log that is watched again; null: the run is live. */
  playback: Playback | null;
}

export function empty_session(): Session {
  return {
    id: '',
    seat: null,
    name: '',
    role: 'spectator',
    start_utc_ms: Number.NaN,
    step_s: 0,
    vehicles: new Map(),
    structures: [],
    seats: new Map(),
    run: { state: '', by: null, time_s: 0, is_playing: false, rate: 1 },
    helms: new Map(),
    statuses: new Map(),
    poses: new Map(),
    alarms: new Map(),
    pictures: new Map(),
    weather: null,
    sea: null,
    bed: null,
    cables: [],
    moorings: [],
    vessels: [],
    turbines: null,
    forecast: undefined,
    water_missing: '',
    lines: new Map(),
    thrusts: new Map(),
    surfaces: new Map(),
    findings: new Map(),
    looks: [],
    notes: [],
    actions: [],
    said: [],
    frame: null,
    frames_left_out: 0,
    playback: null,
  };
}

/** Takes one text message in. False: it is of a kind that this page does not know. */
export function tell(session: Session, message: Json): boolean {
  switch (message.is) {
    case 'welcome':
      welcome(session, message);
      return true;
    case 'seats':
      session.seats = new Map(read.read_seats(message.seats).map((seat) => [seat.seat, seat]));
      return true;
    case 'helm': {
      const helm = read.read_helm(message);
      if (helm !== null) session.helms.set(helm.vehicle, helm);
      return true;
    }
    case 'run':
      session.run = read.read_run(message);
      return true;
    case 'vehicle': {
      // Either the vehicle itself beside `is`, or in a field of that name.
      const vehicle = read.read_vehicle(read.as_object(message.vehicle) ?? message);
      if (vehicle !== null) session.vehicles.set(vehicle.vehicle, vehicle);
      return true;
    }
    case 'status': {
      const status = read.read_status(message);
      if (status !== null) take_status(session, status);
      return true;
    }
    case 'reserves':
      for (const it of read.read_reserves(message.reserves)) {
        const status = session.statuses.get(it.vehicle);
        if (status !== undefined) session.statuses.set(it.vehicle, { ...status, ...it });
      }
      return true;
    case 'thrusts':
      for (const it of read_thrusts(message.thrusts)) session.thrusts.set(it.vehicle, it.share);
      return true;
    case 'picture': {
      const picture = read.read_picture(message);
      if (picture !== null) session.pictures.set(camera_of(picture), picture);
      return true;
    }
    case 'weather':
      session.weather = read_weather(message);
      return true;
    case 'looks':
      session.looks = read_looks(message.looks);
      return true;
    case 'notes':
      session.notes = read_notes(message.notes);
      return true;
    case 'line':
      take_line(session, message);
      return true;
    case 'thrust':
      take_thrust(session, message);
      return true;
    case 'covered':
      take_covered(session.surfaces, message);
      return true;
    case 'findings':
      take_findings(session, message);
      return true;
    case 'traffic':
      session.vessels = read_vessels(message.vessels);
      return true;
    case 'action': {
      const action = read.read_action(read.as_object(message.action) ?? message);
      if (action !== null) add_action(session, action);
      if (action !== null && session.playback !== null) session.playback.seen = action.number;
      return true;
    }
    case 'seen':
      if (session.playback !== null) session.playback.seen = read.as_number(message.number) ?? 0;
      return true;
    case 'said': {
      const name = holder_name(session, read.as_number(message.seat));
      session.said.push({ name, text: read.as_text(message.text) });
      session.said = session.said.slice(-WORDS_KEPT);
      return true;
    }
    case 'left_out':
      session.frames_left_out += read.as_number(message.frames) ?? 0;
      return true;
    case 'answer':
    case 'clock':
    case 'bye':
      return true; // of the wire, and of whoever asked
    default:
      return false;
  }
}

function camera_of(picture: Picture): string {
  return `${picture.vehicle} ${picture.sensor}`;
}

function take_line(session: Session, message: Json): void {
  const vehicle = read.as_number(message.vehicle);
  if (vehicle === null) return;
  const nodes = read.read_nodes(message.nodes);
  if (nodes.length < 2) session.lines.delete(vehicle);
  else session.lines.set(vehicle, nodes);
}

function take_thrust(session: Session, value: unknown): void {
  const thrust = read_thrust(value);
  if (thrust !== null) session.thrusts.set(thrust.vehicle, thrust.share);
}

function take_findings(session: Session, value: unknown): void {
  const told = read_findings(value);
  if (told !== null) session.findings.set(told.vehicle, told.found);
}

function take_status(session: Session, status: Status): void {
  session.statuses.set(status.vehicle, status);
  if (status.alarms === null) return;
  const standing = new Map(status.alarms.map((it) => [`${status.vehicle} ${it.with}`, it]));
  for (const [key, alarm] of session.alarms) {
    if (alarm.vehicle === status.vehicle && !standing.has(key)) session.alarms.delete(key);
  }
  for (const [key, alarm] of standing) {
    session.alarms.set(key, { vehicle: status.vehicle, ...alarm });
  }
}

function welcome(session: Session, message: Json): void {
  const before = session.seat;
  const about = read.as_object(message.session);
  session.id =
    read.as_text(message.title ?? about?.name ?? about?.id ?? message.session) || session.id;
  session.seat = read.as_number(message.seat);
  session.name = read.as_text(message.name);
  const role = read.as_text(message.role);
  session.role = role === 'operator' || role === 'supervisor' ? role : 'spectator';
  session.start_utc_ms = Date.parse(read.as_text(message.start));
  session.step_s = read.as_number(message.step_s) ?? 0;
  session.vehicles = new Map(read.read_vehicles(message.vehicles).map((it) => [it.vehicle, it]));
  session.structures = read.read_structures(message.structures);
  session.seats = new Map(read.read_seats(message.seats).map((it) => [it.seat, it]));
  session.run = read.read_run(read.as_object(message.run) ?? {});
  session.helms = new Map(read.read_helms(message.helms).map((it) => [it.vehicle, it]));
  session.pictures = new Map(read.read_pictures(message.pictures).map((it) => [camera_of(it), it]));
  session.weather = read_weather(message.weather);
  session.sea = read_sea(message.sea);
  session.turbines = read_turbines(message.turbines);
  const water = read.as_object(message.water);
  session.water_missing = read.as_text(water?.missing);
  const is_told = water !== null && session.water_missing === '';
  session.forecast = is_told ? read.as_text(water.forecast) || null : undefined;
  session.looks = read_looks(message.looks);
  session.notes = read_notes(message.notes);
  session.lines.clear();
  for (const line of read.as_list(message.lines)) take_line(session, read.as_object(line) ?? {});
  session.bed = read_bed(message.bed);
  session.cables = read_cables(message.cables);
  session.moorings = read_moorings(message.moorings);
  session.thrusts.clear();
  for (const thrust of read.as_list(message.thrusts)) take_thrust(session, thrust);
  session.surfaces = read_surfaces(message.surfaces);
  for (const covered of read.as_list(message.covered)) take_covered(session.surfaces, covered);
  session.findings.clear();
  for (const found of read.as_list(message.findings)) take_findings(session, found);
  session.vessels = read_vessels(read.as_object(message.traffic)?.vessels);
  // What a welcome does not carry is told anew after it: the old is of a link that is gone.
  session.poses.clear();
  session.statuses.clear();
  session.alarms.clear();
  session.frame = null;
  for (const status of read.read_statuses(message.status)) take_status(session, status);
  if (before !== session.seat) session.said = [];
  session.actions = [];
  session.playback = read_playback(message);
  // All of a recording's are told at once, in their order.
  if (session.playback !== null) session.actions = read.read_actions(message.actions);
  else for (const action of read.read_actions(message.actions)) add_action(session, action);
}

function add_action(session: Session, action: Action): void {
  if (session.playback !== null || session.actions.some((it) => it.number === action.number))
    return;
  session.actions.push(action);
  session.actions.sort((a, b) => a.number - b.number);
  session.actions = session.actions.slice(-ACTIONS_KEPT);
}

/**
 * A whole frame replaces all poses, another only those it has. An older frame than the shown one is
 * left.
 */
export function show_frame(session: Session, frame: Frame): void {
  if (session.frame !== null && frame.number <= session.frame.number) return;
  if (frame.is_whole) session.poses.clear();
  for (const pose of frame.poses) session.poses.set(pose.vehicle, pose);
  session.frame = frame;
  session.run = { ...session.run, time_s: frame.time_s };
}

export function holder_name(session: Session, holder: Holder | null): string {
  if (holder === null) return 'nobody';
  if (typeof holder === 'string') return holder;
  return session.seats.get(holder)?.name ?? `seat ${holder}`;
}

export function vehicle_name(session: Session, vehicle: Holder | null): string {
  if (vehicle === null) return '';
  if (typeof vehicle === 'string') return vehicle;
  return session.vehicles.get(vehicle)?.name ?? `vehicle ${vehicle}`;
}

/** This station drives the vehicle: the server has said so. */
export function has_helm(session: Session, vehicle: number | null): boolean {
  if (vehicle === null || session.seat === null) return false;
  const helm = session.helms.get(vehicle);
  return (
    helm !== undefined &&
    helm.state !== 'free' &&
    helm.state !== 'lost' &&
    helm.holder === session.seat
  );
}

/** The moment of the run that is shown. */
export function run_utc_ms(session: Session): number {
  return session.start_utc_ms + session.run.time_s * 1000;
}
