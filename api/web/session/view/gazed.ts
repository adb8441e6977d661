// What lies under a place of the page, by name: a thing of the scene or the plan, else the panel.
import type { ScenePanel } from '../panel/scene_panel';
import type { Gazed } from '../session/attention';
import type { Session } from '../session/state';
import type { Pixel, Plane } from './camera';

const REACH_PX = 24;

/** The nearest vehicle, vessel or structure of the plan; empty: none is near. */
export function named_on_plan(session: Session, at: Pixel, to_pixel: (at: Plane) => Pixel): string {
  const things: (Plane & { name: string })[] = [
    ...[...session.poses.values()].map((pose) => ({
      ...pose,
      name: session.vehicles.get(pose.vehicle)?.name ?? '',
    })),
    ...session.vessels,
    ...session.structures,
  ];
  let [name, nearest_px] = ['', REACH_PX];
  for (const thing of things) {
    const { x, y } = to_pixel(thing);
    const px = Math.hypot(x - at.x, y - at.y);
    if (px >= nearest_px) continue;
    [name, nearest_px] = [thing.name, px];
  }
  return name;
}

export function gazed_on_page(
  scene: Pick<ScenePanel, 'is_open' | 'named_at' | 'named_ahead'>,
  plan: { canvas: HTMLCanvasElement; to_pixel: (at: Plane) => Pixel },
  session: () => Session,
): Gazed {
  return {
    under: (x, y) => {
      const element = document.elementFromPoint(x, y);
      if (element === null) return '';
      if (element.id === 'scene-canvas') return scene.named_at({ clientX: x, clientY: y });
      if (element === plan.canvas) {
        const { left, top } = plan.canvas.getBoundingClientRect();
        return named_on_plan(session(), { x: x - left, y: y - top }, plan.to_pixel);
      }
      return element.closest('section')?.querySelector('h2')?.textContent ?? '';
    },
    ahead: () => (scene.is_open() ? scene.named_ahead() : ''),
  };
}
