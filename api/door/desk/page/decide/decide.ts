import type { Desk } from '../look/desk';
import { element } from '../look/element';

export function decidePart(_desk: Desk): HTMLElement {
  return element('div');
}
