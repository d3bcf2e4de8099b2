/** The corners of triangles, in an array that grows: their number is not known at first. */
export class GrowingIndices {
  private array = new Uint32Array(3 * 1024);
  /** The number of corners. */
  length = 0;

  /** Makes room for so many corners more, where their number is known. */
  reserve(count: number): void {
    if (this.length + count > this.array.length) this.lengthen(this.length + count);
  }

  add(a: number, b: number, c: number): void {
    if (this.length + 3 > this.array.length) this.lengthen(2 * this.array.length);
    this.array[this.length++] = a;
    this.array[this.length++] = b;
    this.array[this.length++] = c;
  }

  /** The corners, without a copy. */
  values(): Uint32Array {
    return this.array.subarray(0, this.length);
  }

  private lengthen(room: number): void {
    const longer = new Uint32Array(room);
    longer.set(this.array.subarray(0, this.length));
    this.array = longer;
  }
}
