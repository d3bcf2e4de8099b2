/** A typed array that numbers are added to. */
export class GrowingArray<Numbers extends Float64Array | Int32Array | Uint8Array> {
  length = 0;

  /** @param data what it begins with; `length` of them count */
  constructor(
    public data: Numbers,
    length = data.length,
  ) {
    this.length = length;
  }

  push(number: number): void {
    if (this.length === this.data.length) this.reserve(this.length + 1);
    this.data[this.length++] = number;
  }

  /** Makes room for so many numbers in all. */
  reserve(count: number): void {
    if (count <= this.data.length) return;
    const Kind = this.data.constructor as new (count: number) => Numbers;
    // At first as many as asked for: whoever knows how many come says so.
    const least = this.length === 0 ? 0 : Math.max(1.5 * this.length, 64);
    const larger = new Kind(Math.ceil(Math.max(count, least)));
    larger.set(this.used());
    this.data = larger;
  }

  /** Those that count, in a buffer of their own. */
  taken(): Numbers {
    return this.length === this.data.length ? this.data : (this.data.slice(0, this.length) as Numbers);
  }

  /** Those that count, not copied. */
  used(): Numbers {
    return this.data.subarray(0, this.length) as Numbers;
  }
}
