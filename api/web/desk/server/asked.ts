// What was asked a moment ago is not asked again: one answer for all parts. The server keeps its
// answers too, so that asking again is cheap; here they are kept as long as parts draw together.

export type Ask = (path: string, init?: RequestInit) => Promise<Response>;

const KEPT_MS = 60_000; // others decide, zones come into force
const MOST_KEPT = 64; // each press on the map asks for its own

interface Kept {
  answer: Promise<unknown>;
  since_ms: number; // when it came; Infinity while it is waited for
}

export class Asked {
  private readonly kept = new Map<string, Kept>();

  constructor(private readonly fetch_json: (path: string) => Promise<unknown>) {}

  get<T>(path: string): Promise<T> {
    this.drop_old();
    const known = this.kept.get(path);
    if (known !== undefined) return known.answer as Promise<T>;
    const made: Kept = { answer: this.fetch_json(path), since_ms: Infinity };
    this.kept.set(path, made);
    for (const oldest of this.kept.keys()) {
      if (this.kept.size <= MOST_KEPT) break;
      this.kept.delete(oldest);
    }
    made.answer.then(
      () => (made.since_ms = Date.now()),
      // A refusal is not kept: the next who asks may be luckier.
      () => {
        if (this.kept.get(path) === made) this.kept.delete(path);
      },
    );
    return made.answer as Promise<T>;
  }
  forget(): void {
    this.kept.clear();
  }

  private drop_old(): void {
    for (const [path, { since_ms }] of this.kept) {
      if (Date.now() - since_ms > KEPT_MS) this.kept.delete(path);
    }
  }
}
