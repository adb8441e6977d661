import type { Desk } from '../look/desk';
import { element } from '../look/element';

export function mapPart(_desk: Desk): HTMLElement {
  return element('div');
}
