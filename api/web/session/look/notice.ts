// What the person must hear of: refusals, changes of a helm, the link. One line, read out politely.
import { by_id, set_text } from '../../look/element';
import { NOTHING_SAID, type Said } from './said';

export type Tone = 'plain' | 'alarm';

let last: Said = NOTHING_SAID;

export function notice(text: string, tone: Tone = 'plain'): void {
  last = { text, is_alarm: tone === 'alarm' };
  const line = by_id('notice');
  line.dataset.tone = tone;
  // The same words twice are two events: a changed node is what a screen reader speaks.
  set_text(line, line.textContent === text ? `${text}\u00a0` : text);
}

export const last_notice = (): Said => last;
