// In a browser: a made-up run near a pile, drawn as `window.choice` asks, for the pictures of the
// docs.
import { Euler, Mesh, MeshBasicMaterial, PlaneGeometry, Quaternion, Vector3 } from 'three';
import { at_place } from 'page/scene/axes';
import { SceneView } from 'page/scene/scene_view';
import { Wearer } from 'page/xr/wearer';
import { use_palette } from 'page/look/palette';
import { empty_session, show_frame, tell } from 'page/session/state';
import { Tracks } from 'page/view/tracks';
import { pose_with } from './pose_for_tests';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { made_up_pile } from './made_up_surface';
import { made_up_sea } from './made_up_waves';

interface Choice {
  sun: { elevation_deg: number; azimuth_deg: number };
  chosen: number;
  turn: [number, number];
  closer: number;
  seen_m: number; // under water
  slice_up_m: number | null;
  palette: 'day' | 'dusk' | 'night';
  is_table?: boolean; // as AR shows it, over a plain floor
}
const choice = (window as unknown as { choice: Choice }).choice;
use_palette(choice.palette);

const session = empty_session();
const side = Math.SQRT1_2;
const mounts = [
  { at: [0.3, 0.3, 0.05], axis: [side, -side, 0] },
  { at: [0.3, -0.3, 0.05], axis: [side, side, 0] },
  { at: [-0.3, 0.3, 0.05], axis: [side, side, 0] },
  { at: [-0.3, -0.3, 0.05], axis: [side, -side, 0] },
  { at: [0.15, 0.25, 0], axis: [0, 0, -1] },
  { at: [-0.15, -0.25, 0], axis: [0, 0, -1] },
];
const bed_up_m = (east_m: number, north_m: number): number =>
  -30 + 1.2 * Math.sin(east_m / 45) * Math.cos(north_m / 60) + 0.5 * Math.sin(north_m / 21);
const [ACROSS, STEP_M] = [41, 20];
const bed = {
  east_m: -400,
  north_m: -400,
  step_m: STEP_M,
  across: ACROSS,
  up_m: Array.from({ length: ACROSS * ACROSS }, (_, i) =>
    bed_up_m(STEP_M * (i % ACROSS) - 400, STEP_M * Math.floor(i / ACROSS) - 400),
  ),
};
const [AROUND, DOWN] = [48, 60]; // patches of the pile that is inspected
// What has been looked at: the side that the vehicle is on, from the surface to below it.
const covered = Array.from({ length: AROUND * DOWN }, (_, i) => i).filter((i) => {
  const [column, row] = [i % AROUND, Math.floor(i / AROUND)];
  return column > 2 && column < 16 && row < 19 + 3 * Math.sin(column);
});
const apart_m = choice.is_table ? 300 : 900;
const nine = Array.from({ length: 9 }, (_, i) => [apart_m * (i % 3), apart_m * Math.floor(i / 3)]);
const along_line = Array.from({ length: 17 }, (_, i) => i / 16);
tell(session, {
  is: 'welcome',
  sea: {
    depth_m: 30,
    waves: made_up_sea.waves.map((it) => [
      it.amplitude_m,
      it.east_rad_m,
      it.north_rad_m,
      it.rad_s,
      it.phase_rad,
    ]),
  },
  turbines: { hub_height_m: 90, rotor_diameter_m: 126, rated_w: 5e6, places: nine },
  structures: nine.map(([east_m, north_m], i) => ({
    name: `pile ${i + 1}`,
    east_m,
    north_m,
    radius_m: 3.5,
    bottom_m: -30,
    top_m: 15,
  })),
  vehicles: [
    { vehicle: 0, name: 'rov', kind: 'rov', length_m: 1, width_m: 0.8, mounts },
    { vehicle: 1, name: 'usv', kind: 'usv', length_m: 5, width_m: 2.4 },
    { vehicle: 2, name: 'uav', kind: 'uav', length_m: 0.8, width_m: 0.8 },
  ],
  status: [
    {
      vehicle: 0,
      alarms: [],
      camera: { pan_deg: 0, tilt_deg: 0, zoom: 1 },
      waypoints: [
        { east_m: 6, north_m: -4, up_m: -12 },
        { east_m: 0, north_m: -7, up_m: -16 },
      ],
    },
    { vehicle: 1, alarms: [{ mmsi: 1, name: 'COASTER', cpa_m: 60, cpa_s: 90 }], waypoints: [] },
  ],
  lines: [
    {
      vehicle: 0,
      nodes: along_line.map((s) => [
        14 - 5 * s,
        -1 - 4 * s - 3 * Math.sin(Math.PI * s),
        -1 - 9 * s,
      ]),
    },
  ],
  bed,
  cables: [
    { id: 'array 1-2', route: [0, 90, 450, 900].map((east_m) => [east_m, 4, -30]), burial_m: 1.5 },
    {
      id: 'array 1-4',
      route: [0, 90, 450, 900].map((north_m) => [-4, north_m, -30]),
      burial_m: null,
    },
  ],
  thrusts: [{ vehicle: 0, share: [0.7, 0.5, 0.6, 0.4, 0.5, 0.3] }],
  surfaces: [
    {
      vehicle: 0,
      surface: 0,
      name: 'pile 1',
      kind: 'monopile',
      patches: AROUND * DOWN,
      seen: covered.length / (AROUND * DOWN),
      asked: 0.9,
    },
  ],
  covered: [
    {
      vehicle: 0,
      surface: 0,
      seen: covered.length / (AROUND * DOWN),
      runs: covered.map((i) => [i, 1]),
    },
  ],
  findings: [
    {
      vehicle: 0,
      findings: [
        { kind: 'marine_growth', at: [2.9, -2, -8.2], size_m: 0.4, by: 'rov_camera' },
        { kind: 'crack', at: [3.45, -0.6, -11], size_m: 0.09, by: 'rov_camera' },
      ],
    },
  ],
  pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 1, at: 0, wide: 320, high: 180 }],
  weather: {
    sun: choice.sun,
    wind_m_s: 8,
    hub_wind_m_s: 10,
    hub_wind_from_deg: 240,
    visibility_m: 15_000,
    water_visibility_m: choice.seen_m,
    currents: along_line.map((s) => {
      const speed_m_s = 0.7 * Math.exp(-1.2 * s);
      const to_rad = 0.5 + 1.5 * s;
      return [-30 * s, speed_m_s * Math.sin(to_rad), speed_m_s * Math.cos(to_rad)];
    }),
    farm: {
      each: nine.map((_, i) => ({
        power_w: 3.1e6 - 2e5 * i,
        wind_m_s: 9,
        rotor_speed_rad_s: 1.1,
        wind_left: [0.45, 0.65, 0.8],
      })),
    },
  },
  traffic: {
    vessels: [
      {
        mmsi: 1,
        name: 'COASTER',
        ...(choice.is_table ? { east_m: 120, north_m: 400 } : { east_m: 300, north_m: 150 }),
        course_deg: 250,
        speed_m_s: 4,
        length_m: 80,
      },
    ],
  },
});
const flow = { current_east_m_s: 0.3, current_north_m_s: 0.25 };
const rov = { vehicle: 0, east_m: 9, north_m: -5, up_m: -10, heading_rad: -1.1, bed_m: 20 };
const usv = { vehicle: 1, east_m: 14, up_m: 0.2, heading_rad: 0.4, bed_m: 30 };
/** On the table nobody could tell them from each other. */
const apart = (east_m: number, north_m: number): { east_m?: number; north_m?: number } =>
  choice.is_table ? { east_m, north_m } : {};
show_frame(session, {
  number: 1,
  step: 1,
  time_s: 100,
  clock_ms: 0,
  left_out: 0,
  is_whole: true,
  poses: [
    pose_with({ ...rov, ...flow, ...apart(60, 60) }),
    pose_with({ ...usv, ...flow }),
    pose_with({ vehicle: 2, east_m: 10, north_m: -30, up_m: 40, ...apart(480, 150) }),
  ],
});

const view = new SceneView(
  document.querySelector('canvas') as HTMLCanvasElement,
  document.querySelector('.scene-labels') as HTMLElement,
);
const mesh = read_surface_mesh(
  made_up_pile(0, 0, AROUND, DOWN, { radius_m: 3.5, top_m: 0, bottom_m: -30 }),
);
view.site.inspected.take([...session.surfaces.values()][0]!, mesh!);
view.eye.turn(...choice.turn);
view.eye.closer(choice.closer);
view.slice_up_m = choice.slice_up_m;
const way = [
  { east_m: 150, north_m: 130, up_m: -12, speed_m_s: 0.5 },
  { east_m: 330, north_m: 180, up_m: -20, speed_m_s: 0.5 },
  { east_m: 440, north_m: 420, up_m: -16, speed_m_s: 0.5 },
];
const draft = choice.is_table
  ? { places: way, picked: 1, is_refused: false, is_loop: false }
  : null;
const shown = { session, tracks: new Tracks(), chosen: choice.chosen, draft };
if (choice.is_table) stand_at_table(new Wearer(view));
view.draw(shown);
session.frame!.time_s += 0.3; // the rotors have turned
view.draw(shown);
document.title = 'drawn';

/** Who looks down at it, and a hand that holds the second place of a way. */
function stand_at_table(wearer: Wearer): void {
  const { rig } = wearer;
  const floor = new Mesh(new PlaneGeometry(12, 12), new MeshBasicMaterial({ color: '#8c8479' }));
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -0.02;
  rig.inner.add(floor);
  view.renderer.setClearColor('#cfc9c0');
  rig.camera.fov = 40;
  rig.camera.aspect = 16 / 9;
  rig.camera.updateProjectionMatrix();
  const turned = new Quaternion().setFromEuler(new Euler(-0.72, 0, 0));
  rig.take_head({ at: new Vector3(0, 1.45, 0.75), turned });
  wearer.lay_table(shown, new Vector3(-0.56, 0.12, -0.18));
  wearer.board.mesh.visible = false;
  const held = rig.inner.worldToLocal(at_place(way[1]!));
  const joints = pinching_hand(held);
  wearer.hands.right.show(
    {
      side: 'right',
      kind: 'hand',
      is_tracked: true,
      grip: null,
      ray: null,
      joints,
      is_pressed: true,
      press_at: held,
      is_squeezed: false,
      is_pointing: false,
      is_hold: false,
      stick: { right: 0, up: 0 },
    },
    false,
    false,
  );
}

/** Thumb and index meet at a place, the wrist is behind and above it. */
function pinching_hand(at: Vector3): Vector3[] {
  const wrist = at.clone().add(new Vector3(0.07, 0.1, 0.12));
  const finger = (tip: Vector3, knuckle: Vector3, many: number): Vector3[] =>
    Array.from({ length: many }, (_, i) => {
      const share = i / (many - 1);
      const bent = new Vector3(0, 0.035 * Math.sin(Math.PI * share), 0);
      return knuckle.clone().lerp(tip, share).add(bent);
    });
  const knuckle = (nth: number): Vector3 =>
    wrist.clone().add(new Vector3(-0.035 + 0.02 * nth, -0.005, -0.02));
  const tips = [0, 0.02, 0.045, 0.07].map((right, nth) =>
    at.clone().add(new Vector3(right, 0.012 * nth, -0.03 * Math.sign(nth))),
  );
  return [
    wrist,
    ...finger(at, wrist.clone().add(new Vector3(-0.05, -0.02, 0)), 4),
    ...tips.flatMap((tip, nth) => finger(tip, knuckle(nth), 5)),
  ];
}
