// The surface of the sea: all waves of the run, summed for each corner of a mesh by the graphics
// card. The phases of the waves at the mesh's middle are made here, in double precision, so that
// they keep their digits days after the start and kilometres away.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FloatType,
  Mesh,
  RGBAFormat,
  ShaderMaterial,
  UniformsLib,
  UniformsUtils,
  Vector2,
  type Color,
} from 'three';
import { phase_of, type Sea } from '../session/sea';
import { set_all_about } from './met';

// Corners lie 0.7 m apart in the middle, and 5 parts in 100 of the way to it farther out.
const CELLS = 256; // along each side
const CELLS_FOR_TWO_EYES = 128; // and 72 pictures a second
const REACH_M = 3000;
const STRETCH = 6;

const VERTEX = `
uniform sampler2D waves;
uniform int many;
uniform float factor;
attribute float spacing;
varying vec3 normal_up;
varying vec3 seen_from;
#include <fog_pars_vertex>
void main() {
  float up = 0.0;
  vec2 slope = vec2(0.0);
  for (int i = 0; i < many; ++i) {
    vec4 wave = texelFetch(waves, ivec2(i, 0), 0);  // amplitude, k east, k north, phase
    float length_m = 6.2831853 / length(wave.yz);
    // Waves that the corners are too far apart for would show as others that are not there.
    float share = smoothstep(2.0, 4.0, length_m / spacing);
    float theta = wave.y * position.x - wave.z * position.z + wave.w;
    up += share * wave.x * cos(theta);
    slope -= share * wave.x * sin(theta) * wave.yz;
  }
  normal_up = normalize(vec3(-factor * slope.x, 1.0, factor * slope.y));
  vec4 world = modelMatrix * vec4(position.x, factor * up, position.z, 1.0);
  seen_from = cameraPosition - world.xyz;
  vec4 mvPosition = viewMatrix * world;
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;

const FRAGMENT = `
uniform vec3 deep;
uniform vec3 sky;
varying vec3 normal_up;
varying vec3 seen_from;
#include <fog_pars_fragment>
void main() {
  float cosine = abs(dot(normalize(seen_from), normalize(normal_up)));
  // Schlick's share of what water mirrors, as in the twin's renders.
  float mirrored = 0.02 + 0.98 * pow(1.0 - cosine, 5.0);
  vec3 shade = deep * (0.75 + 0.25 * normalize(normal_up).y);
  gl_FragColor = vec4(mix(shade, sky, mirrored), 0.86);
  #include <colorspace_fragment>
  #include <fog_fragment>
}`;

/** Corners about the middle, and how far apart they lie. */
function mesh(cells: number): BufferGeometry {
  const along = (i: number): number => {
    return (REACH_M / Math.sinh(STRETCH)) * Math.sinh(STRETCH * ((2 * i) / cells - 1));
  };
  const side = cells + 1;
  const places = new Float32Array(3 * side * side);
  const spacing = new Float32Array(side * side);
  const corners: number[] = [];
  for (let row = 0; row < side; row += 1) {
    for (let column = 0; column < side; column += 1) {
      const nth = row * side + column;
      places.set([along(column), 0, along(row)], 3 * nth);
      const apart = (i: number): number =>
        along(Math.min(i + 1, cells)) - along(Math.max(i - 1, 0));
      spacing[nth] = Math.max(apart(row), apart(column)) / 2;
      if (row < cells && column < cells) {
        corners.push(nth, nth + side, nth + 1, nth + 1, nth + side, nth + side + 1);
      }
    }
  }
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(places, 3));
  made.setAttribute('spacing', new BufferAttribute(spacing, 1));
  made.setIndex(corners);
  return made;
}

/** Four numbers of each wave; of a calm sea those of none. */
function texture_of(texels: Float32Array<ArrayBuffer>): DataTexture {
  return new DataTexture(texels, texels.length / 4, 1, RGBAFormat, FloatType);
}

export class Water {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private sea: Sea | null = null;
  private are_two = false;
  private texels = new Float32Array(4);
  private texture = texture_of(this.texels);

  constructor() {
    const uniforms = UniformsUtils.merge([
      UniformsLib.fog,
      { many: { value: 0 }, factor: { value: 1 }, deep: { value: null }, sky: { value: null } },
    ]);
    const material = new ShaderMaterial({
      uniforms: { ...uniforms, waves: { value: this.texture } },
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      transparent: true,
      fog: true,
    });
    this.mesh = new Mesh(mesh(CELLS), material);
    this.mesh.frustumCulled = false;
    this.mesh.name = 'sea';
    set_all_about(this.mesh);
  }

  /** For who has a picture for each eye: with fewer corners. */
  draw_for_two_eyes(are_two: boolean): void {
    if (are_two === this.are_two) return;
    this.are_two = are_two;
    this.mesh.geometry.dispose();
    this.mesh.geometry = mesh(are_two ? CELLS_FOR_TWO_EYES : CELLS);
  }

  paint(deep: Color, sky: Color): void {
    const { uniforms } = this.mesh.material;
    uniforms.deep!.value = deep;
    uniforms.sky!.value = sky;
  }

  /** The surface about a place, at a time of the run. */
  show(sea: Sea | null, factor: number, time_s: number, about: Vector2): void {
    const { uniforms } = this.mesh.material;
    const many = sea?.waves.length ?? 0;
    if (sea !== this.sea) {
      this.sea = sea;
      this.texels = new Float32Array(4 * Math.max(1, many));
      this.texture.dispose();
      this.texture = texture_of(this.texels);
      uniforms.waves!.value = this.texture;
    }
    sea?.waves.forEach((wave, nth) => {
      const phase = phase_of(wave, about.x, about.y, time_s);
      this.texels.set([wave.amplitude_m, wave.east_rad_m, wave.north_rad_m, phase], 4 * nth);
    });
    this.texture.needsUpdate = true;
    uniforms.many!.value = many;
    uniforms.factor!.value = factor;
    this.mesh.position.set(about.x, 0, -about.y);
  }
}
