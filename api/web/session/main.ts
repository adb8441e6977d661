// The page /session, put together. The server is the only truth: what is shown here was told by it.
import { Driver, TICK_MS } from './drive/driver';
import { PadReader } from './drive/gamepad';
import { HandWindow } from './drive/hand_window';
import { Keys, leaves_keys_alone, listen_to_keys } from './drive/keys';
import { Stick } from './drive/stick';
import { lessons } from './lessons/lesson';
import { button, by_id, element, set_hidden } from '../look/element';
import { notice } from './look/notice';
import { use_palette } from './look/palette';
import { load_settings } from './look/settings';
import { attention_button } from './panel/attention_button';
import { camera_panel } from './panel/camera_panel';
import { drive_panel } from './panel/drive_panel';
import { helm_panel, helm_words } from './panel/helm_panel';
import { join_form } from './panel/join_form';
import { lesson_panel } from './panel/lesson_panel';
import { log_panel } from './panel/log_panel';
import { orders_bar } from './panel/orders_bar';
import { people_panel } from './panel/people_panel';
import { picture_panel } from './panel/picture_panel';
import { playback_bar } from './panel/playback_bar';
import { scene_panel } from './panel/scene_panel';
import type { Shown } from './scene/scene_view';
import { settings_dialog } from './panel/settings_dialog';
import { state_panel } from './panel/state_panel';
import { supervise_panel } from './panel/supervise_panel';
import { run_text, top_bar } from './panel/top_bar';
import { vehicle_table } from './panel/vehicle_table';
import { waypoint_edit } from './panel/waypoint_edit';
import { led_text, weather_panel } from './panel/weather_panel';
import { class_of_address } from './session/class_of_address';
import { Idle } from './session/idle';
import { browser_means } from './session/browser_means';
import { FrameReader } from './session/frame_reader';
import { guard_seat, keep_seat, seat_to_take_up } from './session/kept_seat';
import { read_answer, type Json } from './session/message';
import { session_of_address } from './session/session_list';
import { empty_session, show_frame, tell, vehicle_name } from './session/state';
import { Wire, type LinkState } from './session/wire';
import { Station, type Panel } from './station';
import { draw_depth, type Along } from './view/depth_view';
import { gazed_on_page } from './view/gazed';
import { PlanView } from './view/plan_view';
import { Tracks } from './view/tracks';

const PANELS_EVERY_MS = 100;
const RECORDING = 'This is a recording. Nothing in it can be changed.';

by_id('built-without').remove();
const settings = load_settings();
use_palette(settings.palette);
const tracks = new Tracks();
const frames = new FrameReader();
let link: LinkState = { is: 'off', text: '' };
let seat_token: string | null = null;
let canvases_are_old = true;
let left_out_told_ms = -Infinity;
let is_end_told = false;

const wire = new Wire(browser_means, {
  on_state: take_link,
  on_message: take_message,
  on_bytes: (bytes) => {
    const frame = frames.take(bytes);
    if (frames.is_lost) wire.lost_track();
    if (frame === null) return;
    show_frame(station.session, frame);
    tracks.take(frame);
    station.frame_came_ms = performance.now();
    if (station.chosen === null) choose_first();
    canvases_are_old = true;
  },
  on_resume: (resume) => {
    seat_token = resume?.token ?? null;
    keep_seat(resume);
  },
});
const station = new Station(wire, settings);

// What is on the page.
const stick = new Stick();
const keys = new Keys();
const redraw = (): void => {
  canvases_are_old = true;
  show_panels();
};
const join = join_form((session_id, token, name) => wire.join(session_id, token, name));
const dialog = settings_dialog(settings, redraw);
const top = top_bar(
  station,
  () => link,
  () => dialog.open(),
  () => wire.leave(),
);
const table = vehicle_table(station, choose);
const state = state_panel(station);
const helm = helm_panel(station);
const orders = orders_bar(station, stick);
const drive = drive_panel(station, stick);
const way = waypoint_edit(
  station,
  () => plan.camera,
  () => redraw(),
);
const supervise = supervise_panel(station);
const hand_window = new HandWindow(station);
const camera = camera_panel(station, hand_window);
const picture = picture_panel(station);
const weather = weather_panel(station);
const people = people_panel(station);
const playback = playback_bar(station);
const mode = class_of_address(location.search);
const lesson = lesson_panel(station, lessons);
const log = log_panel(station, (time_s) => playback.seek(time_s));
const panels: Panel[] = [
  top,
  table,
  state,
  helm,
  orders,
  drive,
  picture,
  camera,
  way,
  supervise,
  weather,
  people,
  playback,
  log,
  ...(mode.has_lessons ? [lesson] : []),
];

const plan_canvas = by_id('plan') as HTMLCanvasElement;
const depth_canvas = by_id('depth') as HTMLCanvasElement;
const plan = new PlanView(
  plan_canvas,
  {
    press: (at, pixel) => way.press(at, pixel),
    move: (at) => way.move(at),
    let_go: () => way.let_go(),
    click: (at, pixel) => supervise.click(at) || way.click(at, pixel),
  },
  (pixel) => {
    for (const pose of station.session.poses.values()) {
      const at = plan.camera.to_pixel(pose);
      if (Math.hypot(at.x - pixel.x, at.y - pixel.y) < 24) choose(pose.vehicle);
    }
  },
);
plan.on_change = () => {
  canvases_are_old = true;
  follow.setAttribute('aria-pressed', String(plan.follows));
};
const middle = (): { x: number; y: number } => ({
  x: plan.camera.width / 2,
  y: plan.camera.height / 2,
});
const follow = button(
  'Follow',
  () => {
    plan.follows = !plan.follows;
    plan.on_change();
  },
  { 'aria-pressed': 'true' },
);
const plan_buttons = element(
  'div',
  { class: 'buttons' },
  follow,
  button(
    'All',
    () => {
      plan.follows = false;
      plan.fit(station.session);
      plan.on_change();
    },
    { 'aria-label': 'Show all' },
  ),
  button(
    '+',
    () => {
      plan.camera.zoom(1.4, middle());
      plan.on_change();
    },
    { 'aria-label': 'Closer' },
  ),
  button(
    '−',
    () => {
      plan.camera.zoom(1 / 1.4, middle());
      plan.on_change();
    },
    { 'aria-label': 'Farther' },
  ),
);
const scene = scene_panel(station, {
  way,
  orders,
  last_picture: picture.last,
  shown,
  drawn: tell_drawn,
  choose,
  drives: () => stick.driving_hand === 'headset',
  on_change: () => {
    set_hidden(plan_buttons, scene.is_open()); // the scene has its own
    canvases_are_old = true;
  },
});
by_id('plan-tools').append(scene.opener, plan_buttons);
const gazed = gazed_on_page(
  scene,
  { canvas: plan_canvas, to_pixel: (at) => plan.camera.to_pixel(at) },
  () => station.session,
);
people.box.append(element('div', { class: 'buttons' }, attention_button(station, gazed)));
let along: Along = 'time';
const by_distance = button(
  'Over distance',
  () => {
    along = along === 'time' ? 'distance' : 'time';
    by_distance.setAttribute('aria-pressed', String(along === 'distance'));
    canvases_are_old = true;
  },
  { 'aria-pressed': 'false' },
);
by_id('depth-tools').append(by_distance);
plan_canvas.after(way.plan_note);

by_id('top').append(top.box);
by_id('join').append(join.box);
by_id('chosen').append(helm.box, picture.box, state.box, drive.box);
by_id('chosen').append(camera.box, way.box, supervise.box);
if (mode.has_lessons) by_id('around').append(lesson.box);
by_id('around').append(table.box, weather.box, people.box, log.box);
by_id('playback').append(playback.box);
by_id('orders').append(drive.touch_box, orders.box);
document.body.append(dialog.node);

// Hands.
listen_to_keys(keys);
const let_go = (): void => drive.let_go();
addEventListener('blur', let_go);
document.addEventListener('visibilitychange', let_go);
addEventListener('keydown', (event) => {
  if (document.querySelector('dialog[open]') !== null) return;
  if (event.key === 'Escape') plan_canvas.focus();
  const is_typing =
    document.activeElement instanceof HTMLInputElement ||
    document.activeElement instanceof HTMLSelectElement;
  if (
    event.code === 'KeyH' &&
    !event.repeat &&
    !is_typing &&
    !event.ctrlKey &&
    !event.metaKey &&
    !event.altKey &&
    link.is === 'seated'
  ) {
    if (station.may_hold()) orders.hold();
  }
  const plays = event.code === 'Space' && !event.repeat && station.session.playback !== null;
  if (plays && leaves_keys_alone(document.activeElement)) playback.toggle();
});
// A button or box that was clicked gives the keys back, so that Space is the dead-man again.
document.addEventListener('click', (event) => {
  const focused = document.activeElement;
  const is_pressed =
    focused instanceof HTMLButtonElement ||
    (focused instanceof HTMLInputElement && focused.type === 'checkbox');
  if (event.detail > 0 && is_pressed && document.querySelector('dialog[open]') === null)
    focused.blur();
});

const driver = new Driver(station, stick, keys, new PadReader(), drive, orders, scene.headset);
setInterval(() => driver.tick(), TICK_MS);
setInterval(() => hand_window.tick(), TICK_MS);
setInterval(show_panels, PANELS_EVERY_MS);
if (mode.resets) {
  const idle = new Idle(performance.now());
  for (const touch of ['pointerdown', 'keydown', 'wheel'] as const)
    addEventListener(touch, () => idle.touch(performance.now()));
  setInterval(() => {
    const now_ms = performance.now();
    if (scene.headset.is_worn()) idle.touch(now_ms); // whose hands touch nothing here
    if (idle.is_over(now_ms) && !lesson.reset()) idle.touch(now_ms); // again a while later
  }, 1000);
}
addEventListener('resize', () => (canvases_are_old = true));
requestAnimationFrame(draw);

guard_seat(() => seat_token);
void seat_to_take_up().then((seat) => {
  const asked = session_of_address(location.search);
  const is_asked = asked === '' || asked === seat?.session_id;
  if (seat !== null && is_asked && link.is === 'off')
    wire.take_up(seat.session_id, seat.token, seat.name);
  else show_panels();
});

function draw(): void {
  requestAnimationFrame(draw);
  if (!canvases_are_old || by_id('live').hidden) return;
  canvases_are_old = false;
  const { session, chosen } = station;
  if (scene.is_open()) scene.draw(shown());
  else plan.draw({ session, tracks, chosen, speed_unit: settings.speed_unit, draft: way.draft() });
  draw_depth(depth_canvas, { session, tracks, chosen, along });
  if (!scene.headset.is_worn()) tell_drawn();
}

function shown(): Shown {
  return { session: station.session, tracks, chosen: station.chosen, draft: way.draft() };
}

function tell_drawn(): void {
  const { frame } = station.session;
  if (frame !== null) wire.drawn(frame.number);
}

function show_panels(): void {
  const is_in = link.is === 'seated' || link.is === 'cut';
  set_hidden(by_id('live'), !is_in);
  const is_live = station.session.playback === null;
  set_hidden(by_id('orders'), !is_in || !is_live);
  if (!is_in || is_live) set_hidden(by_id('playback'), true);
  set_hidden(by_id('join'), is_in);
  if (is_in) for (const panel of panels) panel.show();
  else top.show();
}

function choose(vehicle: number): void {
  station.chosen = vehicle;
  plan.follows = true;
  plan.on_change();
  redraw();
}

function choose_first(): void {
  const [first] = station.session.vehicles.keys();
  if (first !== undefined) choose(first);
}

function take_link(now: LinkState): void {
  const before = link;
  link = now;
  station.forget_answers();
  playback.forget();
  if (now.is === 'off') {
    station.session = empty_session();
    station.chosen = null;
    station.frame_came_ms = Number.NaN;
    tracks.clear();
    way.end();
    scene.headset.leave();
    join.show(false, now.text);
  } else {
    join.show(now.is === 'joining', '');
  }
  if (now.is === 'cut' && before.is === 'seated')
    notice('The link is down. Nothing is sent.', 'alarm');
  document.documentElement.dataset.link = now.is;
  show_panels();
}

/** Play and pause are seen where they are pressed; that a recording stops by itself is told. */
function tell_end(to_s: number): void {
  const { is_playing, time_s } = station.session.run;
  const is_at_end = !is_playing && time_s >= to_s;
  if (is_at_end === is_end_told) return;
  is_end_told = is_at_end;
  notice(is_at_end ? 'The recording is at its end.' : RECORDING);
}

function take_message(message: Json): void {
  const { session } = station;
  const seats_before = new Map(session.seats);
  const run_before = run_text(session);
  const helm_before =
    typeof message.vehicle === 'number' ? session.helms.get(message.vehicle) : undefined;
  const seat_before = session.seat;
  const alarms_before = new Map(session.alarms);
  const led_now = (): string | undefined => session.weather?.led.join();
  const led_before = led_now();
  const head_before_s = session.playback === null ? null : session.run.time_s;
  tell(session, message);
  switch (message.is) {
    case 'welcome':
      frames.forget();
      if (typeof message.number === 'number') station.numbers.heard(message.number);
      station.frame_came_ms = Number.NaN;
      if (session.playback !== null) {
        tracks.clear();
        if (head_before_s !== null) playback.seek(head_before_s); // back after a cut
      }
      if (station.chosen === null || !session.vehicles.has(station.chosen)) choose_first();
      if (session.playback !== null) notice(RECORDING);
      else if (seat_before !== null && seat_before !== session.seat) {
        notice(
          `The old seat is gone, and the helms with it. You have a new one as ${session.role}.`,
          'alarm',
        );
      } else notice(`You have a seat as ${session.role}.`);
      break;
    case 'answer': {
      const answer = read_answer(message);
      if (answer !== null) station.take_answer(answer);
      break;
    }
    case 'helm': {
      const now =
        typeof message.vehicle === 'number' ? session.helms.get(message.vehicle) : undefined;
      const is_other =
        now?.state !== helm_before?.state ||
        now?.holder !== helm_before?.holder ||
        now?.asker !== helm_before?.asker;
      if (now === undefined || !is_other || session.playback !== null) break;
      const vehicle = vehicle_name(session, now.vehicle);
      const words = `${vehicle}: ${helm_words(session, now, Number.NaN).state}`;
      // Whose helm was taken back is told why, at once and in plain sight.
      const was_mine = helm_before?.holder === session.seat && now.holder !== session.seat;
      const last = session.actions[session.actions.length - 1];
      if (was_mine && last?.what === 'take_back' && last.vehicle === vehicle)
        notice(`${words} Taken back: ${last.why}`, 'alarm');
      else notice(words);
      break;
    }
    case 'run':
      if (session.playback !== null) tell_end(session.playback.to_s);
      else if (run_text(session) !== run_before) notice(`${run_text(session)}.`);
      break;
    case 'seats':
      for (const seat of session.seats.values()) {
        if (seats_before.get(seat.seat)?.is_here !== seat.is_here && seat.seat !== session.seat) {
          notice(`${seat.name}: ${seat.is_here ? 'is here' : 'link down'}.`);
        }
      }
      break;
    case 'status':
      for (const [key, alarm] of session.alarms) {
        if (alarms_before.get(key)?.level === alarm.level) continue;
        notice(
          `Traffic: ${vehicle_name(session, alarm.vehicle)} and ${alarm.with}, ${alarm.level}.`,
          'alarm',
        );
      }
      break;
    case 'weather':
      if (session.weather !== null && led_before !== undefined && led_now() !== led_before)
        notice(led_text({ ...session.weather, settles_in_s: 0 }));
      break;
    case 'seen':
      tracks.clear();
      canvases_are_old = true;
      break;
    case 'said': {
      const last = session.said[session.said.length - 1];
      if (last !== undefined) notice(`${last.name} says: ${last.text}`);
      break;
    }
    case 'left_out':
      // A hidden page draws nothing, so nothing is sent to it; that is no news. Else one word in
      // ten seconds.
      if (!document.hidden && performance.now() - left_out_told_ms > 10_000) {
        left_out_told_ms = performance.now();
        notice(`This station does not keep up: ${String(message.frames)} pictures were left out.`);
      }
      break;
  }
}
