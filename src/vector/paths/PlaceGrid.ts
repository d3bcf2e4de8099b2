/** Cells have one index, with this distance between rows. */
const ROW = 2 ** 22;

/** Items by their places on a sheet. */
export class PlaceGrid<Item> {
  private readonly cells = new Map<number, Item[]>();

  /** @param reach the greatest distance at which items are looked for, pixels */
  constructor(private readonly reach: number) {}

  add(x: number, y: number, item: Item): void {
    const cell = this.cellOf(x, y);
    const known = this.cells.get(cell);
    if (known) known.push(item);
    else this.cells.set(cell, [item]);
  }

  /** The items in the cells around a place: all within the reach, and some beyond. */
  *around(x: number, y: number): Generator<Item, void, void> {
    const { reach } = this;
    for (const dy of [-reach, 0, reach])
      for (const dx of [-reach, 0, reach]) yield* this.cells.get(this.cellOf(x + dx, y + dy)) ?? [];
  }

  private cellOf(x: number, y: number): number {
    return Math.floor(x / this.reach) + ROW * Math.floor(y / this.reach);
  }
}
