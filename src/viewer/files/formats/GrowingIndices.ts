/** A growing index array, for files that do not announce their number of triangles. */
export class GrowingIndices {
  private array = new Uint32Array(3 * 1024);
  /** The number of indices. */
  length = 0;

  /** Makes room for this many more indices. */
  reserve(count: number): void {
    if (this.length + count > this.array.length) this.lengthen(this.length + count);
  }

  add(a: number, b: number, c: number): void {
    if (this.length + 3 > this.array.length) this.lengthen(2 * this.array.length);
    this.array[this.length++] = a;
    this.array[this.length++] = b;
    this.array[this.length++] = c;
  }

  /** The indices, without a copy. */
  values(): Uint32Array {
    return this.array.subarray(0, this.length);
  }

  private lengthen(room: number): void {
    const longer = new Uint32Array(room);
    longer.set(this.array.subarray(0, this.length));
    this.array = longer;
  }
}
