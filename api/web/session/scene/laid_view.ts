// Cables on the bed and mooring lines, as they are told.
import { MeshBasicMaterial, OctahedronGeometry, type Scene } from 'three';
import type { Colours } from '../look/palette';
import { is_buried, type Cable, type Mooring } from '../session/laid';
import type { Point } from '../session/message';
import type { Session } from '../session/state';
import { at_place } from './axes';
import type { BedView } from './bed_view';
import type { Lens } from './detail';
import { Instances } from './instances';
import { Strands } from './strands';

const ANCHOR_M = 1;
const OVER_BED_M = 0.15;

/** Laid on the bed that is drawn: what is told between two places of it would be hidden. */
export function laid_on(
  bed: Pick<BedView, 'up_at'>,
  route: readonly Point[],
  every_m: number,
): Point[] {
  const made: Point[] = [];
  const lay = (at: Point): void => {
    const bed_m = bed.up_at(at.east_m, at.north_m);
    made.push({ ...at, up_m: Math.max(at.up_m, bed_m ?? at.up_m) + OVER_BED_M });
  };
  route.forEach((to, nth) => {
    const from = route[nth - 1];
    if (from !== undefined) {
      const long_m = Math.hypot(to.east_m - from.east_m, to.north_m - from.north_m);
      const parts = Math.min(1000, Math.ceil(long_m / every_m));
      for (let i = 1; i < parts; i += 1) {
        const between = (a: number, b: number): number => a + (i / parts) * (b - a);
        lay({
          east_m: between(from.east_m, to.east_m),
          north_m: between(from.north_m, to.north_m),
          up_m: between(from.up_m, to.up_m),
        });
      }
    }
    lay(to);
  });
  return made;
}

export class LaidView {
  private readonly cables: Strands;
  private readonly moorings: Strands;
  private readonly anchor_paint = new MeshBasicMaterial();
  private readonly anchors: Instances;
  private of: { cables: Cable[]; moorings: Mooring[]; bed: BedView['of'] } | null = null;

  constructor(scene: Scene) {
    this.cables = new Strands(scene);
    this.moorings = new Strands(scene);
    this.anchors = new Instances(scene, new OctahedronGeometry(ANCHOR_M), this.anchor_paint);
    this.anchors.end();
  }

  show(session: Session, bed: BedView, { eye }: Lens, paint: Colours): void {
    const { cables, moorings } = session;
    const is_new = this.of?.cables !== cables || this.of.moorings !== moorings;
    if (is_new || this.of?.bed !== bed.of) this.lay(session, bed);
    this.cables.show(eye, paint.ink);
    this.moorings.show(eye, paint.quiet);
    this.anchor_paint.color.set(paint.quiet);
    this.anchors.mesh.visible = moorings.length > 0;
  }

  hide(): void {
    this.cables.hide();
    this.moorings.hide();
    this.anchors.mesh.visible = false;
  }

  private lay(session: Session, bed: BedView): void {
    const { cables, moorings } = session;
    this.of = { cables, moorings, bed: bed.of };
    const every_m = bed.of === null ? Infinity : bed.of.step_m / 2;
    this.cables.lay(
      cables.map((cable) => ({
        through: laid_on(bed, cable.route, every_m).map(at_place),
        is_dashed: is_buried(cable),
      })),
    );
    this.moorings.lay(
      moorings.map(({ fairlead, anchor }) => ({
        through: [at_place(fairlead), at_place(anchor)],
        is_dashed: false,
      })),
    );
    this.anchors.begin();
    for (const { anchor } of moorings) {
      this.anchors.part.position.copy(at_place(anchor));
      this.anchors.add();
    }
    this.anchors.end();
  }
}
