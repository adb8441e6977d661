// In a browser: three buoys as high as the server told them, and the sea that is drawn under them,
// at the same frame: within 1 cm. Their heights are the sum of the waves, written out here once
// more from api/docs/session_wire.md.
import {
  FloatType,
  NoBlending,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderTarget,
  WebGLRenderer,
  type Mesh,
  type ShaderMaterial,
} from 'three';
import { SceneView } from 'page/scene/scene_view';
import { decode_frame } from 'page/session/frame';
import { empty_session, show_frame, tell } from 'page/session/state';
import { Tracks } from 'page/view/tracks';
import { frame_bytes } from './made_up_frame';
import { made_up_sea } from './made_up_waves';

const FACTOR = 0.8;
const waves = made_up_sea!.waves;
const told = waves.map((it) => [
  it.amplitude_m,
  it.east_rad_m,
  it.north_rad_m,
  it.rad_s,
  it.phase_rad,
]);
function height_m(east_m: number, north_m: number, time_s: number): number {
  let sum = 0;
  for (const [a, k_east, k_north, omega, phase] of told)
    sum += a! * Math.cos(k_east! * east_m + k_north! * north_m - omega! * time_s + phase!);
  return FACTOR * sum;
}

const places = [
  [812, -4310],
  [826, -4302],
  [803, -4331],
] as const;
const session = empty_session();
tell(session, {
  is: 'welcome',
  sea: { depth_m: 60, waves: told },
  weather: { waves_factor: FACTOR },
  vehicles: places.map((_, i) => {
    return { vehicle: i, name: `buoy ${i}`, kind: 'usv', length_m: 5, width_m: 2 };
  }),
});
const canvas = document.createElement('canvas');
canvas.style.cssText = 'width: 160px; height: 90px';
const box = document.createElement('div');
document.body.append(canvas, box);
const view = new SceneView(canvas, box);
const { scene } = view as unknown as { scene: Scene };
const sea = scene.getObjectByName('sea') as Mesh;
// The same surface alone, in a picture whose colours are heights.
const heights = new Scene();
const paint = (sea.material as ShaderMaterial).clone();
paint.fragmentShader = `
varying vec3 seen_from;
void main() { gl_FragColor = vec4(cameraPosition.y - seen_from.y, 0.0, 0.0, 1.0); }`;
paint.blending = NoBlending;
const renderer = new WebGLRenderer();
const target = new WebGLRenderTarget(1, 1, { type: FloatType });
const eye = new OrthographicCamera(-0.001, 0.001, 0.001, -0.001, 1, 200);
function drawn_sea_m(x: number, z: number): number {
  const before = sea.material;
  paint.uniforms = (before as ShaderMaterial).uniforms;
  sea.material = paint;
  heights.add(sea);
  eye.position.set(x, 100, z);
  eye.lookAt(x, 0, z);
  renderer.setRenderTarget(target);
  renderer.render(heights, eye);
  scene.add(sea);
  sea.material = before;
  const texel = new Float32Array(4);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, texel);
  return texel[0] ?? Number.NaN;
}

let [most_m, highest_m, many] = [0, 0, 0];
for (const time_s of [93.7, 94.95, 7200.05]) {
  const poses = places.map(([east_m, north_m], vehicle) => {
    return { vehicle, east_m, north_m, up_m: height_m(east_m, north_m, time_s) };
  });
  const frame = decode_frame(frame_bytes((many += 1), time_s, poses));
  if (frame === null) throw new Error('the frame was not read');
  show_frame(session, frame);
  view.draw({ session, tracks: new Tracks(), chosen: 0, draft: null });
  for (const [nth] of places.entries()) {
    const shape = scene.getObjectByName(`buoy ${nth}`)!;
    const at = new Vector3().setFromMatrixPosition(shape.matrixWorld);
    most_m = Math.max(most_m, Math.abs(at.y - drawn_sea_m(at.x, at.z)));
    highest_m = Math.max(highest_m, Math.abs(at.y));
  }
}
const said = `9 heights of buoys, up to ${highest_m.toFixed(2)} m, on the drawn sea within`;
document.title = JSON.stringify({
  said: `${said} ${(1000 * most_m).toFixed(1)} mm`,
  fault: most_m < 0.01 && highest_m > 0.4 ? '' : 'expected within 10 mm',
});
