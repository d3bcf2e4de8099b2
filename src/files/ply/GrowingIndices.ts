/** The corners of triangles, in an array that grows: their number is not known at first. */
export class GrowingIndices {
  private array = new Uint32Array(3 * 1024);
  /** The number of corners. */
  length = 0;

  add(a: number, b: number, c: number): void {
    if (this.length + 3 > this.array.length) {
      const longer = new Uint32Array(2 * this.array.length);
      longer.set(this.array);
      this.array = longer;
    }
    this.array[this.length++] = a;
    this.array[this.length++] = b;
    this.array[this.length++] = c;
  }

  /** The corners, without a copy. */
  values(): Uint32Array {
    return this.array.subarray(0, this.length);
  }
}
