// In a browser: a long session, as fast as it goes, through the page's own modules: frames at 20
// Hz, weather, traffic that comes and goes, a way under edit, notes, actions, coverage, and each
// minute a link that was cut and came back, with another one of brief frames beside it; now and
// then drawn, from near and afar. After a third of it and at its end the page holds the same, but
// for the tracks, which are kept for half an hour. `window.minutes` is how long it is.
import { SceneView } from 'page/scene/scene_view';
import { decode_frame } from 'page/session/frame';
import { FrameReader } from 'page/session/frame_reader';
import { empty_session, show_frame, tell } from 'page/session/state';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { Tracks } from 'page/view/tracks';
import type { WebGLRenderer } from 'three';
import { frame_bytes } from './made_up_frame';
import { made_up_pile } from './made_up_surface';
import { MOVED_FRAMES } from './moved_frames_for_tests';

const { minutes, heap_bytes } = window as unknown as {
  minutes: number;
  heap_bytes: () => Promise<number>; // in use, garbage collected
};
const FRAMES = Math.round(minutes * 60 * 20);
const DRAWN_EVERY = 200;
// Tracks grow: of 4 vehicles 20 minutes more, a place each second, 120 bytes each: 600 kB; beside
// that what the engine keeps of compiled code. 60 bytes left behind by each frame were 1400 kB.
const MOST_GROWTH_KB = 1000;
// Labels and lines come and go with the second of the run: as many more as it tells at that one.
const MOST_MORE = 8;
const many = <T>(length: number, make: (nth: number) => T): T[] =>
  Array.from({ length }, (_, nth) => make(nth));

const places = [
  [20, 0],
  [900, 0],
  [0, 900],
];
const session = empty_session();
const WELCOME = {
  is: 'welcome',
  title: 'a long one',
  start: '2026-06-01T00:00:00Z',
  seat: 1,
  sea: { depth_m: 30, waves: many(4, (i) => [0.3, 0.02 * i, 0.03, 0.6, i]) },
  vehicles: many(4, (vehicle) => ({
    vehicle,
    name: `rov ${vehicle}`,
    kind: vehicle === 3 ? 'usv' : 'rov',
    length_m: 1,
    mounts: many(6, (i) => ({ at: [0, 0.1 * i, 0], axis: [1, 0, 0] })),
  })),
  structures: places.map(([east_m, north_m], i) => {
    return { name: `pile ${i}`, east_m, north_m, radius_m: 3.5, bottom_m: -30, top_m: 15 };
  }),
  turbines: { hub_height_m: 90, rotor_diameter_m: 126, places },
  bed: {
    east_m: -500,
    north_m: -500,
    step_m: 100,
    across: 11,
    up_m: many(121, (i) => -30 - (i % 3)),
  },
  cables: [{ id: 'c', route: many(9, (i) => [20 * i, 10, -30]), burial_m: 1 }],
  moorings: [{ id: 'm', fairlead: [0, 0, 0], anchor: [60, 0, -30] }],
  surfaces: [{ vehicle: 0, surface: 0, name: 'pile 0', kind: 'monopile', patches: 1000, seen: 0 }],
};
tell(session, WELCOME);
const box = document.createElement('div');
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 64px; height: 36px';
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
const { renderer } = view as unknown as { renderer: WebGLRenderer };
const mesh = read_surface_mesh(made_up_pile(20, 0, 40, 25));
view.site.inspected.take([...session.surfaces.values()][0]!, mesh!);
const seen = document.createElement('canvas');
const tracks = new Tracks();

/** Frames as a server wrote them, of vehicles that move by bits; the first one is whole. */
const brief_frames = MOVED_FRAMES.split('frame\n')
  .slice(1)
  .map((text) => text.split('knows')[0]!.match(/[0-9a-f]{2}/g)!)
  .map((bytes) => Uint8Array.from(bytes, (it) => parseInt(it, 16)));
const reader = new FrameReader();
const brief = empty_session();
let brief_read = 0;
function brief_link(): void {
  reader.forget();
  brief.frame = null; // as a welcome has it
  for (const bytes of brief_frames) {
    const frame = reader.take(bytes);
    if (frame === null) throw new Error('a brief frame was not read');
    show_frame(brief, frame);
    brief_read += 1;
  }
}

/** What the server tells at a second of the run. */
function told(second: number): void {
  const at = { east_m: second % 40, north_m: 3, up_m: -4 };
  tell(session, { is: 'run', state: 'running', time_s: second });
  tell(session, {
    is: 'weather',
    hub_wind_m_s: 8 + (second % 5),
    hub_wind_from_deg: second % 360,
    currents: many(8, (i) => [-4 * i, 0.1 * (second % 4), 0.1]),
    farm: {
      each: places.map(() => ({
        power_w: 1e6,
        wind_m_s: 9,
        rotor_speed_rad_s: 1,
        wind_left: [1, 1, 1],
      })),
    },
  });
  tell(session, {
    is: 'traffic',
    vessels: many(8, (i) => {
      const mmsi = i + 8 * Math.floor(second / 60); // others each minute
      return { mmsi, name: `ship ${mmsi}`, east_m: 100 * i, north_m: second % 3000, speed_m_s: 4 };
    }),
  });
  for (let vehicle = 0; vehicle < 4; vehicle += 1) {
    tell(session, { is: 'thrust', vehicle, share: many(6, (i) => Math.sin(second + i)) });
    tell(session, { is: 'line', vehicle, nodes: many(16, (i) => [i, 0, -i - (second % 3)]) });
    const waypoints = many(second % 7, (i) => ({ east_m: i, north_m: second % 9, up_m: -5 }));
    tell(session, {
      is: 'status',
      vehicle,
      waypoints,
      camera: { pan_deg: second % 90 },
      alarms: [],
    });
    tell(session, {
      is: 'picture',
      vehicle,
      sensor: 'camera',
      number: second + 1,
      at: 1000 * second,
    });
  }
  for (let i = 0; i < 4; i += 1)
    tell(session, { is: 'action', number: 4 * second + i, who: 'Ann', what: 'note', taken: true });
  tell(session, { is: 'said', seat: 1, text: `at ${second} s` });
  tell(session, {
    is: 'notes',
    notes: many(second % 6, (i) => ({ note: second + i, seat: 1, who: 'Ann', text: `${i}`, at })),
  });
  tell(session, {
    is: 'looks',
    looks: many(second % 3, (i) => ({
      seat: 2 + i,
      from: at,
      heading_deg: second % 360,
      point: at,
    })),
  });
  tell(session, { is: 'covered', vehicle: 0, surface: 0, seen: 0.5, runs: [[second % 1000, 3]] });
  const findings = many(second % 20, (i) => ({ kind: 'crack', at: [16.5, 0, -i], size_m: 0.1 }));
  tell(session, { is: 'findings', vehicle: 0, findings });
}

interface Held {
  heap_kb: number;
  geometries: number;
  textures: number;
  nodes: number;
}
async function held(): Promise<Held> {
  const { geometries, textures } = renderer.info.memory;
  const heap_kb = (await heap_bytes()) / 1024;
  return { heap_kb, geometries, textures, nodes: document.querySelectorAll('*').length };
}

const began_ms = performance.now();
function draw(nth: number): void {
  const of_all = nth % 4 === 3;
  if (of_all) view.see_all(session);
  else view.eye.stand = (['follow', 'on_board', 'above'] as const)[nth % 4]!;
  view.slice_up_m = nth % 2 === 0 ? -5 : null;
  view.shows_wakes = nth % 2 === 1;
  const last = session.pictures.get('0 camera');
  seen.width = 64 + (nth % 2);
  view.site.picture = last === undefined ? null : { of: last, canvas: seen, is_old: false };
  const way = many(nth % 8, (i) => ({ east_m: i, north_m: nth % 9, up_m: -5, speed_m_s: null }));
  const draft = nth % 3 === 0 ? null : { places: way, picked: 0, is_refused: false, is_loop: true };
  view.draw({ session, tracks, chosen: nth % 3 === 1 ? 1 : 0, draft });
}
async function run(): Promise<void> {
  const kept: Held[] = [];
  for (let number = 1; number <= FRAMES; number += 1) {
    const time_s = number / 20;
    if (number % 1200 === 0) {
      tell(session, WELCOME); // the link was cut, and came back
      brief_link();
    }
    if (number % 20 === 0) told(number / 20);
    const poses = many(4, (vehicle) => {
      const far = vehicle === 2 ? 50 * (number % 900) : 0; // comes and goes
      return {
        vehicle,
        east_m: 3 * vehicle + far,
        north_m: Math.sin(time_s),
        up_m: vehicle === 3 ? 0 : -5,
        bed_m: 25,
      };
    });
    const frame = decode_frame(frame_bytes(number, time_s, poses));
    if (frame === null) throw new Error('the frame was not read');
    show_frame(session, frame);
    tracks.take(frame);
    if (number % DRAWN_EVERY === 0) draw(number / DRAWN_EVERY);
    if (number === Math.round(FRAMES / 3) || number === FRAMES) {
      // All that there can be is there, whatever is drawn at that moment.
      for (let nth = 1; nth <= 12; nth += 1) draw(nth);
      kept.push(await held());
    }
  }
  const [before, after] = kept as [Held, Held];
  const grown_kb = after.heap_kb - before.heap_kb;
  const faults = [
    session.poses.size === 4 && tracks.of(0).length >= Math.min(1800, 0.99 * minutes * 60)
      ? ''
      : 'the session was not what it should be',
    brief_read === brief_frames.length * Math.floor(FRAMES / 1200) && brief.poses.size > 0
      ? ''
      : 'brief frames were left out',
    view.site.inspected.has([...session.surfaces.values()][0]!) ? '' : 'the surface is gone',
    grown_kb < MOST_GROWTH_KB ? '' : `expected ${MOST_GROWTH_KB} kB more at most`,
    after.geometries <= before.geometries + MOST_MORE ? '' : 'geometries are left',
    after.textures <= before.textures ? '' : 'textures are left',
    after.nodes <= before.nodes + MOST_MORE ? '' : 'elements are left',
  ];
  const took_s = ((performance.now() - began_ms) / 1000).toFixed(0);
  const said = (it: Held): string =>
    [
      `${(it.heap_kb / 1024).toFixed(1)} MB, ${it.geometries} geometries`,
      `${it.textures} textures, ${it.nodes} elements`,
    ].join(', ');
  document.title = JSON.stringify({
    said: [
      `${minutes} min of a session in ${took_s} s`,
      `after a third ${said(before)}`,
      `at its end ${said(after)}`,
    ].join('; '),
    fault: faults.filter((it) => it !== '').join('; '),
  });
}
void run();
