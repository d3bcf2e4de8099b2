/** A typed array that can grow. */
export class GrowingArray<Numbers extends Float64Array | Int32Array | Uint8Array> {
  length = 0;

  /** @param data initial contents, of which the first `length` count */
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

  /** Makes room for a total number of elements. */
  reserve(count: number): void {
    if (count <= this.data.length) return;
    const Kind = this.data.constructor as new (count: number) => Numbers;
    // At first exactly as many as asked for, since callers that know the number reserve it.
    const least = this.length === 0 ? 0 : Math.max(1.5 * this.length, 64);
    const larger = new Kind(Math.ceil(Math.max(count, least)));
    larger.set(this.used());
    this.data = larger;
  }

  /** A copy of the elements, in a buffer of their own. */
  taken(): Numbers {
    return this.length === this.data.length ? this.data : (this.data.slice(0, this.length) as Numbers);
  }

  /** The elements, not copied. */
  used(): Numbers {
    return this.data.subarray(0, this.length) as Numbers;
  }
}
