// Keys: W/S surge, A/D yaw, Q/E sway, R/F heave; Space is the dead-man. They count where no field
// or button wants them: with the page itself, the plan, or a thruster's slider in hand.
import type { Lean } from './stick';

const DRIVING_CODES: readonly string[] = [
  'KeyW',
  'KeyS',
  'KeyA',
  'KeyD',
  'KeyQ',
  'KeyE',
  'KeyR',
  'KeyF',
];

export class Keys {
  private down = new Set<string>();

  /** True: the key was for driving, and nobody else shall have it. */
  press(code: string, is_repeat: boolean): boolean {
    if (code !== 'Space' && !DRIVING_CODES.includes(code)) return false;
    // A repeat tells of a key that went down before we looked: after a loss of focus it does not
    // count.
    if (!is_repeat) this.down.add(code);
    return true;
  }

  release(code: string): void {
    this.down.delete(code);
  }

  /** The page lost the focus: what is let go meanwhile is not told. */
  release_all(): void {
    this.down.clear();
  }

  get is_held(): boolean {
    return this.down.has('Space');
  }

  lean(): Lean {
    const axis = (more: string, less: string): number =>
      (this.down.has(more) ? 1 : 0) - (this.down.has(less) ? 1 : 0);
    return {
      surge: axis('KeyW', 'KeyS'),
      yaw: axis('KeyD', 'KeyA'),
      sway: axis('KeyE', 'KeyQ'),
      heave: axis('KeyF', 'KeyR'),
    };
  }
}

/** Whether the element with the focus leaves the keys to the vehicle. */
export function leaves_keys_alone(focused: Element | null): boolean {
  if (focused === null || focused === document.body || focused instanceof HTMLCanvasElement)
    return true;
  if (focused instanceof HTMLInputElement) return focused.type === 'range';
  return focused.hasAttribute('data-drives');
}

export function listen_to_keys(keys: Keys): void {
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (document.querySelector('dialog[open]') !== null) return;
    if (leaves_keys_alone(document.activeElement) && keys.press(event.code, event.repeat))
      event.preventDefault();
  });
  addEventListener('keyup', (event) => keys.release(event.code));
  addEventListener('blur', () => keys.release_all());
  document.addEventListener('visibilitychange', () => keys.release_all());
  // The focus goes into a field or onto a button: the hand is off the stick.
  document.addEventListener('focusin', () => {
    if (!leaves_keys_alone(document.activeElement)) keys.release_all();
  });
}
