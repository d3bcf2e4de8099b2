/** Six axes and the diagonals between them: along each, both extremes are kept. */
const AXES = Float64Array.from(
  [-1, 0, 1]
    .flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])))
    .slice(0, 13)
    .flat(),
);
const COUNT = AXES.length / 3;

/** The extreme points of an object along 26 directions, which stand for its whole extent. */
export class OuterPoints {
  private readonly reach = new Float64Array(2 * COUNT).fill(-Infinity);
  private readonly points = new Float64Array(6 * COUNT);

  /** Adds a point in world space. A point that is not finite is ignored. */
  add(x: number, y: number, z: number): void {
    const { reach } = this;
    for (let i = 0; i < COUNT; i++) {
      const along = AXES[3 * i] * x + AXES[3 * i + 1] * y + AXES[3 * i + 2] * z;
      if (along > reach[2 * i]) this.set(2 * i, along, x, y, z);
      if (-along > reach[2 * i + 1]) this.set(2 * i + 1, -along, x, y, z);
    }
  }

  /** Adds points given as x, y, z. */
  addAll(xyz: ArrayLike<number>): void {
    for (let i = 0; i + 2 < xyz.length; i += 3) this.add(xyz[i], xyz[i + 1], xyz[i + 2]);
  }

  /** x, y, z of each point; empty before any was added. */
  get xyz(): Float64Array {
    return this.reach[0] === -Infinity ? new Float64Array() : this.points;
  }

  private set(i: number, along: number, x: number, y: number, z: number): void {
    this.reach[i] = along;
    this.points[3 * i] = x;
    this.points[3 * i + 1] = y;
    this.points[3 * i + 2] = z;
  }
}
