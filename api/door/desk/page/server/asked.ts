// What was asked once is not asked again: one answer for all parts, until it is forgotten.

export type Ask = (path: string, init?: RequestInit) => Promise<Response>;

export class Asked {
  private readonly kept = new Map<string, Promise<unknown>>();

  constructor(private readonly fetch_json: (path: string) => Promise<unknown>) {}

  get<T>(path: string): Promise<T> {
    const known = this.kept.get(path);
    if (known !== undefined) return known as Promise<T>;
    const coming = this.fetch_json(path);
    this.kept.set(path, coming);
    // A refusal is not kept: the next who asks may be luckier.
    coming.catch(() => {
      if (this.kept.get(path) === coming) this.kept.delete(path);
    });
    return coming as Promise<T>;
  }
  forget(): void {
    this.kept.clear();
  }
}
