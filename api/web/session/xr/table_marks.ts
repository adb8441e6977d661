// What is too small to be seen at 1:500 has a mark as large as a finger tip. Under it all lies the
// sea as a disc of glass, and the bed as a plate.
import {
  CircleGeometry,
  Color,
  ConeGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
  type Scene,
} from 'three';
import { colours } from '../look/palette';
import { at_place, turned } from '../scene/axes';
import { Kept } from '../scene/kept';
import type { Session } from '../session/state';
import type { PlanDrawing } from '../view/plan_view';
import { TABLE_SCALE } from './table';

const MARK_M = 0.016 * TABLE_SCALE;
const BALL_M = 0.009 * TABLE_SCALE;
const BORDER_M = 0.1 * TABLE_SCALE;
const MOST_M = 2.5 * TABLE_SCALE;

/** About the middle, as far as something of the run is. */
function table_reach_m(session: Session, middle: Vector3): number {
  const places = [...session.poses.values(), ...session.structures];
  const away = places.map((it) => Math.hypot(it.east_m - middle.x, it.north_m + middle.z));
  return Math.min(MOST_M, Math.max(0, ...away) + BORDER_M);
}

export class TableMarks {
  private readonly kept: Kept;
  private readonly plates = new Group();
  private readonly sea: Mesh<CircleGeometry, MeshBasicMaterial>;
  private readonly bed: Mesh<CircleGeometry, MeshBasicMaterial>;

  constructor(private readonly scene: Scene) {
    this.kept = new Kept(scene);
    const disc = new CircleGeometry(1, 96);
    disc.rotateX(-Math.PI / 2);
    const glass = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.35,
      depthWrite: false,
      fog: false,
    });
    this.sea = new Mesh(disc, glass);
    this.bed = new Mesh(disc, new MeshBasicMaterial({ fog: false }));
    this.plates.add(this.bed, this.sea);
    scene.add(this.plates);
  }

  show(
    session: Session,
    chosen: number | null,
    draft: PlanDrawing['draft'],
    bed_m: number | null,
    middle: Vector3,
  ): void {
    const { accent, amber, alarm, quiet, water, bed } = colours();
    const reach_m = table_reach_m(session, middle);
    this.plates.position.copy(middle);
    this.plates.scale.set(reach_m, 1, reach_m);
    this.sea.material.color.set(water);
    this.bed.material.color.copy(new Color(bed));
    this.bed.visible = bed_m !== null;
    this.bed.position.y = bed_m ?? 0;
    for (const pose of session.poses.values()) {
      const mark = this.kept.of(`mark ${pose.vehicle}`, () => {
        const cone = new ConeGeometry(0.5 * MARK_M, 2 * MARK_M, 12);
        cone.rotateX(-Math.PI / 2);
        return new Mesh(cone, new MeshBasicMaterial({ fog: false }));
      });
      mark.material.color.set(pose.vehicle === chosen ? accent : amber);
      mark.position.copy(at_place(pose));
      mark.rotation.copy(turned(pose));
      const up_down = [at_place(pose), at_place({ ...pose, up_m: 0 })];
      this.kept.line(`mark line ${pose.vehicle}`, up_down, quiet);
    }
    draft?.places.forEach((place, nth) => {
      const ball = this.kept.of(`place ${nth}`, () => {
        return new Mesh(new SphereGeometry(BALL_M, 14, 10), new MeshBasicMaterial({ fog: false }));
      });
      const colour = draft.is_refused ? alarm : accent;
      ball.material.color.set(nth === draft.picked ? amber : colour);
      ball.position.copy(at_place(place));
    });
    this.kept.drop_the_rest();
  }

  dispose(): void {
    this.kept.drop_the_rest();
    this.scene.remove(this.plates);
    this.sea.geometry.dispose(); // the bed's too
    this.sea.material.dispose();
    this.bed.material.dispose();
  }
}
