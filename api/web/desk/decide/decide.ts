// What a coordinator decides by: today and tomorrow, when to begin, the plan, and how far to trust.
import type { Desk } from '../look/desk';
import { choice, element } from '../../look/element';
import { Refused } from '../server/server';
import { time_of_ms } from '../view';
import type { Answer } from './answer';
import type { Decisions, Plan, Report, Score, Sources, Windows } from './answers';
import { Board } from './board';
import { day_name } from './clock';
import { days, is_today } from './days';
import { decisions_list } from './decisions_list';
import { plan_gantt } from './plan_gantt';
import { provenance } from './provenance';
import { Section } from './section';
import { SignOff } from './sign_off';
import { trust_line } from './trust';
import { windows_gantt, type Gantt } from './windows_gantt';
import { yesterday } from './yesterday';

const DAY_MS = 86_400_000;
const LEAST_WAIT_MS = 600_000;
const RETRY_MS = 60_000;
const SCORED_DAYS = 7; // the newest forecasts with truth lie among these

type Shown = 'today' | 'next';

class Decide {
  readonly node = element('div', { class: 'decide-part' });
  private readonly board: Board;
  private readonly now = new Section('Today and the next day', 'days-section');
  private readonly starts = new Section('When each task can begin', 'windows-section');
  private readonly plan = new Section('The plan', 'plan-section');
  private readonly trust = new Section('Trust', 'trust-section');
  private readonly before = new Section('The last forecasts against what came', 'before-section');
  private readonly sign: SignOff;
  private readonly decided = new Section('Hand-over log', 'decisions-section');
  private readonly source = new Section('Where this is from', 'source-section');
  private readonly gantts = new Map<string, Gantt>();
  private shown: Shown = 'today';
  private is_drawn = false;
  private report: Promise<Answer<Report>> | null = null;
  private asked = 0; // reports so far
  private again_ms = Infinity; // when the report is to be asked again
  private round = 0; // of drawing: what comes for an older one is dropped

  constructor(private readonly desk: Desk) {
    this.board = new Board(desk);
    this.sign = new SignOff(desk, () => {
      desk.server.forget();
      this.list_decisions();
    });
    this.node.append(
      this.board.node,
      this.now.node,
      this.trust.node,
      this.starts.node,
      this.plan.node,
      this.sign.node,
      this.decided.node,
      this.before.node,
      this.source.node,
    );
    desk.onChange((changed) => {
      if (changed.has('sites') || changed.has('site')) this.board.show();
      const keys = ['clock', 'speed', 'directions'] as const;
      const is_first = changed.has('sites') && !this.is_drawn;
      const anew = changed.has('site') || changed.has('forecast') || this.is_past();
      if (is_first || anew || keys.some((key) => changed.has(key))) this.redraw(anew);
      if (changed.has('at_ms') || changed.has('sites')) this.mark_hour();
    });
    if (desk.server.sites !== null) this.board.show();
    this.redraw(true);
  }

  /** From time to time anew: its hours of today go on with the clock. */
  private asked_anew(site: string): Promise<Answer<Report>> {
    const { server } = this.desk;
    const from = `/sites/${encodeURIComponent(site)}/report`;
    this.again_ms = Infinity;
    this.asked += 1;
    const mine = this.asked;
    const again = (at_ms: number): void => {
      if (mine === this.asked) this.again_ms = at_ms;
    };
    const coming = server.get<Report>(from).then((body) => {
      again(asked_again_ms(body, server.now_ms()));
      return { from, body };
    });
    // The first section tells it.
    coming.catch(() => again(server.now_ms() + RETRY_MS));
    return coming;
  }

  /** Whether the hours that were left have gone on by a start. */
  private is_past(): boolean {
    return this.desk.server.now_ms() > this.again_ms;
  }

  private get<T>(path: string): Promise<Answer<T>> {
    const { site } = this.desk.view.values;
    const from = `/sites/${encodeURIComponent(site)}${path}`;
    return this.desk.server.get<T>(from).then((body) => ({ from, body }));
  }

  private redraw(anew: boolean): void {
    const { site } = this.desk.view.values;
    const { look, server } = this.desk;
    if (server.sites === null) return;
    this.is_drawn = true;
    if (site === '') {
      this.now.say('There is no site to show yet.');
      return;
    }
    const in_force = server.forecast(site);
    if (anew || this.report === null) this.report = this.asked_anew(site);
    const { report } = this;
    this.round += 1;
    const { round } = this;
    this.gantts.clear();
    const { zone, zone_name } = look;
    const timed = [this.now, this.starts, this.plan, this.sign, this.decided, this.before];
    for (const section of timed) section.say_zone(zone_name);
    void this.now.show(
      report.then((it) =>
        days(it, { zone, zone_name, now_ms: server.now_ms() }, this.why_no_today(it.body)),
      ),
    );
    // Why there is none is said once, above.
    const without = (): HTMLElement =>
      element('p', { class: 'note' }, 'Not known without the report.');
    const of_report = async (
      make: (it: Answer<Report>) => HTMLElement | Promise<HTMLElement>,
    ): Promise<HTMLElement> => {
      const it = await report.catch(() => null);
      return it === null ? without() : make(it);
    };
    void this.trust.show(of_report((it) => trust_line(it, look)));
    void this.starts.show(of_report((it) => this.windows(it, round)));
    void this.plan.show(of_report((it) => this.planned(it, round)));
    void this.show_sign_off(site, report, round);
    this.list_decisions();
    const since = in_force === null ? '' : `?from=${day_before(in_force.day, SCORED_DAYS)}`;
    void this.before.show(
      this.get<Score[]>(`/verification${since}`).then((it) => yesterday(it, look)),
    );
    const sources = this.get<Sources>('/sources').catch((problem: unknown) =>
      problem instanceof Refused ? problem.detail : String(problem),
    );
    void this.source.show(of_report(async (it) => provenance(it, in_force, await sources, look)));
  }

  private async show_sign_off(
    site: string,
    report: Promise<Answer<Report>>,
    round: number,
  ): Promise<void> {
    const it = await report.catch(() => null);
    if (round === this.round) this.sign.show(site, it?.body ?? null);
  }

  private list_decisions(): void {
    const { site } = this.desk.view.values;
    const { look } = this.desk;
    void this.decided.show(
      this.get<Decisions>('/decisions').then((it) => decisions_list(it, site, look)),
    );
  }

  private why_no_today({ to, forecast }: Report): string {
    if (this.desk.server.now_ms() >= Date.parse(to)) {
      return `The forecast was issued on ${day_name(forecast.issued)}: it says nothing of today.`;
    }
    return 'No hours of today are left, or they could not be worked out.';
  }

  /** The Gantt of one day, with the choice of the other. */
  private async windows(report: Answer<Report>, round: number): Promise<HTMLElement> {
    const { today } = report.body;
    const frame = element('div');
    const at = element('div');
    const show = async (which: Shown): Promise<void> => {
      if (round !== this.round) return;
      this.shown = which;
      const is_old = (): boolean => this.shown !== which || round !== this.round;
      tabs.show(which);
      at.replaceChildren(element('p', { class: 'waiting' }, 'Asking the server …'));
      const hours = which === 'today' && today !== null ? `?from=${today.from}&to=${today.to}` : '';
      try {
        const answer = await this.get<Windows>(`/windows${hours}`);
        if (is_old()) return;
        const gantt = windows_gantt(answer, this.desk.look.zone, (at_ms) =>
          this.desk.view.set({ at_ms }),
        );
        this.gantts.set('windows', gantt);
        at.replaceChildren(gantt.node);
        this.mark_hour();
      } catch (problem) {
        if (is_old()) return;
        const why = problem instanceof Refused ? problem.detail : String(problem);
        at.replaceChildren(element('p', { class: 'refused' }, why));
      }
    };
    const tabs = choice<Shown>(
      'Which day',
      [
        ['today', 'Today'],
        ['next', day_name(report.body.day)],
      ],
      (which) => void show(which),
    );
    if (today !== null) frame.append(tabs.node);
    frame.append(at);
    await show(today === null ? 'next' : this.shown);
    return frame;
  }

  /** The plan of the report; where it has none the plan's own answer says why. */
  private async planned(report: Answer<Report>, round: number): Promise<HTMLElement> {
    const { plan, no_plan } = report.body;
    const zone = this.desk.look.zone;
    let gantt: Gantt;
    if (plan !== null) gantt = plan_gantt(report, 'plan.', plan, zone);
    else if (no_plan !== null) return element('p', {}, `There is no plan: ${no_plan}`);
    else {
      try {
        const own = await this.get<Plan>('/plan');
        gantt = plan_gantt(own, '', own.body, zone);
      } catch (problem) {
        if (!(problem instanceof Refused) || problem.status !== 404) throw problem;
        const { site } = this.desk.view.values;
        return element(
          'p',
          {},
          'This site has no plan. Write one as ',
          element('code', {}, `plans/${site}.yaml`),
          ' in the store.',
        );
      }
    }
    if (round === this.round) {
      this.gantts.set('plan', gantt);
      this.mark_hour();
    }
    return gantt.node;
  }

  private mark_hour(): void {
    const at_ms = this.desk.view.values.at_ms ?? this.desk.server.now_ms();
    for (const gantt of this.gantts.values()) gantt.at(at_ms);
  }
}

/** Its hours of today go on by a start; a whole day has starts that pass; else a day begins. */
export function asked_again_ms(report: Report, now_ms: number): number {
  if (report.today !== null) return Math.max(Date.parse(report.today.from), now_ms + LEAST_WAIT_MS);
  if (is_today(report, now_ms)) return now_ms + LEAST_WAIT_MS;
  return (Math.floor(now_ms / DAY_MS) + 1) * DAY_MS;
}

function day_before(day: string, days: number): string {
  return time_of_ms(Date.parse(`${day}T00:00:00Z`) - days * DAY_MS).slice(0, 10);
}

export function decidePart(desk: Desk): HTMLElement {
  return new Decide(desk).node;
}
