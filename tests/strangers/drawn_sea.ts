// In a browser: the heights of the surface as the graphics card draws it, beside the sum of its
// waves, within 1 cm. Bundled and opened by scene-drawn.
import {
  FloatType,
  NoBlending,
  OrthographicCamera,
  Scene,
  Vector2,
  WebGLRenderTarget,
  WebGLRenderer,
} from 'three';
import { Water } from 'page/scene/water';
import { elevation_m, type Sea } from 'page/session/sea';
import { made_up_sea } from './made_up_waves';

const renderer = new WebGLRenderer();
const target = new WebGLRenderTarget(1, 1, { type: FloatType });
const camera = new OrthographicCamera(-0.001, 0.001, 0.001, -0.001, 1, 200);
const water = new Water();
water.mesh.material.fragmentShader = `
varying vec3 seen_from;
void main() { gl_FragColor = vec4(cameraPosition.y - seen_from.y, 0.0, 0.0, 1.0); }`;
water.mesh.material.blending = NoBlending;
const scene = new Scene();
scene.add(water.mesh);

function drawn_m(
  sea: Sea | null,
  at: Vector2,
  about: Vector2,
  factor: number,
  time_s: number,
): number {
  water.show(sea, factor, time_s, about);
  camera.position.set(at.x, 100, -at.y);
  camera.lookAt(at.x, 0, -at.y);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const texel = new Float32Array(4);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, texel);
  return texel[0] ?? Number.NaN;
}

// A calm sea is level, before there are waves and after.
const calm_m = (): number => drawn_m(null, new Vector2(3, 4), new Vector2(), 1, 5);
let most_m = Math.abs(calm_m()); // off
let highest_m = 0;
for (const buoy of [new Vector2(0, 0), new Vector2(812.5, -4310), new Vector2(-2500, 77)])
  for (const [factor, time_s] of [[1, 0], [1, 93.7], [0.6, 250_000.3]] as const)
    for (const off of [new Vector2(0, 0), new Vector2(4.2, -2.6)]) {
      const is_m = elevation_m(made_up_sea, factor, buoy.x, buoy.y, time_s);
      const drawn = drawn_m(made_up_sea, buoy, buoy.clone().add(off), factor, time_s);
      most_m = Math.max(most_m, Math.abs(drawn - is_m));
      highest_m = Math.max(highest_m, Math.abs(is_m));
    }
most_m = Math.max(most_m, Math.abs(calm_m()));
const within_mm = (1000 * most_m).toFixed(1);
const said = `18 heights of up to ${highest_m.toFixed(2)} m, drawn within ${within_mm} mm`;
const is_right = most_m < 0.01 && highest_m > 0.5; // a sea that hardly moves proves nothing
document.title = JSON.stringify({ said, fault: is_right ? '' : 'expected within 10 mm' });
