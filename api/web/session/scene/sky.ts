// The sky about the eye: paler to the horizon, warm there where the sun is low, and the sun's disc.
import { BackSide, Color, Mesh, ShaderMaterial, SphereGeometry, Vector3 } from 'three';
import type { Daylight } from './daylight';
import { set_all_about } from './met';

const REACH_M = 15_000;
const SUN_RADIUS_DEG = 0.27;

const VERTEX = `
varying vec3 look;
void main() {
  look = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const FRAGMENT = `
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 sun;
uniform vec3 to_sun;
varying vec3 look;
void main() {
  vec3 way = normalize(look);
  float high = 1.0 - pow(1.0 - clamp(way.y, 0.0, 1.0), 3.0);
  float near = max(0.0, dot(way, to_sun));
  // The warm light lies on the sun's side.
  vec3 low = mix(zenith, horizon, 0.35 + 0.65 * near);
  float disc = smoothstep(cos(radians(${(2 * SUN_RADIUS_DEG).toFixed(2)})),
                          cos(radians(${SUN_RADIUS_DEG.toFixed(2)})), dot(way, to_sun));
  gl_FragColor = vec4(mix(mix(low, zenith, high), sun, disc), 1.0);
  #include <colorspace_fragment>
}`;

export class Sky {
  readonly mesh: Mesh<SphereGeometry, ShaderMaterial>;

  constructor() {
    const colour = (): { value: Color } => ({ value: new Color() });
    const uniforms = {
      zenith: colour(),
      horizon: colour(),
      sun: colour(),
      to_sun: { value: new Vector3(0, 1, 0) },
    };
    const material = new ShaderMaterial({
      uniforms,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: BackSide,
      depthWrite: false,
    });
    this.mesh = new Mesh(new SphereGeometry(REACH_M, 32, 16), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
    this.mesh.name = 'sky';
    set_all_about(this.mesh);
  }

  show(daylight: Daylight, about: Vector3): void {
    const { uniforms } = this.mesh.material;
    (uniforms.zenith!.value as Color).copy(daylight.zenith);
    (uniforms.horizon!.value as Color).copy(daylight.horizon);
    (uniforms.sun!.value as Color).copy(daylight.sun);
    (uniforms.to_sun!.value as Vector3).copy(daylight.to_sun);
    this.mesh.position.copy(about);
  }
}
