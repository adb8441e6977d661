// A bar: how much of a limit is used. The words say the same as the length.
import { element, set_text } from '../../look/element';

export interface Bar {
  readonly box: HTMLElement;
  set(share: number, text: string, is_alarm: boolean): void;
}

export function bar(name: string): Bar {
  const fill = element('span', { class: 'fill' });
  const words = element('span', { class: 'value' });
  const box = element(
    'div',
    { class: 'bar' },
    element('span', { class: 'name' }, name),
    words,
    element('span', { class: 'groove', 'aria-hidden': 'true' }, fill),
  );
  return {
    box,
    set: (share, text, is_alarm) => {
      const percent = `${Math.round(Math.max(0, Math.min(1, share)) * 100)}%`;
      if (fill.style.width !== percent) fill.style.width = percent;
      box.classList.toggle('alarm', is_alarm);
      set_text(words, text);
    },
  };
}
