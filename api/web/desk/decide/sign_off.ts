// The sign-off: who decides what about which start; read once more, then filed for good.
import type { Desk } from '../look/desk';
import { button, choice, element, labelled, set_hidden, set_text } from '../../look/element';
import { Refused, type Server } from '../server/server';
import { or_token_form } from '../server/token_form';
import type { Decision, Decisions, Report, Start, Windows, WindowsTask } from './answers';
import { day_name } from './clock';
import { refusal_text } from './section';
import { counting, signed, type Signed, type Wish } from './sign_draft';
import { best_start } from './windows_row';
import { VERDICT, chance_text } from './words';

type Day = 'today' | 'next';
type Choice = 'go' | 'no_go' | '';
interface Row {
  start: string;
  decided: Choice;
  why: string;
}

const DECIDED = { go: 'Go', no_go: 'No-go' };

/** The one call that writes. */
function file(server: Server, site: string, body: Signed): Promise<Decision> {
  return server.post<Decision>(`/sites/${encodeURIComponent(site)}/decisions`, body);
}

export class SignOff {
  readonly node: HTMLElement;
  private readonly zone = element('span', { class: 'zone' });
  private readonly days = element('div');
  private readonly list = element('div', { class: 'sign-rows' });
  private readonly who = element('input', { type: 'text', maxlength: 200, autocomplete: 'off' });
  private readonly hand_over = element('textarea', { rows: 2, maxlength: 1500 });
  private readonly form: HTMLElement;
  private readonly asks = element('div', { class: 'sign-asks', tabindex: -1 });
  private readonly says = element('div', { class: 'sign-says', role: 'status', tabindex: -1 });
  private site = '';
  private report: Report | null = null;
  private day: Day = 'today';
  private rows = new Map<string, Row>(); // by day, task and turbine
  private tasks: WindowsTask[] = [];
  private asked = 0;

  constructor(
    private readonly desk: Desk,
    private readonly filed: () => void,
  ) {
    const head = element('h2', { id: 'decide-sign-section' }, 'Sign off', this.zone);
    this.form = element(
      'div',
      { class: 'sign-form' },
      this.days,
      this.list,
      element(
        'div',
        { class: 'sign-who' },
        labelled('Who decides', this.who),
        labelled('For the next shift', this.hand_over, 'Kept with each decision.'),
      ),
      button('Check, then sign …', () => void this.check()),
    );
    this.node = element(
      'section',
      { class: 'sign-section', 'aria-labelledby': head.id },
      head,
      this.form,
      this.asks,
      this.says,
    );
  }

  /** Whose hours the starts are. */
  say_zone(zone_name: string): void {
    set_text(this.zone, `, ${zone_name}`);
  }

  /** @param report  what is looked at; null: nothing is known, and nothing can be decided */
  show(site: string, report: Report | null): void {
    const is_other = site !== this.site;
    if (is_other) {
      this.rows.clear();
      this.hand_over.value = '';
      this.asks.replaceChildren();
      this.says.replaceChildren();
      this.report = null;
    }
    this.site = site;
    if (report === null) {
      // What was written stays for when the report is back.
      this.form.hidden = true;
      this.say('Without the report nothing can be signed here.', 'note');
      return;
    }
    const before = this.report?.forecast.sha256;
    const is_new = before !== undefined && report.forecast.sha256 !== before;
    const is_shown = !this.form.hidden || this.asks.childElementCount > 0;
    if (!is_shown) this.says.replaceChildren();
    if (is_new) {
      const is_lost = [...this.rows.values()].some(({ decided }) => decided !== '');
      this.rows.clear();
      this.asks.replaceChildren();
      if (is_lost) this.say('A new forecast came. Look at it, then decide anew.', 'refused');
    }
    this.report = report;
    const is_written = !is_other && !is_new && this.node.contains(document.activeElement);
    if (is_written && is_shown) return; // nobody's words are taken from under the hands
    this.form.hidden = this.asks.childElementCount > 0;
    const { today, day } = report;
    if (today === null) this.day = 'next';
    const tabs = choice<Day>(
      'Which day',
      [
        ['today', 'Today'],
        ['next', day_name(day)],
      ],
      (which) => {
        this.day = which;
        tabs.show(which);
        void this.ask();
      },
    );
    tabs.show(this.day);
    this.days.replaceChildren(...(today === null ? [] : [tabs.node]));
    void this.ask();
  }

  private path(of: string): string {
    return `/sites/${encodeURIComponent(this.site)}${of}`;
  }
  private say(text: string, kind: string): void {
    this.says.replaceChildren(element('p', { class: kind }, text));
  }

  /** The starts of the day, as the Gantt above has them. */
  private async ask(): Promise<void> {
    const { report, day } = this;
    if (report === null) return;
    this.asked += 1;
    const mine = this.asked;
    const { today } = report;
    const hours = day === 'today' && today !== null ? `?from=${today.from}&to=${today.to}` : '';
    try {
      const { tasks } = await this.desk.server.get<Windows>(this.path(`/windows${hours}`));
      if (mine !== this.asked) return;
      this.tasks = tasks;
      this.list.replaceChildren(...tasks.map((task) => this.row(task)));
      if (tasks.length === 0) this.list.append(element('p', {}, 'There is no task to decide on.'));
    } catch (problem) {
      if (mine !== this.asked) return;
      this.tasks = [];
      this.list.replaceChildren(element('p', { class: 'refused' }, refusal_text(problem)));
    }
  }

  private key(task: WindowsTask): string {
    return [this.day, task.task, ...task.turbines].join(' ');
  }
  private kept(task: WindowsTask): Row {
    const key = this.key(task);
    const best = task.starts[best_start(task)] ?? task.starts[0];
    const made = this.rows.get(key) ?? { start: best?.start ?? '', decided: '', why: '' };
    if (!task.starts.some(({ start }) => start === made.start)) made.start = best?.start ?? '';
    this.rows.set(key, made);
    return made;
  }

  private row(task: WindowsTask): HTMLElement {
    const kept = this.kept(task);
    const title = element('legend', {}, name_of(task));
    if (task.starts.length === 0) {
      return element('fieldset', {}, title, element('p', {}, 'No start is left on this day.'));
    }
    const starts = element(
      'select',
      {},
      ...task.starts.map((it) =>
        element('option', { value: it.start, selected: it.start === kept.start }, this.words(it)),
      ),
    );
    starts.addEventListener('change', () => (kept.start = starts.value));
    const why = element('input', { type: 'text', maxlength: 400, value: kept.why });
    why.addEventListener('input', () => (kept.why = why.value));
    const fields = element(
      'div',
      { class: 'sign-fields', hidden: kept.decided === '' },
      labelled('Start', starts),
      labelled('Why', why),
    );
    const group = `sign ${task.task} ${task.turbines.join(' ')}`;
    const radio = (value: Choice, text: string): HTMLElement => {
      const checked = kept.decided === value;
      const box = element('input', { type: 'radio', name: group, value, checked });
      box.addEventListener('change', () => {
        kept.decided = value;
        set_hidden(fields, value === '');
      });
      return element('label', { class: 'check' }, box, text);
    };
    return element(
      'fieldset',
      {},
      title,
      element(
        'div',
        { class: 'sign-choice' },
        radio('', 'Not decided'),
        radio('go', 'Go'),
        radio('no_go', 'No-go'),
      ),
      fields,
    );
  }

  private words(start: Start): string {
    return `${this.desk.look.hour(Date.parse(start.start))}, ${said_of(start)}`;
  }

  private wishes(): Wish[] {
    return this.tasks.flatMap((task) => {
      const { start, decided, why } = this.kept(task);
      if (decided === '' || start === '') return [];
      const turbine = task.turbines[0] ?? null;
      const at = task.starts.find((it) => it.start === start);
      const said = at === undefined ? '' : said_of(at);
      const name = name_of(task);
      return [{ key: this.key(task), task: task.task, name, turbine, start, decided, why, said }];
    });
  }

  /** All that will be signed, to be read once more. */
  private async check(): Promise<void> {
    const { report, desk } = this;
    const wishes = this.wishes();
    if (report === null) return;
    if (wishes.length === 0) {
      this.say('Nothing is decided yet: choose Go or No-go for a task.', 'refused');
      return;
    }
    if (this.who.value.trim() === '') {
      this.say('Nobody signs yet: write who decides.', 'refused');
      this.who.focus();
      return;
    }
    let decisions: Decision[];
    try {
      decisions = (await desk.server.get<Decisions>(this.path('/decisions'))).decisions;
    } catch (problem) {
      this.say(refusal_text(problem), 'refused');
      return;
    }
    const { sha256, issued } = report.forecast;
    const bodies = wishes.map((wish) =>
      signed(wish, this.who.value, this.hand_over.value, sha256, decisions),
    );
    const lines = wishes.map((wish, i) => {
      const before = counting(decisions, wish);
      const line = element(
        'li',
        {},
        element('b', {}, DECIDED[wish.decided]),
        ` for ${this.of(wish)}. The program says: ${wish.said}`,
      );
      const { note = '', hand_over = '' } = bodies[i] ?? {};
      if (note !== '') line.append(`. Note: ${note}`);
      if (hand_over !== '') line.append(`. For the next shift: ${hand_over}`);
      if (before !== undefined) {
        const when = desk.look.time(Date.parse(before.recorded_at));
        line.append(
          element(
            'p',
            { class: 'note' },
            `In place of ${DECIDED[before.decided]} by ${before.by}, ${when}, which is kept.`,
          ),
        );
      }
      return line;
    });
    const sign = button(`Sign as ${this.who.value.trim()}`, () => void this.sign(wishes, bodies));
    this.says.replaceChildren();
    this.form.hidden = true;
    this.asks.replaceChildren(
      element('h3', {}, 'This will be signed'),
      element('ul', {}, ...lines),
      element(
        'p',
        {},
        `On the forecast issued ${desk.look.time(Date.parse(issued))}. ` +
          'A record is kept for good. To change a decision, sign again.',
      ),
      element('p', { class: 'sign-buttons' }, sign, ' ', this.back()),
    );
    this.asks.focus(); // not the button: nobody signs by pressing Enter twice
  }

  private back(): HTMLElement {
    return button('Back', () => {
      this.asks.replaceChildren();
      this.form.hidden = false;
      this.who.focus();
    });
  }

  private of({ name, start }: Wish): string {
    return `${name}, start ${this.desk.look.time(Date.parse(start))}`;
  }

  /** @param lines  what was said of those that were signed before */
  private async sign(wishes: Wish[], bodies: Signed[], lines: HTMLElement[] = []): Promise<void> {
    const { site } = this;
    this.asks.replaceChildren(element('p', { class: 'waiting' }, 'Signing …'));
    let is_gone = false;
    for (const [i, body] of bodies.entries()) {
      const of = this.of(wishes[i] as Wish);
      if (is_gone) {
        lines.push(element('p', { class: 'refused' }, `${of}: not sent.`));
        continue;
      }
      try {
        const { id, decided, said } = await file(this.desk.server, site, body);
        this.rows.delete(wishes[i]?.key ?? '');
        const verdict = said.verdict === null ? 'nothing' : VERDICT[said.verdict];
        const chance = said.probability === null ? '' : `, ${chance_text(said.probability)}`;
        lines.push(
          element(
            'p',
            { class: 'done' },
            `Recorded as number ${id}: ${DECIDED[decided]} for ${of}. ` +
              `The program says: ${verdict}${chance}.`,
          ),
        );
      } catch (problem) {
        if (!(problem instanceof Refused)) throw problem;
        if (problem.status === 401 && site === this.site) {
          // From afar: the same once more, from here on, with the token.
          const again = (): void => void this.sign(wishes.slice(i), bodies.slice(i), lines);
          const form = or_token_form(this.desk.server, again)(problem);
          this.asks.replaceChildren(form, element('p', {}, this.back()));
          this.says.replaceChildren(...lines);
          return;
        }
        is_gone = problem.status === 0;
        const after = is_gone ? ' Look into the log below before you sign it again.' : '';
        lines.push(
          element('p', { class: 'refused' }, `Not recorded: ${of}. ${problem.detail}${after}`),
        );
      }
    }
    if (site !== this.site) return;
    this.asks.replaceChildren();
    this.says.replaceChildren(...lines);
    if (lines.every((line) => line.className === 'done')) {
      this.hand_over.value = '';
      this.who.value = ''; // the next who signs may be another
    }
    this.form.hidden = false;
    this.says.focus();
    this.filed();
    void this.ask();
  }
}

function said_of({ forbidden, probability }: Start): string {
  return forbidden !== null ? 'closed' : chance_text(probability);
}

function name_of({ name, turbines }: WindowsTask): string {
  return turbines.length === 0 ? name : `${name} at ${turbines.join(', ')}`;
}
