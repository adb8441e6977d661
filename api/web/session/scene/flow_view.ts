// The current of the forecast: arrows over a level slice at any depth, and at a vehicle a hodograph
// from the surface to the bed, each depth's current drawn from the plumb line through it.
import {
  ArrowHelper,
  ConeGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  MeshBasicMaterial,
  Object3D,
  Vector3,
} from 'three';
import { current_at, type Current } from '../session/currents';
import { at_place, type Place } from './axes';
import { set_all_about } from './met';

const SIDE = 11; // arrows along each side of a slice
const SHOWN_M_PER_M_S = 12;
const SLOWEST_M_S = 0.005;

/** Towards where it flows, in the scene's axes. */
const towards = (it: Pick<Current, 'east_m_s' | 'north_m_s'>): Vector3 =>
  new Vector3(it.east_m_s, 0, -it.north_m_s);

/** A slice is as wide as the eye is away from it, its arrows all alike: the forecast is level. */
export class FlowSlice {
  readonly mesh: InstancedMesh<ConeGeometry, MeshBasicMaterial>;
  private readonly part = new Object3D();

  constructor() {
    const arrow = new ConeGeometry(0.12, 1, 6);
    arrow.rotateX(-Math.PI / 2); // its tip along -z
    this.mesh = new InstancedMesh(arrow, new MeshBasicMaterial({ fog: false }), SIDE * SIDE);
    this.mesh.frustumCulled = false;
    this.mesh.name = 'slice';
    set_all_about(this.mesh);
  }

  /** @return the current there; nothing: none is known at that depth, and none is drawn */
  show(
    currents: readonly Current[],
    up_m: number,
    { about, reach_m }: { about: Vector3; reach_m: number },
    colour: string,
  ): Current | null {
    const current = current_at(currents, up_m);
    const flow = current === null ? null : towards(current);
    this.mesh.visible = flow !== null && flow.length() > SLOWEST_M_S;
    if (flow === null || !this.mesh.visible) return current;
    const apart_m = (2 * reach_m) / (SIDE - 1);
    const long_m = Math.min(1.5 * apart_m, Math.max(0.15 * apart_m, flow.length() * apart_m));
    const { part } = this;
    part.rotation.set(0, Math.atan2(-flow.x, -flow.z), 0);
    part.scale.set(0.5 * apart_m, 0.5 * apart_m, long_m);
    for (let row = 0; row < SIDE; row += 1) {
      for (let column = 0; column < SIDE; column += 1) {
        // They stay where they are while the eye moves by less than from one to the next.
        const x = Math.round(about.x / apart_m) + column - (SIDE - 1) / 2;
        const z = Math.round(about.z / apart_m) + row - (SIDE - 1) / 2;
        part.position.set(x * apart_m, up_m, z * apart_m);
        part.updateMatrix();
        this.mesh.setMatrixAt(row * SIDE + column, part.matrix);
      }
    }
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.material.color.set(colour);
    return current;
  }
}

/** Arrows from the plumb line at a place, one for each depth that is told. */
export function hodograph(
  currents: readonly Current[],
  at: Place,
): { from: Vector3; to: Vector3 }[] {
  return currents.map((current) => {
    const from = at_place({ ...at, up_m: current.up_m });
    return { from, to: from.clone().addScaledVector(towards(current), SHOWN_M_PER_M_S) };
  });
}

export class Hodograph {
  readonly group = new Group();
  private readonly arrows: ArrowHelper[] = [];

  show(currents: readonly Current[], at: Place | null, colour: string): void {
    const drawn = at === null ? [] : hodograph(currents, at);
    while (this.arrows.length < drawn.length) {
      const arrow = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1);
      arrow.line.material = new LineBasicMaterial({ fog: false });
      arrow.cone.material = new MeshBasicMaterial({ fog: false });
      this.arrows.push(arrow);
      this.group.add(arrow);
    }
    this.arrows.forEach((arrow, nth) => {
      const one = drawn[nth];
      const way = one?.to.clone().sub(one.from);
      arrow.visible = way !== undefined && way.length() > SLOWEST_M_S * SHOWN_M_PER_M_S;
      if (one === undefined || way === undefined || !arrow.visible) return;
      arrow.position.copy(one.from);
      arrow.setDirection(way.clone().normalize());
      arrow.setLength(way.length(), Math.min(0.5, 0.3 * way.length()), 0.15);
      arrow.setColor(colour);
    });
  }
}
