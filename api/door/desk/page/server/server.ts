// All that is asked of the server. It is the only source of a number; here it is kept, not changed.
import {
  whole_site,
  type ForecastInForce,
  type Problem,
  type SiteMap,
  type Sites,
} from './answers';
import { Asked, type Ask } from './asked';
import { read_coverages, type Column } from './coverage';

const LOOK_AGAIN_MS = 30_000;
const TRY_AGAIN_MS = 3_000;

/** What a part shows in place of a value that did not come: `detail` as the server says it. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly detail: string,
  ) {
    super(detail);
  }
}

export type Link = { is: 'there' } | { is: 'gone'; since_ms: number };
type Told = 'sites' | 'forecast' | 'server';

export class Server {
  link: Link = { is: 'there' };
  /** null before the first answer. */
  sites: Sites | null = null;
  private readonly asked: Asked;
  private server_ahead_ms = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly ask: Ask,
    private readonly tell: (what: Told) => void,
  ) {
    this.asked = new Asked((path) => this.fetch_json(path));
  }

  /** The server's clock, which may run in another year than the browser's. */
  now_ms(): number {
    return Date.now() + this.server_ahead_ms;
  }
  forecast(site: string): ForecastInForce | null {
    return this.sites?.sites.find(({ id }) => id === site)?.forecast ?? null;
  }

  /** Looks at /sites now and then: a new forecast, or a server that went or is back, is told. */
  async watch(): Promise<void> {
    clearTimeout(this.timer);
    try {
      const before = this.sites;
      const sites = await this.fetch_json<Sites>('/sites');
      this.server_ahead_ms = Date.parse(sites.now) - Date.now();
      this.sites = sites;
      const instance = (of: Sites | null): string =>
        (of?.sites ?? []).map(({ id, forecast }) => `${id} ${forecast?.instance}`).join();
      if (before !== null && instance(before) !== instance(sites)) {
        this.asked.forget();
        this.tell('forecast');
      }
      this.tell('sites');
    } catch (problem) {
      if (problem instanceof Refused && this.sites === null) {
        this.sites = { now: '', stale_after_s: 0, trouble: problem.detail, sites: [] };
        this.tell('sites');
      }
    }
    const wait_ms = this.link.is === 'gone' ? TRY_AGAIN_MS : LOOK_AGAIN_MS;
    this.timer = setTimeout(() => void this.watch(), wait_ms);
  }

  /** An answer is kept until another forecast is in force. Throws Refused. */
  get<T>(path: string): Promise<T> {
    return this.asked.get<T>(path);
  }
  /** Asked anew, as for a mission under way. */
  fresh<T>(path: string): Promise<T> {
    return this.fetch_json<T>(path);
  }
  async post<T>(path: string, body: unknown): Promise<T> {
    return this.fetch_json<T>(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(body),
    });
  }

  async site(id: string): Promise<SiteMap> {
    return whole_site(await this.get(`/sites/${encodeURIComponent(id)}`));
  }
  /** One of /collections: the columns of values of an EDR query. */
  async columns(query: string): Promise<Column[]> {
    return read_coverages(await this.get(`/collections/${query}`));
  }

  private async fetch_json<T>(path: string, init?: RequestInit): Promise<T> {
    let answer: Response;
    try {
      answer = await this.ask(path, { cache: 'no-cache', ...init });
    } catch {
      this.set_link(false);
      throw new Refused(0, 'The server does not answer. The page tries again by itself.');
    }
    if (answer.status === 502 || answer.status === 503 || answer.status === 504) {
      const detail = await problem_of(answer);
      if (detail === null) this.set_link(false);
      throw new Refused(answer.status, detail ?? 'The server is not ready yet.');
    }
    this.set_link(true);
    if (!answer.ok) {
      const detail = (await problem_of(answer)) ?? `The server answers ${answer.status}.`;
      throw new Refused(answer.status, detail);
    }
    if (answer.status === 204) return undefined as T;
    try {
      return (await answer.json()) as T;
    } catch {
      throw new Refused(answer.status, 'The answer of the server is cut off or is not JSON.');
    }
  }

  private set_link(is_there: boolean): void {
    if (is_there === (this.link.is === 'there')) return;
    this.link = is_there ? { is: 'there' } : { is: 'gone', since_ms: Date.now() };
    this.tell('server');
    if (!is_there) {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => void this.watch(), TRY_AGAIN_MS);
    }
  }
}

async function problem_of(answer: Response): Promise<string | null> {
  try {
    const problem = (await answer.json()) as Partial<Problem>;
    return problem.detail ?? problem.title ?? null;
  } catch {
    return null;
  }
}
