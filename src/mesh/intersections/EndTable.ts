import { hashWords } from '../hashWords.js';

/** Numbers of a key: the lower and the higher vertex of an edge, and the triangle that it passes. */
const KEY = 3;

/** The end of a line on an edge of one mesh and in a triangle of another, by their numbers: a hash table with open addressing. */
export class EndTable {
  private keys = new Int32Array(KEY << 8);
  /** The value of each slot + 2; 0 where it is empty, 1 where an edge passes beside a triangle. */
  private values = new Int32Array(1 << 8);
  private count = 0;

  /** The slot of a key, or the empty one where it would be. */
  slotOf(low: number, high: number, triangle: number): number {
    const { keys, values } = this;
    const mask = values.length - 1;
    for (let slot = hashWords(low, high, triangle) & mask; ; slot = (slot + 1) & mask) {
      const k = KEY * slot;
      if (values[slot] === 0 || (keys[k] === low && keys[k + 1] === high && keys[k + 2] === triangle)) return slot;
    }
  }

  /** Whether a slot has a value. */
  has(slot: number): boolean {
    return this.values[slot] !== 0;
  }

  /** The value of a slot: a number from −1 on. */
  at(slot: number): number {
    return this.values[slot] - 2;
  }

  /** Enters a value into an empty slot. Slots may be others afterwards. @param value from −1 on */
  set(slot: number, low: number, high: number, triangle: number, value: number): void {
    this.keys[KEY * slot] = low;
    this.keys[KEY * slot + 1] = high;
    this.keys[KEY * slot + 2] = triangle;
    this.values[slot] = value + 2;
    this.count++;
    if (2 * this.count > this.values.length) this.grow();
  }

  private grow(): void {
    const { keys, values } = this;
    this.keys = new Int32Array(4 * keys.length);
    this.values = new Int32Array(4 * values.length);
    for (let old = 0; old < values.length; old++) {
      if (values[old] === 0) continue;
      const k = KEY * old;
      const slot = this.slotOf(keys[k], keys[k + 1], keys[k + 2]);
      for (let i = 0; i < KEY; i++) this.keys[KEY * slot + i] = keys[k + i];
      this.values[slot] = values[old];
    }
  }
}
