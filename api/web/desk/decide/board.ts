// The board: every site in one list, the worst first.
import type { Desk } from '../look/desk';
import { button, element, scroll_region, set_hidden, set_text } from '../../look/element';
import { is_known, span_text } from '../look/units';
import type { SiteInSites } from '../server/answers';
import { Refused } from '../server/server';
import type { Answer } from './answer';
import type { Report } from './answers';
import { STATUS_TEXT, counts_text, worst_first, type BoardReport } from './board_order';
import { OneByOne } from './one_by_one';
import { verdict_badge } from './verdict_badge';

const MANY_SITES = 12;
const LOOK_AGAIN_MS = 600_000; // a verdict is of the hours that are left
const TRY_AGAIN_MS = 60_000;
const HEADS = ['Site', 'Today', 'Next day', 'Forecast'];

interface Row {
  site: SiteInSites;
  report: BoardReport;
  answer: Answer<Report> | null;
  asked_ms: number; // -Infinity: it is to be asked for
  node: HTMLTableSectionElement;
}

export class Board {
  readonly node = element('section', { class: 'board' });
  private readonly rows = new Map<string, Row>();
  private readonly table = element('table');
  private readonly details = element('details');
  private readonly counts = element('span', { class: 'counts' });
  private readonly search = element('input', { type: 'search', 'aria-label': 'Find a site' });
  private readonly reports: OneByOne<string>;

  constructor(private readonly desk: Desk) {
    this.reports = new OneByOne((id) => this.ask(id));
    const heads = HEADS.map((head) => element('th', { scope: 'col' }, head));
    this.table.append(element('thead', {}, element('tr', {}, ...heads)));
    this.search.placeholder = 'Find a site';
    this.search.addEventListener('input', () => this.filter());
    // Closed it costs nothing: reports are asked for once somebody looks.
    const summary = element('summary', {}, 'All sites: ', this.counts);
    const list = scroll_region('All sites', this.table);
    this.details.append(summary, this.search, list);
    this.details.addEventListener('toggle', () => this.want());
    this.node.append(this.details);
    // Rows do not move under a pointer or a focus; they are put in order once it has left.
    for (const left of ['pointerleave', 'focusout']) {
      this.node.addEventListener(left, () => this.order());
    }
  }

  /** The sites as they are now; what a report says of an older forecast goes. */
  show(): void {
    const sites = this.desk.server.sites?.sites ?? [];
    const gone = new Set(this.rows.keys());
    for (const site of sites) {
      gone.delete(site.id);
      const row = this.rows.get(site.id) ?? this.new_row(site);
      const is_same = row.site.forecast?.instance === site.forecast?.instance;
      row.site = site;
      if (!is_same) this.set_report(row, { is: 'waiting' }, null, -Infinity);
      this.draw(row);
    }
    for (const id of gone) {
      this.rows.get(id)?.node.remove();
      this.rows.delete(id);
    }
    set_text(this.counts, counts_text(sites));
    set_hidden(this.search, sites.length < MANY_SITES);
    this.order();
    this.filter();
    this.want();
  }

  private set_report(
    row: Row,
    report: BoardReport,
    answer: Answer<Report> | null,
    asked_ms = row.asked_ms,
  ): void {
    Object.assign(row, { report, answer, asked_ms });
  }

  private is_due({ site, report, asked_ms }: Row): boolean {
    const wait_ms = report.is === 'refused' ? TRY_AGAIN_MS : LOOK_AGAIN_MS;
    return site.report !== null && Date.now() - asked_ms > wait_ms;
  }

  /** Asks for the reports that nobody has asked for lately, the worst sites first. */
  private want(): void {
    if (!this.details.open) return;
    const all = worst_first([...this.rows.values()]);
    this.reports.add(all.filter((it) => this.is_due(it)).map(({ site }) => site.id));
  }

  private new_row(site: SiteInSites): Row {
    const node = element('tbody');
    const row: Row = { site, report: { is: 'waiting' }, answer: null, asked_ms: -Infinity, node };
    this.rows.set(site.id, row);
    return row;
  }

  private async ask(id: string): Promise<void> {
    const row = this.rows.get(id);
    const from = row?.site.report ?? null;
    if (row === undefined || from === null) return;
    const instance = row.site.forecast?.instance;
    const is_old = (): boolean =>
      this.rows.get(id) !== row || row.site.forecast?.instance !== instance;
    row.asked_ms = Date.now();
    try {
      const body = await this.desk.server.get<Report>(from);
      if (is_old()) return; // it is asked for again
      const today = body.today?.verdict ?? null;
      const report = { is: 'there', today, next: body.verdict, headline: body.headline } as const;
      this.set_report(row, report, { from, body });
    } catch (problem) {
      if (is_old()) return;
      const why = problem instanceof Refused ? problem.detail : 'The report could not be read.';
      this.set_report(row, { is: 'refused', why }, null);
    }
    this.draw(row);
    this.order();
  }

  private draw({ site, report, answer, node }: Row): void {
    const { view } = this.desk;
    const is_shown = view.values.site === site.id;
    const focused = node.contains(document.activeElement);
    const open = button(site.name, () =>
      view.set({ site: site.id, place: null, map: null, at_ms: null }),
    );
    open.setAttribute('aria-pressed', String(is_shown));
    const verdict = (key: string): Node | string => {
      if (answer === null || report.is !== 'there')
        return report.is === 'waiting' && site.report !== null ? '…' : '–';
      const said = key === 'verdict' ? report.next : report.today;
      return said === null ? 'none left' : verdict_badge(answer, key, said);
    };
    const age = site.forecast?.age_s;
    const words = [
      ...(site.status === 'ok' ? [] : [element('p', {}, site.in_words)]),
      ...(report.is === 'refused' ? [element('p', { class: 'refused' }, report.why)] : []),
      ...(report.is === 'there' ? [element('p', { class: 'headline' }, report.headline)] : []),
    ];
    node.replaceChildren(
      element(
        'tr',
        {},
        element('th', { scope: 'row' }, open),
        element('td', {}, verdict('today.verdict')),
        element('td', {}, verdict('verdict')),
        element(
          'td',
          { class: 'age' },
          element(
            'span',
            { class: 'status', 'data-status': site.status },
            STATUS_TEXT[site.status],
          ),
          is_known(age) ? ` ${span_text(age)} old` : '',
        ),
      ),
    );
    if (words.length > 0) {
      const cell = element('td', { colspan: HEADS.length }, ...words);
      node.append(element('tr', {}, cell));
    }
    if (focused) open.focus();
  }

  private order(): void {
    if (this.node.matches(':hover') || this.node.contains(document.activeElement)) return;
    worst_first([...this.rows.values()]).forEach(({ node }, i) => {
      // The head of the table stands first.
      const there = this.table.children[i + 1] ?? null;
      if (there !== node) this.table.insertBefore(node, there);
    });
  }

  private filter(): void {
    const wanted = this.search.value.trim().toLowerCase();
    for (const { site, node } of this.rows.values()) {
      set_hidden(node, !`${site.name} ${site.id}`.toLowerCase().includes(wanted));
    }
  }
}
