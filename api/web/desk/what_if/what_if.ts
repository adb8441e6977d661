// What would be, if a limit, a shift, the order, the hours, turbines or zones were other ones. The
// server works it out and keeps nothing.
import type { Answer } from '../decide/answer';
import type { Plan, Windows } from '../decide/answers';
import { Section } from '../decide/section';
import type { Desk } from '../look/desk';
import { NO_TRIAL } from '../trial';
import { button, element } from '../../look/element';
import { or_token_form } from '../server/token_form';
import { Draft, type Texts } from './draft';
import { fields } from './fields';
import { changed_files, command_lines, save } from './files';
import { limits_of, type Limit } from './limits';
import { on_map, type OnMap } from './on_map';
import { price_of } from './price';
import { result, type WhatIf } from './result';

const WAIT_MS = 300; // for the next key

class WhatIfPanel {
  readonly node = element('div', { class: 'what-if-part' });
  private readonly change = new Section('What if …', 'what-if-change');
  private readonly outcome = new Section('What would be', 'what-if-outcome');
  private readonly price = new Section('The price of a limit', 'what-if-price');
  private readonly files = new Section('Changed files', 'what-if-files');
  private begun = 0;
  private draft: Draft | null = null;
  private original: Draft | null = null;
  private on_map: OnMap | null = null;
  private task = '';
  private priced: { task: string; limit: Limit } | null = null;
  private asking: Draft | null = null; // whose question is under way
  private is_outdated = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly desk: Desk) {
    const nothing = element(
      'p',
      { class: 'unsaved' },
      'Nothing is saved: the server works this out and forgets it. ' +
        'The forecast, the site and the plan stay as they are.',
    );
    this.node.append(
      nothing,
      this.change.node,
      this.outcome.node,
      this.price.node,
      this.files.node,
    );
    desk.onChange((changed) => {
      if (changed.has('site')) this.begin();
      else if (changed.has('forecast') || changed.has('clock')) this.work_out();
      else if (changed.has('depth_m')) this.work_out_price();
      if (changed.has('place')) this.on_map?.show();
    });
    this.begin();
  }

  private path(of: string): string {
    return `/sites/${encodeURIComponent(this.desk.view.values.site)}${of}`;
  }
  private get<T>(of: string): Promise<Answer<T>> {
    const from = this.path(of);
    return this.desk.server.get<T>(from).then((body) => ({ from, body }));
  }

  /** Of another site, or from the true values again. */
  private begin(): void {
    const { site } = this.desk.view.values;
    clearTimeout(this.timer);
    this.draft = null;
    this.on_map = null;
    this.desk.view.try_out(NO_TRIAL);
    this.priced = null;
    if (site === '') {
      this.change.say('There is no site to change yet.');
      return;
    }
    for (const section of [this.outcome, this.price, this.files])
      section.say('Nothing is changed.');
    this.begun += 1;
    void this.change.show(this.form(site, this.begun));
  }

  private async form(site: string, begun: number): Promise<HTMLElement> {
    const [{ body: texts }, { tasks }] = await Promise.all([
      this.get<Texts>('/texts'),
      this.desk.server.site(site),
    ]);
    const draft = new Draft(texts);
    const original = new Draft(texts);
    if (begun !== this.begun) return element('div'); // another site was chosen, or begun anew
    this.draft = draft;
    this.original = original;
    if (texts.tasks[this.task] === undefined) this.task = draft.site_tasks[0] ?? '';
    const names = new Map(tasks.map(({ id, name }) => [id, name]));
    const made = element('div');
    const wait = (): void => {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.work_out(), WAIT_MS);
    };
    const there = on_map(this.desk, draft, () => {
      draw(); // the new one can be asked about
      wait();
    });
    this.on_map = there;
    const draw = (): void =>
      made.replaceChildren(
        fields({
          draft,
          original,
          task: this.task,
          tasks: draft.site_tasks.map((id) => ({ id, name: names.get(id) ?? id })),
          on_map: there.node,
          choose_task: (id) => {
            this.task = id;
            draw();
            made.querySelector('select')?.focus();
          },
          changed: (limit) => {
            if (limit !== undefined) this.priced = { task: this.task, limit };
            wait();
          },
        }),
        button('Back to what is true', () => this.begin()),
      );
    draw();
    return made;
  }

  private work_out(): void {
    const { draft } = this;
    if (draft === null) return;
    if (!draft.is_changed && draft.asked.from === '' && draft.asked.to === '') {
      for (const it of [this.outcome, this.price, this.files]) it.say('Nothing is changed.');
      return;
    }
    void this.ask_latest(draft);
    this.work_out_price();
    void this.files.show(Promise.resolve(this.saved(draft)));
  }

  private work_out_price(): void {
    if (this.priced === null) return;
    void this.price.show(this.priced_at(this.priced.task, this.priced.limit));
  }

  /** One question at a time; of what is changed meanwhile the last is asked next. */
  private async ask_latest(draft: Draft): Promise<void> {
    this.is_outdated = this.asking === draft;
    if (this.is_outdated) {
      this.outcome.wait();
      return;
    }
    this.asking = draft;
    const again = (): void => this.work_out();
    await this.outcome.show(this.ask(draft).catch(or_token_form(this.desk.server, again)));
    if (this.asking !== draft) return;
    this.asking = null;
    if (this.is_outdated) this.work_out();
  }

  private async ask(draft: Draft): Promise<HTMLElement> {
    const { desk } = this;
    const { hours, touched } = draft;
    const from = this.path('/what-if');
    const asked = { texts: draft.changed, query: draft.query() };
    const [truth, plan, body] = await Promise.all([
      this.get<Windows>(`/windows${hours === '' ? '' : `?${hours}`}`),
      this.get<Plan>('/plan').catch(() => null),
      desk.server.post<WhatIf>(from, asked),
    ]);
    const show_hour = (at_ms: number): void => desk.view.set({ at_ms });
    return result(truth, plan, { from, body }, touched, desk.look, show_hour);
  }

  private async priced_at(task: string, limit: Limit): Promise<HTMLElement> {
    const before = limits_of(this.original?.task(task) ?? '').find(
      (it) => it.path.join('.') === limit.path.join('.'),
    );
    const windows = await this.get<Windows>('/windows');
    const of = windows.body.tasks.find((it) => it.task === task);
    return price_of((path) => this.get(path), {
      site: this.desk.view.values.site,
      limit,
      was: before?.value ?? limit.value,
      shown_depth_m: this.desk.view.values.depth_m,
      duration_h: of?.duration_h ?? 1,
      contingency_h: of?.contingency_h ?? 0,
    });
  }

  private saved(draft: Draft): HTMLElement {
    const { site } = this.desk.view.values;
    const made = changed_files(site, draft.changed);
    const lines = command_lines(site, draft.site_tasks, draft.changed, draft.asked);
    return element(
      'div',
      {},
      made.length === 0
        ? element('p', {}, 'No file is changed: hours and turbine are options of the command.')
        : element(
            'p',
            {},
            'These are files as the command line takes them. Your comments stay in them.',
          ),
      element(
        'p',
        { class: 'buttons' },
        ...made.map((file) => button(`Download ${file.name}`, () => save(file))),
      ),
      ...lines.map((line) => element('p', {}, element('code', {}, line))),
    );
  }
}

export function whatIfPart(desk: Desk): HTMLElement {
  return new WhatIfPanel(desk).node;
}
