// The panels as tabs. A panel is made when it is first looked at, and stays.
import type { Panel } from '../view';
import type { Desk } from './desk';
import { button, element, set_hidden } from '../../look/element';

type Made = (desk: Desk) => HTMLElement;

export class Tabs {
  private readonly tabs: HTMLButtonElement[] = [];
  private readonly boxes: HTMLElement[] = [];

  constructor(
    private readonly desk: Desk,
    bar: HTMLElement,
    private readonly panel: HTMLElement,
    private readonly panels: readonly (readonly [Panel, string, Made])[],
  ) {
    const list = element('div', { class: 'tabs', role: 'tablist', 'aria-label': 'Panels' });
    bar.append(list);
    for (const [panel, title] of panels) {
      const tab = button(title, () => desk.view.set({ panel }), {
        role: 'tab',
        id: `tab-${panel}`,
        'aria-controls': `box-${panel}`,
      });
      const box = element('div', {
        class: 'box',
        role: 'tabpanel',
        id: `box-${panel}`,
        'aria-labelledby': tab.id,
      });
      this.tabs.push(tab);
      this.boxes.push(box);
      list.append(tab);
      this.panel.append(box);
    }
    list.addEventListener('keydown', (event) => this.step(event));
    desk.onChange((changed) => {
      if (changed.has('panel')) this.show();
    });
    this.show();
  }

  private show(): void {
    // Where there is little room the map is shown with the place alone.
    document.body.dataset.panel = this.desk.view.values.panel;
    this.panels.forEach(([panel, title, made], i) => {
      const is_shown = panel === this.desk.view.values.panel;
      const box = this.boxes[i];
      const tab = this.tabs[i];
      if (box === undefined || tab === undefined) return;
      if (is_shown && box.childElementCount === 0) {
        box.append(element('h2', { class: 'unseen' }, title), made(this.desk));
      }
      set_hidden(box, !is_shown);
      tab.setAttribute('aria-selected', String(is_shown));
      tab.tabIndex = is_shown ? 0 : -1;
    });
  }

  private step(event: KeyboardEvent): void {
    const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    const shown = this.panels.findIndex(([panel]) => panel === this.desk.view.values.panel);
    const next = this.panels[(shown + by + this.panels.length) % this.panels.length];
    if (by === 0 || next === undefined) return;
    event.preventDefault();
    this.desk.view.set({ panel: next[0] });
    this.tabs[this.panels.indexOf(next)]?.focus();
  }
}
