// In a browser: where a hull is drawn, beside where its frame says it is. The frame goes the whole
// way, from the bytes of the server through the page to the picture; then marks on the hull (bow,
// masthead, starboard) are found in pictures from above and from the south, and held against
// Fossen's rotation: within 1 cm and 0.1 degrees, 4 km away.
import {
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  SphereGeometry,
  Vector3,
  WebGLRenderTarget,
  WebGLRenderer,
  type BufferAttribute,
  type Object3D,
  type Scene,
} from 'three';
import { SceneView } from 'page/scene/scene_view';
import { decode_frame } from 'page/session/frame';
import { empty_session, show_frame, tell } from 'page/session/state';
import { Tracks } from 'page/view/tracks';
import { body_to_ned, type Triple } from './fossen';
import { frame_bytes } from './made_up_frame';

const [LONG_M, WIDE_M, ARM_M] = [6, 2.4, 3];
const [SIDE_PX, ACROSS_M] = [640, 8];
const degrees = (value: number): number => (value * Math.PI) / 180;

const session = empty_session();
const hull = { name: 'hull', kind: 'usv', length_m: LONG_M, width_m: WIDE_M };
tell(session, { is: 'welcome', vehicles: [{ vehicle: 3, ...hull }] });
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 160px; height: 90px';
const box = document.createElement('div');
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
const { scene } = view as unknown as { scene: Scene };

/** Which way its bow and its mast are in the shape, from the shape alone: pointed ahead. */
function ways_of(shape: Object3D): { bow: Vector3; mast: Vector3 } {
  const at: Vector3[] = [];
  shape.updateMatrixWorld(true);
  const back = shape.matrixWorld.clone().invert();
  shape.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const places = part.geometry.getAttribute('position') as BufferAttribute;
    const to_shape = back.clone().multiply(part.matrixWorld);
    for (let i = 0; i < places.count; i += 1)
      at.push(new Vector3().fromBufferAttribute(places, i).applyMatrix4(to_shape));
  });
  const wide = (z: number): number =>
    Math.max(...at.filter((it) => Math.abs(it.z - z) < 0.01).map((it) => Math.abs(it.x)));
  const ends = [LONG_M / 2, -LONG_M / 2];
  const [high, low] = [Math.max(...at.map((it) => it.y)), Math.min(...at.map((it) => it.y))];
  const z = ends.sort((a, b) => wide(a) - wide(b))[0]!;
  if (!(wide(z) < 0.01) || !(wide(-z) > 1)) throw new Error('the hull has no bow');
  return {
    bow: new Vector3(0, 0, Math.sign(z)),
    mast: new Vector3(0, high > -low ? 1 : -1, 0), // the house is on the deck
  };
}

/** Middle, bow, starboard, masthead: balls on it, each as far out as an arm. */
function marks_on(shape: Object3D): Mesh[] {
  const { bow, mast } = ways_of(shape);
  const starboard = bow.clone().cross(mast);
  return [new Vector3(), bow, starboard, mast].map((way) => {
    const paint = { color: 0xffffff, fog: false, depthTest: false, transparent: true };
    const ball = new Mesh(new SphereGeometry(0.1, 24, 16), new MeshBasicMaterial(paint));
    ball.position.copy(way).multiplyScalar(ARM_M);
    ball.renderOrder = 1000; // over the hull
    shape.add(ball);
    return ball;
  });
}

const renderer = new WebGLRenderer();
const target = new WebGLRenderTarget(SIDE_PX, SIDE_PX);
const half = ACROSS_M / 2;
const eye = new OrthographicCamera(-half, half, half, -half, 1, 400);

/** The middle of each mark, one at a time, m to the right and up of the middle of the picture. */
function seen(marks: readonly Mesh[]): (readonly [number, number])[] {
  return marks.map((mark) => {
    for (const other of marks) other.visible = other === mark;
    renderer.setRenderTarget(target);
    renderer.render(scene, eye);
    const pixels = new Uint8Array(4 * SIDE_PX * SIDE_PX);
    renderer.readRenderTargetPixels(target, 0, 0, SIDE_PX, SIDE_PX, pixels);
    let [right, up, many] = [0, 0, 0];
    for (let i = 0; i < SIDE_PX * SIDE_PX; i += 1) {
      if (pixels[4 * i]! + pixels[4 * i + 1]! + pixels[4 * i + 2]! < 3 * 255) continue;
      right += (i % SIDE_PX) + 0.5;
      up += Math.floor(i / SIDE_PX) + 0.5;
      many += 1;
    }
    const to_m = (sum: number): number => (sum / many / SIDE_PX - 0.5) * ACROSS_M;
    return [to_m(right), to_m(up)] as const;
  });
}

let [most_m, most_deg, many] = [0, 0, 0];
let marks: Mesh[] = [];
const at = { east_m: 3300, north_m: -2400, up_m: 1.25 };
for (const [roll_deg, pitch_deg, heading_deg] of [
  [0, 0, 0],
  [0, 0, 90],
  [35, 0, 200],
  [0, -50, 300],
  [-70, 40, 123],
  [150, 75, 251],
] as const) {
  many += 1;
  const [roll, pitch, yaw] = [roll_deg, pitch_deg, heading_deg].map(degrees) as [
    number,
    number,
    number,
  ];
  const told = { vehicle: 3, ...at, roll_rad: roll, pitch_rad: pitch, heading_rad: yaw };
  const frame = decode_frame(frame_bytes(many, many, [told]));
  if (frame === null) throw new Error('the frame was not read');
  show_frame(session, frame);
  view.draw({ session, tracks: new Tracks(), chosen: 3, draft: null });
  const shape = scene.getObjectByName('hull')!;
  if (marks.length === 0) marks = marks_on(shape);
  for (const thing of scene.children) thing.visible = thing === shape;
  scene.background = null;
  eye.up.set(0, 0, -1);
  eye.position.set(at.east_m, 200, -at.north_m);
  eye.lookAt(at.east_m, 0, -at.north_m);
  const from_above = seen(marks); // east, north
  eye.up.set(0, 1, 0);
  eye.position.set(at.east_m, at.up_m, -at.north_m + 200);
  eye.lookAt(at.east_m, at.up_m, -at.north_m);
  const from_south = seen(marks); // east, up
  const found = from_above.map(([east, north], nth): Triple => [north, east, -from_south[nth]![1]]);
  const [middle] = found;
  (
    [
      [0, 0, 0],
      [ARM_M, 0, 0],
      [0, ARM_M, 0],
      [0, 0, -ARM_M],
    ] as const
  ).forEach((of, nth) => {
    const is = body_to_ned(roll, pitch, yaw, of);
    const away = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    most_m = Math.max(most_m, Math.hypot(...away(found[nth]!, is)));
    // What is seen twice is at the same place east.
    most_m = Math.max(most_m, Math.abs(from_above[nth]![0] - from_south[nth]![0]));
    if (nth === 0) return;
    const arm = away(found[nth]!, middle!);
    const cosine = (arm[0] * is[0] + arm[1] * is[1] + arm[2] * is[2]) / Math.hypot(...arm) / ARM_M;
    most_deg = Math.max(most_deg, (Math.acos(Math.min(1, cosine)) * 180) / Math.PI);
  });
}
const is_right = most_m < 0.01 && most_deg < 0.1;
const off = `${(1000 * most_m).toFixed(1)} mm and ${most_deg.toFixed(3)} degrees`;
document.title = JSON.stringify({
  said: `a hull in ${many} attitudes, 4 km away, is drawn within ${off}`,
  fault: is_right ? '' : 'expected within 10 mm and 0.1 degrees',
});
