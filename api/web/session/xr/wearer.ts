// Who wears a headset, as the scene draws them and what they see: the rig with its hands, its
// board, the frame about the view, names as signs, and the table. No browser's session is in it.
import { Vector3, type Scene } from 'three';
import type { Shown, SceneView, Visitor } from '../scene/scene_view';
import type { Name } from '../scene/labels';
import { Board } from './board';
import { HandModel } from './hand_models';
import { NameSigns } from './name_signs';
import type { Side } from './reading';
import { Rig } from './rig';
import { lay_table, table_middle } from './table';
import { TableMarks } from './table_marks';
import { ThrowMark } from './throw_mark';
import { Vignette } from './vignette';

export class Wearer implements Visitor {
  readonly rig = new Rig();
  readonly board = new Board();
  readonly vignette = new Vignette();
  readonly throw_mark = new ThrowMark();
  readonly hands: Readonly<Record<Side, HandModel>> = {
    left: new HandModel(),
    right: new HandModel(),
  };
  private readonly signs = new NameSigns();
  private readonly scene: Scene;
  private marks: TableMarks | null = null;
  private middle = new Vector3();

  constructor(private readonly view: SceneView) {
    this.scene = view.scene;
    const { rig } = this;
    rig.inner.add(this.board.mesh, this.hands.left.group, this.hands.right.group);
    rig.head.add(this.vignette.group);
    this.scene.add(rig.group, this.throw_mark.group, this.signs.group);
    view.visitor = this;
  }

  get camera(): Rig['camera'] {
    return this.rig.camera;
  }
  get is_table(): boolean {
    return this.marks !== null;
  }
  eye(): Vector3 {
    return this.rig.head_at();
  }

  /** The farm as a table about the chosen vehicle, in front or at a place of the headset's. */
  lay_table(shown: Shown, at: Vector3 | null = null): void {
    this.rig.lift_m = 0; // a table is before who sits, too
    this.marks ??= new TableMarks(this.scene);
    this.middle = table_middle(shown.session, shown.chosen);
    lay_table(this.rig, this.middle, at);
  }

  /** Stands in the scene, the head at a place. */
  stand(at: Vector3, turn_rad: number, head_turn_rad: number): void {
    this.marks?.dispose();
    this.marks = null;
    this.rig.face(at, turn_rad, head_turn_rad);
  }

  before_drawn({ session, chosen, draft }: Shown, names: readonly Name[]): void {
    this.signs.show(names, this.rig.head, performance.now());
    this.marks?.show(
      session,
      chosen,
      draft,
      this.view.surround.bed_under(this.middle),
      this.middle,
    );
  }

  dispose(): void {
    this.view.visitor = null;
    this.marks?.dispose();
    this.signs.dispose();
    this.board.dispose();
    this.vignette.dispose();
    this.throw_mark.dispose();
    for (const hand of Object.values(this.hands)) hand.dispose();
    this.scene.remove(this.rig.group, this.throw_mark.group, this.signs.group);
  }
}
