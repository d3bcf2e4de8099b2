const TWO_PI = 2 * Math.PI;

/** Measures angles about an edge. Its axes are two unit vectors u and v, perpendicular to the edge and to each other. */
export class EdgeAxes {
  private readonly ux: number;
  private readonly uy: number;
  private readonly uz: number;
  private readonly vx: number;
  private readonly vy: number;
  private readonly vz: number;

  constructor(
    private readonly positions: Float32Array,
    private readonly origin: number,
    target: number,
  ) {
    let x = positions[target] - positions[origin];
    let y = positions[target + 1] - positions[origin + 1];
    let z = positions[target + 2] - positions[origin + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    x /= length;
    y /= length;
    z /= length;
    // u is the cross product of the edge with the coordinate axis that it is least aligned with; v = edge × u.
    const ax = Math.abs(x);
    const ay = Math.abs(y);
    const az = Math.abs(z);
    let ux = 0;
    let uy = 0;
    let uz = 0;
    if (ax <= ay && ax <= az) {
      uy = z;
      uz = -y;
    } else if (ay <= az) {
      ux = -z;
      uz = x;
    } else {
      ux = y;
      uy = -x;
    }
    const scale = 1 / Math.sqrt(ux * ux + uy * uy + uz * uz);
    this.ux = ux * scale;
    this.uy = uy * scale;
    this.uz = uz * scale;
    this.vx = y * this.uz - z * this.uy;
    this.vy = z * this.ux - x * this.uz;
    this.vz = x * this.uy - y * this.ux;
  }

  /** The angle of a position about the edge, in [0, 2π). */
  angleOf(position: number): number {
    const { positions, origin } = this;
    const x = positions[position] - positions[origin];
    const y = positions[position + 1] - positions[origin + 1];
    const z = positions[position + 2] - positions[origin + 2];
    const angle = Math.atan2(x * this.vx + y * this.vy + z * this.vz, x * this.ux + y * this.uy + z * this.uz);
    // A tiny negative angle plus 2π rounds to 2π; the remainder makes that 0.
    return angle < 0 ? (angle + TWO_PI) % TWO_PI : angle;
  }
}
