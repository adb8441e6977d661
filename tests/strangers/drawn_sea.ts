// In a browser: the heights of the surface as the graphics card draws it, beside the sum of its
// waves. Bundled and opened by drawn-sea; what it found is in the title.
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
import { elevation_m, read_sea } from 'page/session/sea';

// 64 waves of a Pierson-Moskowitz sea, spread about north-east; their phases evenly scattered.
const waves = Array.from({ length: 64 }, (_, i) => {
  const omega = 0.5 + 0.025 * i;
  const density = 0.0081 * 9.81 ** 2 * omega ** -5 * Math.exp(-1.25 * (0.75 / omega) ** 4);
  const towards = Math.PI / 4 + 0.8 * (((0.618034 * i) % 1) - 0.5);
  const k = omega ** 2 / 9.81;
  const amplitude = Math.sqrt(0.05 * density);
  const phase = 6.283 * ((0.754878 * i) % 1);
  return [amplitude, k * Math.cos(towards), k * Math.sin(towards), omega, phase];
});
const sea = read_sea({ depth_m: 60, waves });

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

function drawn_m(at: Vector2, about: Vector2, factor: number, time_s: number): number {
  water.show(sea, factor, time_s, about);
  camera.position.set(at.x, 100, -at.y);
  camera.lookAt(at.x, 0, -at.y);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const texel = new Float32Array(4);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, texel);
  return texel[0] ?? Number.NaN;
}

const found = [];
for (const buoy of [new Vector2(0, 0), new Vector2(812.5, -4310), new Vector2(-2500, 77)])
  for (const [factor, time_s] of [[1, 0], [1, 93.7], [0.6, 250_000.3]] as const)
    for (const off of [new Vector2(0, 0), new Vector2(4.2, -2.6)])
      found.push({
        drawn_m: drawn_m(buoy, buoy.clone().add(off), factor, time_s),
        is_m: elevation_m(sea, factor, buoy.x, buoy.y, time_s),
      });
document.title = JSON.stringify(found);
