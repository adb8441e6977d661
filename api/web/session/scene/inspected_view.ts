// Surfaces that are inspected, with their coverage painted on: what is seen as well as the plan
// asks, and what not yet. It is paint, not light: the same by night, and murky water hides less of
// it. From afar a surface is one box between the two tones.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  ShaderChunk,
  Sphere,
  Vector3,
  type Scene,
} from 'three';
import type { Colours } from '../look/palette';
import { surface_key, type Surface } from '../session/inspected';
import type { Session } from '../session/state';
import type { SurfaceMesh } from '../session/surface_mesh';
import { at_place, type Place } from './axes';
import { is_small, type Lens } from './detail';
import { Instances } from './instances';
import { give_names } from './met';

const OVER_M = 0.03; // over what it is painted on
const HIDDEN = 0.25; // so much of the way to it haze and water hide: it tells something
/** Of a facet that looks away: so much of its tone. Shape is seen, tones are not mixed up. */
export const LEAST_SHADE = 0.8;

export type Tones = Pick<Colours, 'covered' | 'not_covered'>;

interface Drawn {
  mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  /** Of each patch its first triangle; they are drawn in the order of their patches. */
  first: Uint32Array;
  shade: number[]; // of each triangle
  about: Sphere;
  size: Vector3;
  of: Pick<Surface, 'name' | 'patches'>;
  painted: { of: Surface; covered: Uint8Array; told: number; tones: string } | null;
}

interface Facet {
  corners: [Vector3, Vector3, Vector3];
  normal: Vector3;
  patch: number;
}

/** Those of patches, looking away from the middle of it, or up where it has no inside. */
function facets_of(mesh: SurfaceMesh): Facet[] {
  const corner = (nth: number): Vector3 => {
    const [east_m = 0, north_m = 0, up_m = 0] = mesh.corners.subarray(3 * nth, 3 * nth + 3);
    return at_place({ east_m, north_m, up_m });
  };
  const facets: Facet[] = [];
  const middle = new Vector3();
  mesh.patch_of.forEach((patch, nth) => {
    const [a = 0, b = 0, c = 0] = mesh.triangles.subarray(3 * nth, 3 * nth + 3);
    const corners: Facet['corners'] = [corner(a), corner(b), corner(c)];
    const normal = corners[1].clone().sub(corners[0]).cross(corners[2].clone().sub(corners[0]));
    if (patch < 0 || normal.length() < 1e-12) return;
    facets.push({ corners, normal: normal.normalize(), patch });
    middle.add(corners[0]);
  });
  middle.divideScalar(Math.max(1, facets.length));
  let outward = 0;
  let upward = 0;
  for (const { corners, normal } of facets) {
    outward += normal.dot(corners[0].clone().sub(middle));
    upward += normal.y;
  }
  const is_sheet = Math.abs(upward) > 0.5 * facets.length;
  if ((is_sheet ? upward : outward) < 0) for (const { normal } of facets) normal.negate();
  return facets.sort((a, b) => a.patch - b.patch);
}

/** And after the last patch how many there are; those of patches that nobody knows come after. */
function first_of(facets: readonly Facet[], patches: number): Uint32Array {
  const first = new Uint32Array(patches + 1);
  for (const { patch } of facets) if (patch < patches) first[patch + 1]! += 1;
  for (let patch = 0; patch < patches; patch += 1) first[patch + 1]! += first[patch]!;
  return first;
}

function drawn_of({ name, patches }: Surface, mesh: SurfaceMesh): Drawn {
  const facets = facets_of(mesh);
  const places = new Float32Array(9 * facets.length);
  // A place goes out for all of its facets alike, or there were gaps between these.
  const out = new Map<string, Vector3>();
  const key_of = (at: Vector3): string =>
    at
      .toArray()
      .map((it) => it.toFixed(3))
      .join(' ');
  for (const { corners, normal } of facets)
    for (const key of corners.map(key_of))
      out.set(key, (out.get(key) ?? new Vector3()).add(normal));
  for (const way of out.values()) way.setLength(OVER_M);
  facets.forEach(({ corners }, nth) =>
    corners.forEach((corner, i) => {
      corner
        .clone()
        .add(out.get(key_of(corner))!)
        .toArray(places, 9 * nth + 3 * i);
    }),
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(places.length), 3));
  geometry.computeBoundingSphere();
  geometry.computeBoundingBox();
  const light = new Vector3(0.5, 0.7, 0.5).normalize();
  const paint = new MeshBasicMaterial({
    vertexColors: true,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -4,
  });
  paint.onBeforeCompile = (shader) => {
    const through = ShaderChunk.fog_fragment.replace('vFogDepth', `${HIDDEN} * vFogDepth`);
    shader.fragmentShader = shader.fragmentShader.replace('#include <fog_fragment>', through);
  };
  return {
    mesh: new Mesh(geometry, paint),
    first: first_of(facets, patches),
    shade: facets.map(
      ({ normal }) => LEAST_SHADE + ((1 - LEAST_SHADE) * (1 + normal.dot(light))) / 2,
    ),
    about: geometry.boundingSphere!,
    size: geometry.boundingBox!.getSize(new Vector3()),
    of: { name, patches },
    painted: null,
  };
}

export class InspectedView {
  private readonly drawn = new Map<string, Drawn>();
  private readonly group = new Group();
  private readonly boxes: Instances;
  /** Whose surfaces they are: another session may have some of the same names and numbers. */
  private of: { session: Session; id: string; start_utc_ms: number } | null = null;

  constructor(scene: Scene) {
    this.group.name = 'inspected';
    scene.add(this.group);
    const box = new BoxGeometry(1, 1, 1);
    this.boxes = new Instances(scene, box, new MeshBasicMaterial(), 'inspected far away');
  }

  has(surface: Surface): boolean {
    return this.drawn.has(surface_key(surface));
  }

  take(surface: Surface, mesh: SurfaceMesh): void {
    if (this.has(surface)) return;
    const made = drawn_of(surface, mesh);
    this.drawn.set(surface_key(surface), made);
    made.mesh.frustumCulled = false; // each picture takes what was painted for it
    give_names(made.mesh, [surface.name]);
    this.group.add(made.mesh);
  }

  /** Of those that are drawn. */
  middle_of(surface: Surface): Place | null {
    const about = this.drawn.get(surface_key(surface))?.about.center;
    return about === undefined ? null : { east_m: about.x, north_m: -about.z, up_m: about.y };
  }

  show(session: Session, lens: Lens, tones: Tones): void {
    this.drop_the_gone(session);
    this.boxes.begin();
    for (const [key, drawn] of this.drawn) {
      const surface = session.surfaces.get(key)!;
      const is_far = is_small(lens, drawn.about.center, 2 * drawn.about.radius);
      drawn.mesh.visible = !is_far;
      if (is_far) this.mark(surface, drawn, tones);
      else this.paint(surface, drawn, tones);
    }
    this.boxes.end();
    this.group.visible = true;
  }

  hide(session: Session): void {
    this.drop_the_gone(session);
    this.group.visible = false;
    this.boxes.clear();
  }

  private drop_the_gone(session: Session): void {
    const { id, start_utc_ms, surfaces } = session;
    // A start that is not told is not a number, which is the same as itself here.
    const is_of_it =
      this.of?.session === session &&
      this.of.id === id &&
      Object.is(this.of.start_utc_ms, start_utc_ms);
    const is_new = this.of !== null && !is_of_it;
    this.of = { session, id, start_utc_ms };
    for (const [key, drawn] of this.drawn) {
      const surface = surfaces.get(key);
      const { name, patches } = drawn.of;
      if (is_new || surface?.name !== name || surface.patches !== patches) this.drop(key, drawn);
    }
  }

  private drop(key: string, { mesh }: Drawn): void {
    this.group.remove(mesh);
    mesh.geometry.dispose();
    mesh.material.dispose();
    this.drawn.delete(key);
  }

  private mark(surface: Surface, { about, size }: Drawn, tones: Tones): void {
    const { part } = this.boxes;
    part.position.copy(about.center);
    part.scale.copy(size).max(new Vector3(0.1, 0.1, 0.1));
    const tone = new Color(tones.not_covered).lerp(new Color(tones.covered), surface.seen);
    this.boxes.add(tone, surface.name);
  }

  /** Only what is newly covered; all of it where the palette is another, or the link is new. */
  private paint(surface: Surface, drawn: Drawn, tones: Tones): void {
    const both = `${tones.covered} ${tones.not_covered}`;
    const { painted } = drawn;
    const is_known = painted?.of === surface && painted.tones === both;
    if (is_known && painted.told === surface.told) return;
    const before = is_known ? painted.covered : null;
    const [seen, not_yet] = [new Color(tones.covered), new Color(tones.not_covered)];
    const colour = drawn.mesh.geometry.getAttribute('color') as BufferAttribute;
    const into = colour.array as Float32Array;
    for (let patch = 0; patch < surface.patches; patch += 1) {
      const is_covered = surface.covered[patch]!;
      if (before !== null && before[patch] === is_covered) continue;
      const { r, g, b } = is_covered === 1 ? seen : not_yet;
      const [from, to] = [drawn.first[patch]!, drawn.first[patch + 1]!];
      for (let nth = from; nth < to; nth += 1) {
        const shade = drawn.shade[nth]!;
        for (let i = 9 * nth; i < 9 * nth + 9; i += 3) {
          into[i] = r * shade;
          into[i + 1] = g * shade;
          into[i + 2] = b * shade;
        }
      }
      if (before !== null) colour.addUpdateRange(9 * from, 9 * (to - from));
    }
    if (before === null) colour.clearUpdateRanges();
    colour.needsUpdate = true;
    const covered = surface.covered.slice();
    drawn.painted = { of: surface, covered, told: surface.told, tones: both };
  }
}
