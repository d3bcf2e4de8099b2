import { combined, cross, dot, type Vec3 } from '../../look/vectors.js';
import { type LineSurface, placeFrom, readTriangle, STRIDE, WORLD } from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import type { Toner } from '../Toner.js';
import { PlaceInTriangle } from './PlaceInTriangle.js';

/** Computes the tone of a see-through surface, by the triangles that it had before subdivision. */
export class VeilTone {
  /** The first of its triangles. */
  readonly first: number;
  private readonly surface: LineSurface;

  /** @param surface before it is subdivided, which changes it */
  constructor(
    surface: LineSurface,
    private readonly toner: Toner,
    private readonly projection: Projection,
  ) {
    this.surface = { ...surface };
    this.first = surface.parents[0];
  }

  /** The printed tone at a place of a triangle of the scene. */
  at(triangle: number, world: Vec3): number {
    const { surface, toner, projection } = this;
    const { vertices, triangles } = surface;
    const t = triangle - this.first;
    const offsets = [0, 1, 2].map((k) => STRIDE * triangles[3 * t + k]);
    const [a, b, c] = offsets.map((o): Vec3 => [vertices[o + WORLD], vertices[o + WORLD + 1], vertices[o + WORLD + 2]]);
    const weights = new PlaceInTriangle(a, b, c).weightsAt(world);
    const numbers = Float64Array.from({ length: STRIDE }, (_, n) =>
      offsets.reduce((sum, o, k) => sum + weights[k] * vertices[o + n], 0),
    );
    const { way } = projection.wayToEye(...world);
    const isFront = dot(cross(combined(1, b, -1, a), combined(1, c, -1, a)), way) >= 0;
    return toner.read(placeFrom(numbers, readTriangle(surface, t), isFront ? 1 : -1), 'none').tone;
  }
}
