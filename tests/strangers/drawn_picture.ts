// In a browser: the picture of a camera at the far end of what it sees. Four colours in its four
// corners are found where Fossen's rotation has these corners: right is right, up is up. And the
// panel that fetches it lends none of another session, and says of an old one that it is old.
import { Vector3, type WebGLRenderer } from 'three';
import { picture_panel } from 'page/panel/picture_panel';
import { SceneView } from 'page/scene/scene_view';
import { decode_frame } from 'page/session/frame';
import { empty_session, show_frame, tell } from 'page/session/state';
import type { Station } from 'page/station';
import { Tracks } from 'page/view/tracks';
import { body_to_ned, type Triple } from './fossen';
import { frame_bytes } from './made_up_frame';

const [FIELD_RAD, REACH_M] = [1.117, 4];
const [WIDE, HIGH] = [640, 480];
const CORNERS = [
  { right: -1, up: 1, colour: [255, 0, 0] },
  { right: 1, up: 1, colour: [0, 255, 0] },
  { right: 1, up: -1, colour: [0, 0, 255] },
  { right: -1, up: -1, colour: [255, 255, 0] },
] as const;
// Shares of the way to a corner; off the edges of its view, which are lines in the scene.
const INWARDS = [
  [0.2, 0.7],
  [0.75, 0.3],
  [0.95, 0.6],
] as const;
const picture = document.createElement('canvas');
[picture.width, picture.height] = [WIDE, HIGH];
const context = picture.getContext('2d')!;
for (const { right, up, colour } of CORNERS) {
  context.fillStyle = `rgb(${colour.join()})`;
  context.fillRect(right < 0 ? 0 : WIDE / 2, up > 0 ? 0 : HIGH / 2, WIDE / 2, HIGH / 2);
}

const pointing = { pan_deg: 25, tilt_deg: -15, zoom: 2 };
const pose = { east_m: 310, north_m: -205, up_m: -12, roll_rad: 0.2, pitch_rad: -0.3 };
const session = empty_session();
tell(session, {
  is: 'welcome',
  vehicles: [{ vehicle: 0, name: 'rov', kind: 'rov', length_m: 0.6, width_m: 0.5 }],
  status: [{ vehicle: 0, camera: pointing }],
  pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 1, at: 0, wide: WIDE, high: HIGH }],
});
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 320px; height: 240px';
const box = document.createElement('div');
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
const { renderer } = view as unknown as { renderer: WebGLRenderer };
view.site.picture = { of: [...session.pictures.values()][0]!, canvas: picture, is_old: false };

/** A corner of the picture, or a place on the way to it from its middle, as seen in the scene. */
function place_of(heading: number, right: number, up: number): Vector3 {
  const [pan, tilt] = [pointing.pan_deg, pointing.tilt_deg].map((it) => (it * Math.PI) / 180) as [
    number,
    number,
  ];
  const half = Math.tan(FIELD_RAD / 2) / pointing.zoom;
  const of_camera: Triple = [1, right * half, (-up * half * HIGH) / WIDE];
  const of_body = body_to_ned(0, tilt, pan, of_camera);
  const [north, east, down] = body_to_ned(pose.roll_rad, pose.pitch_rad, heading, of_body);
  const at = [
    pose.east_m + REACH_M * east,
    pose.up_m - REACH_M * down,
    -(pose.north_m + REACH_M * north),
  ];
  return new Vector3(...at);
}

const faults: string[] = [];
let found = 0;
const gl = renderer.getContext();
let [number, turned_rad] = [0, 0.6]; // as an eye begins
for (const [heading_rad, aslant_rad] of [
  [0.3, 0.4],
  [3.9, -0.5],
] as const) {
  number += 1;
  const told = { vehicle: 0, ...pose, heading_rad };
  const frame = decode_frame(frame_bytes(number, number, [told]));
  if (frame === null) throw new Error('the frame was not read');
  show_frame(session, frame);
  // From behind the vehicle, a little from one side: an eye at the turn 0 looks north.
  const wanted_rad = -heading_rad - (pointing.pan_deg * Math.PI) / 180 + aslant_rad;
  view.eye.turn(turned_rad - wanted_rad, 0);
  turned_rad = wanted_rad;
  view.draw({ session, tracks: new Tracks(), chosen: 0, draft: null });
  for (const { right, up, colour } of CORNERS)
    for (const [x_share, y_share] of INWARDS) {
      const at = place_of(heading_rad, x_share * right, y_share * up).project(view.eye.camera);
      const pixel = new Uint8Array(4);
      const [x, y] = [(at.x + 1) / 2, (at.y + 1) / 2];
      gl.readPixels(x * canvas.width, y * canvas.height, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      const is = [...pixel.subarray(0, 3)];
      if (colour.every((value, i) => Math.abs(value - is[i]!) < 4)) found += 1;
      else
        faults.push(
          `${right} ${up} at ${x_share} ${y_share}: ${is.join()} where ${colour.join()} should be`,
        );
    }
}

/** What the panel lends to the scene, as one comes to another session like this one. */
async function lent(): Promise<string[]> {
  const wrong: string[] = [];
  let now_ms = 100;
  const blob = await new Promise<Blob | null>((done) => picture.toBlob(done));
  const station = {
    session,
    chosen: 0 as number | null,
    wire: { picture: () => Promise.resolve(blob) },
    clock_ms: () => now_ms,
    chosen_name: () => 'rov',
  };
  const panel = picture_panel(station as unknown as Station);
  const expect = (what: string, is_so: boolean): void => {
    if (!is_so) wrong.push(`expected ${what}`);
  };
  const fetched = async (): Promise<number | undefined> => {
    for (let i = 0; i < 100; i += 1) {
      panel.show();
      if (panel.last() !== null) break;
      await new Promise((done) => setTimeout(done, 20));
    }
    return panel.last()?.of.at;
  };
  const welcome = (at: number): void => {
    tell(session, {
      is: 'welcome',
      vehicles: [
        { vehicle: 0, name: 'rov' },
        { vehicle: 1, name: 'blind' },
      ],
      pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 1, at, wide: WIDE, high: HIGH }],
    });
  };
  expect('the picture', (await fetched()) === 0 && panel.last()?.is_old === false);
  now_ms = 5101;
  expect('an old one', panel.last()?.is_old === true);
  welcome(5000);
  expect('none of the session before', panel.last() === null);
  panel.show();
  expect('none of it once the panel is shown', panel.last() === null);
  expect('that of this session', (await fetched()) === 5000 && panel.last()?.is_old === false);
  station.chosen = 1;
  expect('none of another vehicle', panel.last() === null);
  panel.show();
  station.chosen = 0;
  expect('none that was put away', panel.last() === null);
  expect('it again', (await fetched()) === 5000);
  // Asked for in one session, there in the next.
  welcome(5001);
  panel.show();
  welcome(5002);
  await new Promise((done) => setTimeout(done, 200));
  expect('none that was asked for before', panel.last() === null);
  expect('the last one', (await fetched()) === 5002);
  return wrong;
}
void lent().then((wrong) => {
  faults.push(...wrong);
  document.title = JSON.stringify({
    said: `the picture of a camera lies in its view: ${found} of 24 places have their colour`,
    fault: faults.slice(0, 4).join('; '),
  });
});
