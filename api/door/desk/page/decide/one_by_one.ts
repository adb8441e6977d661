// Work that is done one after the other: a hundred reports are not asked for at once.

export class OneByOne<T> {
  private readonly waiting: T[] = [];
  private is_running = false;

  /** @param work  never rejects */
  constructor(private readonly work: (what: T) => Promise<void>) {}

  add(what: readonly T[]): void {
    this.waiting.push(...what.filter((it) => !this.waiting.includes(it)));
    void this.run();
  }
  /** What is looked at goes before what is not. */
  first(what: T): void {
    const at = this.waiting.indexOf(what);
    if (at > 0) this.waiting.unshift(...this.waiting.splice(at, 1));
  }
  clear(): void {
    this.waiting.length = 0;
  }

  private async run(): Promise<void> {
    if (this.is_running) return;
    this.is_running = true;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      await this.work(next);
    }
    this.is_running = false;
  }
}
