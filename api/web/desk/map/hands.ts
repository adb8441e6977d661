// Mouse, touch and keys on the map: they move the camera, or choose a place.
import type { Camera, Size } from './projection';
import { moved, zoomed } from './projection';

export interface Handled {
  camera(): Camera;
  size(): Size;
  move(camera: Camera): void;
  choose(x: number, y: number): void;
  show_all(): void;
}

const CLICK_PX = 5;
const KEY_PX = 60;

export function listen_to_hands(node: HTMLElement | SVGElement, map: Handled): void {
  const touching = new Map<number, { x: number; y: number }>();
  let moved_px = 0;
  let most_fingers = 0;

  const at = (event: MouseEvent): { x: number; y: number } => {
    const box = node.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    node.setPointerCapture(event.pointerId);
    touching.set(event.pointerId, at(event));
    if (touching.size === 1) {
      moved_px = 0;
      most_fingers = 0;
    }
    most_fingers = Math.max(most_fingers, touching.size);
  };
  const move = (event: PointerEvent): void => {
    const before = touching.get(event.pointerId);
    if (before === undefined) return;
    const now = at(event);
    const others = [...touching].filter(([id]) => id !== event.pointerId);
    touching.set(event.pointerId, now);
    moved_px += Math.hypot(now.x - before.x, now.y - before.y);
    if (moved_px < CLICK_PX) return;
    const other = others[0]?.[1];
    if (other === undefined) {
      map.move(moved(map.camera(), map.size(), before.x - now.x, before.y - now.y));
      return;
    }
    const apart = (a: { x: number; y: number }): number =>
      Math.max(8, Math.hypot(a.x - other.x, a.y - other.y));
    const by = Math.log2(apart(now) / apart(before));
    const x = (now.x + other.x) / 2;
    const y = (now.y + other.y) / 2;
    const half = moved(map.camera(), map.size(), (before.x - now.x) / 2, (before.y - now.y) / 2);
    map.move(zoomed(half, map.size(), by, x, y));
  };
  const up = (event: PointerEvent): void => {
    if (!touching.delete(event.pointerId)) return;
    const is_click = touching.size === 0 && most_fingers === 1 && moved_px < CLICK_PX;
    if (is_click && event.type === 'pointerup') map.choose(at(event).x, at(event).y);
  };
  node.addEventListener('pointerdown', down as EventListener);
  node.addEventListener('pointermove', move as EventListener);
  node.addEventListener('pointerup', up as EventListener);
  node.addEventListener('pointercancel', up as EventListener);
  const turn = (event: WheelEvent): void => {
    event.preventDefault();
    const px = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaY;
    const { x, y } = at(event);
    map.move(zoomed(map.camera(), map.size(), Math.max(-1, Math.min(1, -px / 240)), x, y));
  };
  node.addEventListener('wheel', turn as EventListener, { passive: false });

  const press = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const size = map.size();
    const go = (right: number, downwards: number): void =>
      map.move(moved(map.camera(), size, right * KEY_PX, downwards * KEY_PX));
    const zoom = (by: number): void =>
      map.move(zoomed(map.camera(), size, by, size.width / 2, size.height / 2));
    const does: Record<string, () => void> = {
      ArrowLeft: () => go(-1, 0),
      ArrowRight: () => go(1, 0),
      ArrowUp: () => go(0, -1),
      ArrowDown: () => go(0, 1),
      '+': () => zoom(0.5),
      '=': () => zoom(0.5),
      '-': () => zoom(-0.5),
      '0': () => map.show_all(),
      Enter: () => map.choose(size.width / 2, size.height / 2),
      ' ': () => map.choose(size.width / 2, size.height / 2),
    };
    const it = does[event.key];
    if (it === undefined) return;
    event.preventDefault();
    it();
  };
  node.addEventListener('keydown', press as EventListener);
}
