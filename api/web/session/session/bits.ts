// Numbers that were written bit by bit, the highest bit of a byte first.

const MOST_DIGITS = 26;

/** Never fails: what is not there reads as 0, and `is_over` tells. */
export class BitReader {
  private at = 0;
  /** More was read than there is, or a number longer than any that is written. */
  is_over = false;

  constructor(private readonly bytes: Uint8Array) {}

  bit(): number {
    const byte = this.bytes[this.at >> 3];
    if (byte === undefined) {
      this.is_over = true;
      return 0;
    }
    const bit = (byte >> (7 - (this.at & 7))) & 1;
    this.at += 1;
    return bit;
  }
  bits(count: number): number {
    let value = 0;
    for (let i = 0; i < count; i += 1) value = 2 * value + this.bit();
    return value;
  }
  /** Exponential Golomb. */
  count(): number {
    let zeros = 0;
    while (this.bit() === 0) {
      zeros += 1;
      if (zeros > MOST_DIGITS || this.is_over) {
        this.is_over = true;
        return 0;
      }
    }
    return 2 ** zeros + this.bits(zeros) - 1;
  }
  /** The counts 0, 1, 2, 3, 4 as 0, -1, 1, -2, 2. */
  signed(): number {
    const count = this.count();
    return count % 2 === 0 ? count / 2 : -(count + 1) / 2;
  }
  /** All is read but zeros to the end of the byte. */
  is_at_end(): boolean {
    while (this.at % 8 !== 0) if (this.bit() !== 0) return false;
    return !this.is_over && this.at === 8 * this.bytes.length;
  }
}
