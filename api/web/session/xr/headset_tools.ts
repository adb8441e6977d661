// The buttons that lead into the scene with a headset. They are there only where the browser says
// that it can.
import { button, element, set_hidden, set_text } from '../../look/element';
import type { SceneView } from '../scene/scene_view';
import type { Headset } from './headset';
import { MODES, modes_there, type Mode } from './modes';

const TEXT: Readonly<Record<Mode, string>> = { vr: 'Enter VR', ar: 'Table (AR)' };

export interface HeadsetTools {
  readonly nodes: HTMLElement[];
  show(): void;
}

export function headset_tools(headset: Headset, view: () => SceneView | null): HeadsetTools {
  let there: ReadonlySet<Mode> = new Set();
  const buttons = MODES.map((mode) => {
    const made = button(TEXT[mode], () => {
      const in_it = view();
      if (in_it !== null) void headset.enter(mode, in_it);
    });
    return { mode, made };
  });
  const leave = button('Leave the headset', () => headset.leave());
  const words = element('p', { class: 'note', role: 'status' });
  const show = (): void => {
    const is_worn = headset.is_worn();
    for (const { mode, made } of buttons) set_hidden(made, is_worn || !there.has(mode));
    set_hidden(leave, !is_worn);
    set_text(words, headset.words());
    set_hidden(words, words.textContent === '');
  };
  const look = async (): Promise<void> => {
    there = await modes_there(navigator.xr);
    show();
  };
  navigator.xr?.addEventListener('devicechange', () => void look());
  void look();
  show();
  return { nodes: [...buttons.map((it) => it.made), leave, words], show };
}
