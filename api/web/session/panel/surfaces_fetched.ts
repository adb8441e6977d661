// Surfaces that are inspected, fetched from the server for the scene: each once, one at a time.
import type { InspectedView } from '../scene/inspected_view';
import { surface_key, type Surface } from '../session/inspected';
import { read_surface_mesh } from '../session/surface_mesh';
import type { Station } from '../station';

const AGAIN_AFTER_MS = 10_000;

/** @return to be called while the scene is shown; asks where one is missing */
export function surfaces_fetched(
  station: Pick<Station, 'session' | 'wire'>,
  on_change: () => void,
): (into: Pick<InspectedView, 'has' | 'take'>) => void {
  const not_before_ms = new WeakMap<Surface, number>(); // each welcome has its own surfaces
  let is_asking = false;
  return (into) => {
    if (is_asking) return;
    const now_ms = performance.now();
    const is_due = (it: Surface): boolean =>
      !into.has(it) && now_ms >= (not_before_ms.get(it) ?? -Infinity);
    const surface = [...station.session.surfaces.values()].find(is_due);
    if (surface === undefined) return;
    is_asking = true;
    const key = surface_key(surface);
    not_before_ms.set(surface, now_ms + AGAIN_AFTER_MS);
    void station.wire
      .surface(surface.vehicle, surface.surface)
      .then((told) => {
        const mesh = read_surface_mesh(told);
        // Of a session that is gone it is nobody's.
        if (mesh === null || station.session.surfaces.get(key) !== surface) return;
        into.take(surface, mesh);
        on_change();
      })
      .finally(() => (is_asking = false));
  };
}
