// A round stick for a finger, a pen or a mouse. The finger on it is the dead-man.
import { element } from '../../look/element';

export interface TouchStick {
  readonly box: HTMLElement;
  readonly is_held: () => boolean;
  /** Right and up, each from -1 to 1. */
  readonly lean: () => { right: number; up: number };
  readonly let_go: () => void;
}

export function touch_stick(name: string, across: string, along: string): TouchStick {
  const knob = element('span', { class: 'knob', 'aria-hidden': 'true' });
  const ring = element('div', { class: 'ring', 'aria-hidden': 'true' }, knob);
  const box = element(
    'div',
    { class: 'touch-stick', role: 'group', 'aria-label': `${name}: ${along}, ${across}` },
    ring,
    element('p', { class: 'note' }, `${along} · ${across}`),
  );
  let pointer: number | null = null;
  let right = 0;
  let up = 0;

  const draw = (): void => {
    knob.style.transform = `translate(${right * 38}px, ${-up * 38}px)`;
    ring.classList.toggle('held', pointer !== null);
  };
  const move = (event: PointerEvent): void => {
    const rect = ring.getBoundingClientRect();
    const half = rect.width / 2;
    right = (event.clientX - rect.left - half) / half;
    up = -(event.clientY - rect.top - half) / half;
    const size = Math.hypot(right, up);
    if (size > 1) {
      right /= size;
      up /= size;
    }
    if (Math.abs(right) < 0.1) right = 0;
    if (Math.abs(up) < 0.1) up = 0;
    draw();
  };
  const let_go = (): void => {
    pointer = null;
    right = 0;
    up = 0;
    draw();
  };
  ring.addEventListener('pointerdown', (event) => {
    if (pointer !== null || event.button !== 0) return;
    event.preventDefault();
    pointer = event.pointerId;
    ring.setPointerCapture(event.pointerId);
    move(event);
  });
  ring.addEventListener('pointermove', (event) => {
    if (event.pointerId === pointer) move(event);
  });
  for (const over of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
    ring.addEventListener(over, (event) => {
      if (event.pointerId === pointer) let_go();
    });
  }
  return { box, is_held: () => pointer !== null, lean: () => ({ right, up }), let_go };
}
