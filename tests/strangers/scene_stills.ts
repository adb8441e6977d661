// In a browser: a made-up run near a pile, drawn as `window.choice` asks, for the pictures of the
// docs.
import { SceneView } from 'page/scene/scene_view';
import { use_palette } from 'page/look/palette';
import { empty_session, show_frame, tell } from 'page/session/state';
import { Tracks } from 'page/view/tracks';
import { pose_with } from './pose_for_tests';
import { made_up_sea } from './made_up_waves';

interface Choice {
  sun: { elevation_deg: number; azimuth_deg: number };
  chosen: number;
  turn: [number, number];
  closer: number;
  seen_m: number; // under water
  slice_up_m: number | null;
  palette: 'day' | 'dusk' | 'night';
}
const choice = (window as unknown as { choice: Choice }).choice;
use_palette(choice.palette);

const session = empty_session();
const nine = Array.from({ length: 9 }, (_, i) => [900 * (i % 3), 900 * Math.floor(i / 3)]);
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
    { vehicle: 0, name: 'rov', kind: 'rov', length_m: 1, width_m: 0.8 },
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
        east_m: 300,
        north_m: 150,
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
show_frame(session, {
  number: 1,
  step: 1,
  time_s: 100,
  clock_ms: 0,
  left_out: 0,
  is_whole: true,
  poses: [
    pose_with({ ...rov, ...flow }),
    pose_with({ ...usv, ...flow }),
    pose_with({ vehicle: 2, east_m: 10, north_m: -30, up_m: 40 }),
  ],
});

const view = new SceneView(
  document.querySelector('canvas') as HTMLCanvasElement,
  document.querySelector('.scene-labels') as HTMLElement,
);
view.eye.turn(...choice.turn);
view.eye.closer(choice.closer);
view.slice_up_m = choice.slice_up_m;
const shown = { session, tracks: new Tracks(), chosen: choice.chosen, draft: null };
view.draw(shown);
session.frame!.time_s += 0.3; // the rotors have turned
view.draw(shown);
document.title = 'drawn';
