// Work that is done one after the other: a hundred reports are not asked for at once.

export class OneByOne<T> {
  private readonly waiting: T[] = [];
  private is_at_work = false;

  /** @param work  never rejects */
  constructor(private readonly work: (what: T) => Promise<void>) {}

  /** What waits already is not added again; what is at work may be wanted anew. */
  add(what: readonly T[]): void {
    this.waiting.push(...what.filter((it) => !this.waiting.includes(it)));
    void this.run();
  }

  private async run(): Promise<void> {
    if (this.is_at_work) return;
    this.is_at_work = true;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      await this.work(next);
    }
    this.is_at_work = false;
  }
}
