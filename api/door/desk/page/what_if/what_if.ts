import type { Desk } from '../look/desk';
import { element } from '../look/element';

export function whatIfPart(_desk: Desk): HTMLElement {
  return element('div');
}
