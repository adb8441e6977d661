// A way under edit: its places, what joins them, and each one's plumb line to surface and bed.
import { Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import type { Colours } from '../look/palette';
import { level_text } from '../look/units';
import type { PlanDrawing } from '../view/plan_view';
import { at_place } from './axes';
import type { BedView } from './bed_view';
import type { Kept } from './kept';
import type { Name } from './labels';

/** Each by its number, with its depth or height. */
export function draft_names(draft: PlanDrawing['draft']): Name[] {
  return (draft?.places ?? []).map((place, nth) => ({
    key: `draft ${nth}`,
    text: `${nth + 1}: ${level_text(place.up_m)}`,
    at: place,
    tone: nth === draft?.picked ? 'chosen' : '',
  }));
}

export function place_draft(
  kept: Kept,
  draft: PlanDrawing['draft'],
  bed: Pick<BedView, 'up_at'>,
  { accent, alarm, amber }: Pick<Colours, 'accent' | 'alarm' | 'amber'>,
): void {
  if (draft === null || draft.places.length === 0) return;
  const colour = draft.is_refused ? alarm : accent;
  draft.places.forEach((place, nth) => {
    const ball = kept.of(`draft ${nth}`, () => {
      return new Mesh(new SphereGeometry(0.5, 14, 10), new MeshBasicMaterial({ fog: false }));
    });
    ball.material.color.set(nth === draft.picked ? amber : colour);
    ball.position.copy(at_place(place));
    const ends = [at_place({ ...place, up_m: Math.max(0, place.up_m) })];
    const bed_m = bed.up_at(place.east_m, place.north_m) ?? 0;
    ends.push(at_place({ ...place, up_m: Math.min(place.up_m, bed_m) }));
    kept.line(`draft plumb ${nth}`, ends, nth === draft.picked ? amber : colour);
  });
  const through = draft.places.map(at_place);
  if (draft.is_loop) through.push(through[0]!);
  kept.line('draft way', through, colour);
}
