// Parts of the page that scroll by themselves; the keys of the stick go on driving there.
import { scroll_region } from '../../look/element';

export function driving_region(name: string, inside: Node): HTMLElement {
  const made = scroll_region(name, inside);
  made.setAttribute('data-drives', '');
  return made;
}
