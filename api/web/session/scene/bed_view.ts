// The bed: as its grid has it, shaded so that its relief is seen, and level beyond; level all over
// where nobody tells a grid. What nobody knows is a hole.
import {
  BufferAttribute,
  BufferGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  type Color,
  type Vector3,
} from 'three';
import { bed_at, level_beyond_m, type Bed } from '../session/bed';
import type { Session } from '../session/state';
import { around, up_beyond } from './bed_edge';

const REACH_M = 20_000; // of what is level beyond a grid
const SHOWN_SLOPE = 0.5; // what a steep part of it is shaded as, however level it is
const MOST_STEEPENED = 30;
const SHADES = [0.4, 1.3] as const; // of the bed's colour, darkest and brightest

/** Rises to the east and to the north, as far as they are known. */
function slope_at(bed: Bed, row: number, column: number): [number, number] {
  const of = (r: number, c: number): number | null =>
    r < 0 || c < 0 || r >= bed.across || c >= bed.across
      ? null
      : (bed.up_m[r * bed.across + c] ?? null);
  const here = of(row, column);
  const rise = (before: number | null, after: number | null): number => {
    if (before !== null && after !== null) return (after - before) / (2 * bed.step_m);
    if (here === null) return 0;
    if (after !== null) return (after - here) / bed.step_m;
    return before === null ? 0 : (here - before) / bed.step_m;
  };
  return [
    rise(of(row, column - 1), of(row, column + 1)),
    rise(of(row - 1, column), of(row + 1, column)),
  ];
}

/** As maps have it: light from the north-west, 45 degrees high, slopes steepened to be seen. */
export function shades_of(bed: Bed): number[] {
  const slopes = bed.up_m.map((_, nth) =>
    slope_at(bed, Math.floor(nth / bed.across), nth % bed.across),
  );
  const steep = slopes.map(([east, north]) => Math.hypot(east, north)).sort((a, b) => a - b);
  const usual = steep[Math.floor(0.9 * (steep.length - 1))]!;
  const by = usual > 1e-6 ? Math.min(MOST_STEEPENED, Math.max(1, SHOWN_SLOPE / usual)) : 1;
  return slopes.map(([east, north]) => {
    const [x, y] = [by * east, by * north];
    // Over that of a level face.
    const lit = (1 + (x - y) / Math.SQRT2) / Math.hypot(x, y, 1);
    return Math.min(SHADES[1], Math.max(SHADES[0], lit));
  });
}

export function relief_of(bed: Bed, beyond_m: number): BufferGeometry {
  const { across, step_m, up_m } = bed;
  const half_m = ((across - 1) * step_m) / 2;
  const [middle_x, middle_z] = [bed.east_m + half_m, -(bed.north_m + half_m)];
  const places: number[] = [];
  const shades = shades_of(bed);
  up_m.forEach((up, nth) => {
    const [row, column] = [Math.floor(nth / across), nth % across];
    places.push(bed.east_m + step_m * column, up ?? beyond_m, -(bed.north_m + step_m * row));
  });
  // Its edge goes over one step to the level beyond.
  const edge = around(across);
  for (const out of [(half_m + step_m) / half_m, REACH_M / half_m])
    for (const nth of edge) {
      const [x, z] = [places[3 * nth]! - middle_x, places[3 * nth + 2]! - middle_z];
      places.push(middle_x + out * x, beyond_m, middle_z + out * z);
      shades.push(1);
    }
  const corners: number[] = [];
  const is_known = (nth: number): boolean => nth >= up_m.length || up_m[nth] != null;
  const face = (...three: [number, number, number]): void => {
    if (three.every(is_known)) corners.push(...three);
  };
  for (let row = 0; row + 1 < across; row += 1)
    for (let column = 0; column + 1 < across; column += 1) {
      const sw = row * across + column;
      face(sw, sw + 1, sw + across);
      face(sw + 1, sw + across + 1, sw + across);
    }
  const [near, far] = [up_m.length, up_m.length + edge.length];
  edge.forEach((inner, i) => {
    const next = (i + 1) % edge.length;
    face(inner, near + i, near + next);
    face(inner, near + next, edge[next]!);
    face(near + i, far + i, far + next);
    face(near + i, far + next, near + next);
  });
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
  const grey = Float32Array.from(shades.flatMap((shade) => [shade, shade, shade]));
  made.setAttribute('color', new BufferAttribute(grey, 3));
  made.setIndex(corners);
  return made;
}

export class BedView {
  readonly group = new Group();
  private grid: Bed | null = null;
  private beyond_m = 0; // the level beyond the grid
  private level_m: number | null = null;
  private readonly level = new Mesh(new PlaneGeometry(6000, 6000), new MeshBasicMaterial());
  private readonly relief = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({ vertexColors: true }),
  );

  constructor() {
    this.level.rotation.x = -Math.PI / 2;
    this.group.add(this.level, this.relief);
  }

  /** The grid that is drawn; nothing: none is. */
  get of(): Bed | null {
    return this.grid;
  }

  /** Of what is drawn; nothing: no bed is drawn there. */
  up_at(east_m: number, north_m: number): number | null {
    const { grid } = this;
    if (grid === null) return this.level_m;
    const reach_m = (grid.across - 1) * grid.step_m;
    const [right, up] = [east_m - grid.east_m, north_m - grid.north_m];
    const is_within = right >= 0 && up >= 0 && right <= reach_m && up <= reach_m;
    return is_within
      ? bed_at(grid, east_m, north_m)
      : up_beyond(grid, this.beyond_m, east_m, north_m);
  }

  /** What is told of it, before anything is laid on it. */
  take(session: Session): void {
    if (session.bed !== this.grid) {
      this.grid = session.bed;
      this.beyond_m = this.grid === null ? 0 : level_beyond_m(this.grid);
      this.relief.geometry.dispose();
      this.relief.geometry =
        this.grid === null ? new BufferGeometry() : relief_of(this.grid, this.beyond_m);
    }
    this.level_m = this.grid === null ? level_of(session) : null;
    this.relief.visible = this.grid !== null;
    this.level.visible = this.level_m !== null;
  }

  show(eye: Vector3, colour: Color): void {
    this.level.position.set(eye.x, this.level_m ?? 0, eye.z);
    this.level.material.color.copy(colour);
    this.relief.material.color.copy(colour);
  }
}

/** Where the vehicles measure it, the deepest; else the depth that the waves were made for. */
function level_of(session: Session): number | null {
  let deepest: number | null = null;
  for (const pose of session.poses.values()) {
    if (pose.bed_m === null) continue;
    const bed_m = pose.up_m - pose.bed_m;
    if (deepest === null || bed_m < deepest) deepest = bed_m;
  }
  return deepest ?? (session.sea === null ? null : -session.sea.depth_m);
}
