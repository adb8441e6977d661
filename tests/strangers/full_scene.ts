// In a browser: a scene of 20 vehicles, 64 waves and 50 turbines, within its budgets. How long
// drawing takes is the graphics card's matter; what is counted is the script, and what it asks for.
import { Tracks } from 'page/view/tracks';
import { SceneView } from 'page/scene/scene_view';
import { read_weather } from 'page/session/around';
import { read_turbines } from 'page/session/farm';
import { read_structures, read_vehicle } from 'page/session/message';
import { empty_session } from 'page/session/state';
import { pose_with } from './pose_for_tests';
import { made_up_sea } from './made_up_waves';

const session = empty_session();
session.sea = made_up_sea;
for (let i = 0; i < 20; i += 1) {
  const kind = ['rov', 'auv', 'usv', 'uav'][i % 4];
  const vehicle = read_vehicle({ vehicle: i, name: `${kind} ${i}`, kind, length_m: 2, width_m: 2 });
  if (vehicle !== null) session.vehicles.set(i, vehicle);
  const [east_m, north_m, up_m] = [15 * (i % 5), 15 * Math.floor(i / 5), i % 4 === 3 ? 20 : -3];
  const pose = { vehicle: i, east_m, north_m, up_m, current_east_m_s: 0.4, bed_m: 30 };
  session.poses.set(i, pose_with(pose));
}
session.structures = read_structures(
  Array.from({ length: 50 }, (_, i) => ({
    name: `pile ${i}`,
    east_m: 200 * (i % 10) - 1000,
    north_m: 200 * Math.floor(i / 10) - 500,
    radius_m: 4,
    bottom_m: -33,
    top_m: 20,
  })),
);
session.turbines = read_turbines({
  hub_height_m: 90,
  rotor_diameter_m: 126,
  places: session.structures.map(({ east_m, north_m }) => [east_m, north_m]),
});
session.weather = read_weather({
  hub_wind_from_deg: 240,
  currents: [
    [0, 0.5, 0],
    [-30, 0, 0.2],
  ],
  farm: {
    each: session.structures.map(() => ({ rotor_speed_rad_s: 1, wind_left: [0.5, 0.7, 0.9] })),
  },
});
const at_first = { number: 1, step: 1, time_s: 0, clock_ms: 0, left_out: 0, poses: [] };
session.frame = { ...at_first, is_whole: true };

const box = document.createElement('div');
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 640px; height: 360px';
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
view.slice_up_m = -5;
view.shows_wakes = true;
const shown = { session, tracks: new Tracks(), chosen: 0, draft: null };
view.see_all(session);
view.eye.turn(0, 1);
view.eye.closer(0.002); // so far away that all of it is in view
const took_ms: number[] = [];
for (let i = 0; i < 40; i += 1) {
  session.frame.time_s += 0.05;
  const begin = performance.now();
  view.draw(shown);
  took_ms.push(performance.now() - begin);
}
const { calls, triangles } = view.asked();
// The least of 40: the machine of a test is busy with something else, too.
const script_ms = Math.min(...took_ms);
const labels = box.querySelectorAll('span:not([hidden])').length;
const faults = [
  script_ms <= 8 ? '' : 'expected 8 ms at most',
  calls > 50 && calls <= 300 ? '' : 'expected 50 to 300 calls',
  triangles > 100_000 && triangles <= 500_000 ? '' : 'expected 100 000 to 500 000 triangles',
  labels === 28 ? '' : 'expected 28 names',
];
const asked = `${calls} calls, ${triangles} triangles, ${labels} names`;
document.title = JSON.stringify({
  said: `${script_ms.toFixed(1)} ms of script a frame, ${asked}`,
  fault: faults.filter((it) => it !== '').join('; '),
});
