// What the person must hear of: refusals, changes of a helm, the link. One line, read out politely.
import { by_id, set_text } from '../../look/element';

export type Tone = 'plain' | 'alarm';

export function notice(text: string, tone: Tone = 'plain'): void {
  const line = by_id('notice');
  line.dataset.tone = tone;
  // The same words twice are two events: a changed node is what a screen reader speaks.
  set_text(line, line.textContent === text ? `${text}\u00a0` : text);
}
