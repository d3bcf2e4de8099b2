import { localDarkness } from '../../engraving/tone.js';
import { combined, cross, dot, normalize, type Vec3 } from '../../engraving/vectors.js';
import { MapSampler, type Rgba } from './MapSampler.js';
import type { MapLook, PaintLook } from './PaintLook.js';
import type { EdgeProducts } from './PlaceInTriangle.js';
import type { SurfaceDetails } from './SurfaceDetails.js';

/** What textures and colours make of a place. */
export interface Paint {
  /** How far the colour brings the tone to that of no light. */
  darkness: number;
  /** Luminance that the surface gives off. */
  emitted: number;
  /** What a map of light adds to the light from all around, and the share of it that a map of occlusion leaves. */
  around: number;
  open: number;
  /** Above 0 where the surface is there, in units of alpha; 1 where nothing is cut out of it. */
  standing: number;
  /** The normal of a map, along the coordinates and away from the surface; null where there is none. */
  relief: Vec3 | null;
}

/** Which pixels of textures: those at the place, or the least or the greatest of all. */
type Reading = 'here' | 'least' | 'most';

const luminance = (r: number, g: number, b: number): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Reads textures and colours of a surface. */
export class Painter {
  private readonly samplers = new Map<MapLook, MapSampler>();
  private triangle = -1;
  /** How many pixels of each texture lie along a world unit of the triangle at hand. */
  private readonly densities = new Map<MapLook, number>();

  constructor(
    private readonly look: PaintLook,
    private readonly details: SurfaceDetails,
  ) {
    for (const map of [look.map, look.emissiveMap, look.aoMap, look.lightMap, look.alphaMap, look.normalMap])
      if (map) this.samplers.set(map, new MapSampler(map));
  }

  /** Makes a triangle of the scene the one at hand. squares: the products of its edges in the world. */
  goTo(triangle: number, squares: EdgeProducts): void {
    if (triangle === this.triangle) return;
    this.triangle = triangle;
    const { corners, firstTriangle, stride, numbers } = this.details;
    const c = 3 * (triangle - firstTriangle);
    for (const [map, sampler] of this.samplers) {
      const [a, b, d] = [0, 1, 2].map((k) => stride * corners[c + k] + map.uv);
      const ab = sampler.pixelsAlong(numbers[b] - numbers[a], numbers[b + 1] - numbers[a + 1]);
      const ac = sampler.pixelsAlong(numbers[d] - numbers[a], numbers[d + 1] - numbers[a + 1]);
      this.densities.set(map, densityOf(squares, ab, ac));
    }
  }

  /**
   * The paint at a place.
   *
   * @param numbers its details
   * @param footprint the width of what is taken together, world units
   */
  paintAt(numbers: ArrayLike<number>, footprint: number): Paint {
    return this.read(numbers, footprint, 'here');
  }

  /** The paints between which that of the place lies, whatever pixels of textures are there. */
  boundsAt(numbers: ArrayLike<number>): readonly Paint[] {
    return [this.read(numbers, 0, 'least'), this.read(numbers, 0, 'most')];
  }

  /** Alpha less what it must be, at the size of the image: below 0 there is a hole. */
  standingAt(numbers: ArrayLike<number>): number {
    const { look } = this;
    const map = this.sample(look.map, numbers, 0, 'here');
    return this.standing(numbers, map, this.sample(look.alphaMap, numbers, 0, 'here'));
  }

  private read(numbers: ArrayLike<number>, footprint: number, reading: Reading): Paint {
    const { look } = this;
    const { color, emissive, vertexColor: o } = look;
    const map = this.sample(look.map, numbers, footprint, reading);
    const tint = (k: number): number => color[k] * map[k] * (o === null ? 1 : numbers[o + k]);
    const glow = this.sample(look.emissiveMap, numbers, footprint, reading);
    const emitted = luminance(emissive[0] * glow[0], emissive[1] * glow[1], emissive[2] * glow[2]);
    const light = look.lightMap ? this.sample(look.lightMap, numbers, footprint, reading) : NO_LIGHT;
    const occlusion = this.sample(look.aoMap, numbers, footprint, reading)[0];
    return {
      darkness: localDarkness(luminance(tint(0), tint(1), tint(2)), emitted, look.localTone, look.colorExposure),
      emitted,
      around: (look.lightMapIntensity * luminance(light[0], light[1], light[2])) / Math.PI,
      open: 1 - look.aoMapIntensity * (1 - occlusion),
      standing: this.standing(numbers, map, this.sample(look.alphaMap, numbers, footprint, reading)),
      relief: look.normalMap && reading === 'here' ? this.relief(look.normalMap, numbers, footprint) : null,
    };
  }

  private relief(map: MapLook, numbers: ArrayLike<number>, footprint: number): Vec3 {
    const [r, g, b] = this.sample(map, numbers, footprint, 'here');
    const [across, up] = this.look.normalScale;
    return [across * (2 * r - 1), up * (2 * g - 1), 2 * b - 1];
  }

  /** Whether a map bends normals, so that any tone may be anywhere. */
  get hasRelief(): boolean {
    return this.look.normalMap !== null;
  }

  /** The normal that a map makes of one in the world, as three.js does without tangents. */
  bent(normal: Vec3, relief: Vec3, [a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 {
    const { corners, firstTriangle, stride, numbers } = this.details;
    const { uv, transform: m } = this.look.normalMap!;
    const along = (k: number, row: number): number => {
      const [from, to] = [0, k].map((corner) => stride * corners[3 * (this.triangle - firstTriangle) + corner] + uv);
      return m[3 * row] * (numbers[to] - numbers[from]) + m[3 * row + 1] * (numbers[to + 1] - numbers[from + 1]);
    };
    const [ofFirst, ofSecond] = [cross(combined(1, c, -1, a), normal), cross(normal, combined(1, b, -1, a))];
    const right = combined(along(1, 0), ofFirst, along(2, 0), ofSecond);
    const up = combined(along(1, 1), ofFirst, along(2, 1), ofSecond);
    const scale = 1 / Math.sqrt(Math.max(dot(right, right), dot(up, up)) || 1);
    return normalize(combined(1, combined(scale * relief[0], right, scale * relief[1], up), relief[2], normal));
  }

  private standing(numbers: ArrayLike<number>, map: Rgba, alphaMap: Rgba): number {
    const { alphaTest, opacity, vertexColor: o } = this.look;
    if (alphaTest <= 0) return 1;
    return opacity * map[3] * alphaMap[1] * (o === null ? 1 : numbers[o + 3]) - alphaTest;
  }

  private sample(map: MapLook | null, numbers: ArrayLike<number>, footprint: number, reading: Reading): Rgba {
    const sampler = map && this.samplers.get(map);
    if (!sampler) return WHITE;
    if (reading !== 'here') return reading === 'least' ? sampler.least : sampler.most;
    return sampler.read(numbers[map.uv], numbers[map.uv + 1], footprint * (this.densities.get(map) ?? 0));
  }
}

/** How many pixels lie along a unit of a triangle at most, in the direction in which they lie closest. */
function densityOf({ bb, bc, cc }: EdgeProducts, ab: readonly [number, number], ac: readonly [number, number]): number {
  const determinant = bb * cc - bc * bc;
  if (!(determinant > 0)) return 0;
  const [pp, pq, qq] = [ab[0] ** 2 + ab[1] ** 2, ab[0] * ac[0] + ab[1] * ac[1], ac[0] ** 2 + ac[1] ** 2];
  // The greater eigenvalue of the one metric in the other.
  const half = (0.5 * (cc * pp - 2 * bc * pq + bb * qq)) / determinant;
  const product = (ab[0] * ac[1] - ab[1] * ac[0]) ** 2 / determinant;
  return Math.sqrt(half + Math.sqrt(Math.max(half * half - product, 0)));
}

const WHITE: Rgba = [1, 1, 1, 1];
const NO_LIGHT: Rgba = [0, 0, 0, 0];
