import type { Desk } from '../look/desk';
import { element } from '../look/element';

export function placePart(_desk: Desk): HTMLElement {
  return element('div');
}
