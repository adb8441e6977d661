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
import { Token } from './token';

const LOOK_AGAIN_MS = 30_000;
const TRY_AGAIN_MS = 3_000;
const SITES_WITHIN_MS = 20_000; // /sites costs the server nothing
const ANSWER_WITHIN_MS = 180_000; // a plan may take its time

/** What a part shows in place of a value that did not come: `detail` as the server says it. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly detail: string,
  ) {
    super(detail);
  }
}

/** Gone: `why` is what it said, null where it said nothing. */
export type Link = { is: 'there' } | { is: 'gone'; why: string | null };
type Told = 'sites' | 'forecast' | 'server';

export class Server {
  link: Link = { is: 'there' };
  /** null before the first answer. */
  sites: Sites | null = null;
  /** By the server's clock: when it last told its sites. */
  heard_ms: number | null = null;
  readonly token = new Token();
  private readonly asked: Asked;
  private server_ahead_ms = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly ask: Ask,
    private readonly tell: (what: Told) => void,
    private readonly viewed: () => string, // the site that is looked at
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
      const sites = await this.fetch_json<Sites>('/sites', {}, SITES_WITHIN_MS);
      const before = this.sites;
      this.heard_ms = Date.parse(sites.now);
      this.server_ahead_ms = this.heard_ms - Date.now();
      this.sites = sites;
      this.set_link({ is: 'there' });
      const is_other = (id: string): boolean =>
        before !== null && instance_of(before, id) !== instance_of(sites, id);
      const all = new Set([...(before ?? sites).sites, ...sites.sites].map(({ id }) => id));
      if ([...all].some(is_other)) this.asked.forget();
      // What is in force elsewhere changes nothing of what is drawn.
      if (is_other(this.viewed())) this.tell('forecast');
      this.tell('sites');
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (this.sites === null) {
        this.sites = { now: '', stale_after_s: 0, trouble: problem.detail, sites: [] };
        this.tell('sites');
      }
      this.set_link({ is: 'gone', why: problem.status === 0 ? null : problem.detail });
    }
    const wait_ms = this.link.is === 'gone' ? TRY_AGAIN_MS : LOOK_AGAIN_MS;
    this.timer = setTimeout(() => void this.watch(), wait_ms);
  }

  /** An answer is kept for a minute, and no longer than its forecast. Throws Refused. */
  get<T>(path: string): Promise<T> {
    return this.asked.get<T>(path);
  }
  /** With the token, where one was given. Throws Refused: of status 401 where one is wanting. */
  async post<T>(path: string, body: unknown): Promise<T> {
    const { headers } = this.token;
    try {
      return await this.fetch_json<T>(path, {
        method: 'POST',
        headers: { 'Content-Type': 'application/json', ...headers },
        body: JSON.stringify(body),
      });
    } catch (problem) {
      if (!(problem instanceof Refused) || problem.status !== 401) throw problem;
      throw new Refused(401, this.token.refused(headers));
    }
  }

  async site(id: string): Promise<SiteMap> {
    return whole_site(await this.get(`/sites/${encodeURIComponent(id)}`));
  }
  /** One of /collections: the columns of values of an EDR query. */
  async columns(query: string): Promise<Column[]> {
    return read_coverages(await this.get(`/collections/${query}`));
  }

  private async fetch_json<T>(
    path: string,
    init: RequestInit = {},
    within_ms = ANSWER_WITHIN_MS,
  ): Promise<T> {
    const stop = new AbortController();
    const timer = setTimeout(() => stop.abort(), within_ms);
    try {
      return await this.answer_of<T>(path, { ...init, signal: stop.signal });
    } catch (problem) {
      if (!stop.signal.aborted) throw problem;
      throw new Refused(0, `The server gave no answer within ${within_ms / 1000} s.`);
    } finally {
      clearTimeout(timer);
    }
  }

  private async answer_of<T>(path: string, init: RequestInit): Promise<T> {
    let answer: Response;
    try {
      answer = await this.ask(path, { cache: 'no-cache', ...init });
    } catch {
      // A slow answer is no dead server: whether that is there, /sites tells.
      if (init.signal?.aborted !== true) this.set_link({ is: 'gone', why: null });
      throw new Refused(0, 'The server does not answer. The page tries again by itself.');
    }
    if (answer.ok) {
      if (answer.status === 204) return undefined as T;
      try {
        return (await answer.json()) as T;
      } catch {
        throw new Refused(answer.status, 'The answer of the server is cut off or is not JSON.');
      }
    }
    const detail = await problem_of(answer);
    const is_proxy = answer.status === 502 || answer.status === 503 || answer.status === 504;
    if (is_proxy && detail === null) this.set_link({ is: 'gone', why: null });
    const otherwise = is_proxy
      ? 'The server is not ready yet.'
      : `The server answers ${answer.status}.`;
    throw new Refused(answer.status, detail ?? otherwise);
  }

  /** Only /sites says that it is there: one good answer among bad ones does not. */
  private set_link(link: Link): void {
    const before = this.link;
    this.link = link;
    const why = (of: Link): string | null => (of.is === 'gone' ? of.why : null);
    if (link.is === before.is && why(link) === why(before)) return;
    this.tell('server');
    if (link.is === 'gone') {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => void this.watch(), TRY_AGAIN_MS);
    }
  }
}

const instance_of = ({ sites }: Sites, site: string): string =>
  sites.find(({ id }) => id === site)?.forecast?.instance ?? '';

async function problem_of(answer: Response): Promise<string | null> {
  try {
    const problem = (await answer.json()) as Partial<Problem>;
    return problem.detail ?? problem.title ?? null;
  } catch {
    return null;
  }
}
