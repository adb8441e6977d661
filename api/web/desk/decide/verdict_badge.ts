// A verdict as a badge: its word, and a shape that reads in grey.
import { element } from '../../look/element';
import { told_by, type Answer } from './answer';
import type { Verdict } from './answers';
import { VERDICT } from './words';

export function verdict_badge(answer: Answer<unknown>, key: string, verdict: Verdict): HTMLElement {
  const said = { class: 'verdict', 'data-verdict': verdict, ...told_by(answer, key) };
  return element('span', said, VERDICT[verdict] ?? verdict);
}
