import type { Desk } from '../look/desk';
import { element } from '../look/element';

export function timePart(_desk: Desk): HTMLElement {
  return element('div');
}
