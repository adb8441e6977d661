// A part of the page that waits for one answer: what it shows meanwhile, and when none comes.
import { element, set_text } from '../../look/element';
import { Refused } from '../server/server';

export function refusal_text(problem: unknown): string {
  return problem instanceof Refused ? problem.detail : `The page could not show this: ${problem}`;
}

/** A heading and what belongs under it; only the answer asked for last is shown. */
export class Section {
  readonly node: HTMLElement;
  readonly body = element('div', { class: 'section-body' });
  private readonly zone = element('span', { class: 'zone' });
  private asked = 0;

  constructor(title: string, name: string) {
    const head = element('h2', { id: `decide-${name}` }, title, this.zone);
    this.node = element('section', { class: name, 'aria-labelledby': head.id }, head, this.body);
  }

  /** Once in the head: whose hours all that stands under it are. */
  say_zone(zone_name: string): void {
    set_text(this.zone, `, ${zone_name}`);
  }

  async show(coming: Promise<HTMLElement>): Promise<void> {
    this.asked += 1;
    const mine = this.asked;
    this.wait();
    let made: HTMLElement;
    try {
      made = await coming;
    } catch (problem) {
      made = element('p', { class: 'refused' }, refusal_text(problem));
    }
    if (mine !== this.asked) return;
    this.body.replaceChildren(made);
    this.body.removeAttribute('aria-busy');
  }

  /** What was there stays to be read; a mere note gives way. */
  wait(): void {
    this.body.setAttribute('aria-busy', 'true');
    if (this.body.firstElementChild?.matches('.waiting')) return;
    const waiting = element('p', { class: 'waiting' }, 'Asking the server …');
    const first = this.body.firstElementChild;
    if (first === null || first.matches('.note')) this.body.replaceChildren(waiting);
    else this.body.prepend(waiting);
  }

  /** In place of all that was asked for: an answer that still comes is too late. */
  say(text: string, kind = 'note'): void {
    this.asked += 1;
    this.body.removeAttribute('aria-busy');
    this.body.replaceChildren(element('p', { class: kind }, text));
  }
}
