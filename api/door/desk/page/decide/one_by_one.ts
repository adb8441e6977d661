// Work that is done one after the other: a hundred reports are not asked for at once.

export class OneByOne<T> {
  private readonly waiting: T[] = [];
  private at_work: T | null = null;

  /** @param work  never rejects */
  constructor(private readonly work: (what: T) => Promise<void>) {}

  add(what: readonly T[]): void {
    const known = new Set([...this.waiting, this.at_work]);
    this.waiting.push(...what.filter((it) => !known.has(it)));
    void this.run();
  }

  private async run(): Promise<void> {
    if (this.at_work !== null) return;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      this.at_work = next;
      await this.work(next);
    }
    this.at_work = null;
  }
}
