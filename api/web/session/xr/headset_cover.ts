// What the desk has in place of the scene while somebody wears it: that they do, and what their
// board says, for who stands beside them.
import { element, set_hidden, set_text } from '../../look/element';
import type { Headset } from './headset';

export interface HeadsetCover {
  readonly node: HTMLElement;
  show(): void;
}

export function headset_cover(headset: Headset): HeadsetCover {
  const lines = element('ul', {});
  const buttons = element('ul', { class: 'on-board' });
  const node = element(
    'div',
    { class: 'scene-cover', hidden: true },
    element('p', {}, 'The scene is in the headset.'),
    element('p', {}, 'Its board says:'),
    lines,
    element('p', {}, 'On it can be pressed, in there:'),
    buttons,
  );
  const list = (into: HTMLElement, texts: readonly string[]): void => {
    while (into.children.length > texts.length) into.lastChild?.remove();
    while (into.children.length < texts.length) into.append(element('li', {}));
    texts.forEach((text, nth) => set_text(into.children[nth] as HTMLElement, text));
  };

  return {
    node,
    show: () => {
      set_hidden(node, !headset.is_worn());
      if (!headset.is_worn()) return;
      const board = headset.on_board();
      list(lines, board.lines);
      list(
        buttons,
        board.buttons.map((it) => it.text),
      );
      board.buttons.forEach(({ at }, nth) => {
        const place = at.toArray().map((it_m) => it_m.toFixed(3));
        (buttons.children[nth] as HTMLElement).dataset.atM = place.join(' ');
      });
    },
  };
}
