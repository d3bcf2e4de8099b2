import { TONE_CONSTANTS } from '../../look/constants/shadingConstants.js';
import { combined, cross, dot, normalize, timesVector, type Vec3 } from '../../look/vectors.js';
import type { Projection } from '../Projection.js';
import type { Mat3 } from '../shading/screenGradient.js';
import { localDarkness } from '../shading/tone.js';
import { type EdgeProducts, PlaceInTriangle } from './DetailReader.js';
import { MapSampler, type Rgba } from './MapSampler.js';
import { type MapLook, type Paint, type PaintLook, type SurfaceDetails, TONE_MAPS } from './PaintLook.js';

const { OPAQUE_TEXEL } = TONE_CONSTANTS;

/** A place whose normal is modified by a map, world space. */
export interface BentPlace {
  world: Vec3;
  normal: Vec3;
  /** 1 on front faces, −1 on back faces. */
  side: number;
  projection: Projection;
}

/** Which pixels of textures to read: those at the place, or the least or the greatest of all. */
type Reading = 'here' | 'least' | 'most';

const luminance = (r: number, g: number, b: number): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Reads the textures and colours of a surface. */
export class ColourReader {
  private readonly samplers = new Map<MapLook, MapSampler>();
  private triangle = -1;
  private corners: readonly [Vec3, Vec3, Vec3] = [NOWHERE, NOWHERE, NOWHERE];
  /** Pixels of each texture per world unit of the current triangle. */
  private readonly densities = new Map<MapLook, number>();

  constructor(
    private readonly look: PaintLook,
    private readonly details: SurfaceDetails,
  ) {
    for (const name of TONE_MAPS) {
      const map = look[name];
      if (map) this.samplers.set(map, new MapSampler(map));
    }
  }

  /** Sets the current triangle of the scene. squares: the products of its edges, world space. */
  goTo(triangle: number, squares: EdgeProducts, places: readonly [Vec3, Vec3, Vec3]): void {
    if (triangle === this.triangle) return;
    this.triangle = triangle;
    this.corners = places;
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
   * @param numbers details of the place
   * @param footprint width over which textures are averaged, world units
   */
  paintAt(numbers: ArrayLike<number>, footprint: number): Paint {
    return this.read(numbers, footprint, 'here');
  }

  /** Bounds of the paint at a place, whatever the pixels of textures. */
  boundsAt(numbers: ArrayLike<number>): readonly Paint[] {
    return [this.read(numbers, 0, 'least'), this.read(numbers, 0, 'most')];
  }

  /** Alpha minus its threshold, at full resolution: below 0 there is a hole. */
  alphaMarginAt(numbers: ArrayLike<number>): number {
    const { look } = this;
    const map = this.sample(look.map, numbers, 0, 'here');
    return this.alphaMargin(numbers, map, this.sample(look.alphaMap, numbers, 0, 'here'));
  }

  private read(numbers: ArrayLike<number>, footprint: number, reading: Reading): Paint {
    const { look } = this;
    const { color, emissive, vertexColor: o } = look;
    const map = this.sample(look.map, numbers, footprint, reading);
    const drawn = this.coarse(map, numbers, footprint, reading);
    const tint = (k: number): number => color[k] * drawn[k] * (o === null ? 1 : numbers[o + k]);
    const glow = this.sample(look.emissiveMap, numbers, footprint, reading);
    const emitted = luminance(emissive[0] * glow[0], emissive[1] * glow[1], emissive[2] * glow[2]);
    const light = look.lightMap ? this.sample(look.lightMap, numbers, footprint, reading) : NO_LIGHT;
    const occlusion = this.sample(look.aoMap, numbers, footprint, reading)[0];
    return {
      darkness: localDarkness([tint(0), tint(1), tint(2)], emitted, look.tones),
      emitted,
      around: (look.lightMapIntensity * luminance(light[0], light[1], light[2])) / Math.PI,
      open: 1 - look.aoMapIntensity * (1 - occlusion),
      alphaMargin: this.alphaMargin(numbers, map, this.sample(look.alphaMap, numbers, footprint, reading)),
    };
  }

  /** The colour of the map without details that are finer than lines can show; where it is cut out, as it is. The footprint is two pixels wide. */
  private coarse(map: Rgba, numbers: ArrayLike<number>, footprint: number, reading: Reading): Rgba {
    const { look } = this;
    if (reading !== 'here' || look.mapBlur === 0) return map;
    const coarse = this.sample(look.map, numbers, footprint * 2 ** (look.mapBlur - 1), reading);
    return coarse[3] < OPAQUE_TEXEL ? map : coarse;
  }

  /** Whether a normal or bump map is in use, so that any tone may occur anywhere. */
  get hasRelief(): boolean {
    return this.look.normalMap !== null || this.look.bumpMap !== null;
  }

  /** The normal at a place of the current triangle, modified by a map. */
  bent(place: BentPlace, numbers: ArrayLike<number>, footprint: number): Vec3 {
    const { normalMap, normalScale, normalToWorld, bumpMap } = this.look;
    if (bumpMap) return this.bentByHeights(bumpMap, place, numbers, footprint);
    if (!normalMap) return place.normal;
    const relief = unpacked(this.sample(normalMap, numbers, footprint, 'here'));
    if (normalToWorld) return bentInObject(relief, normalToWorld, place.side);
    const [a, b, c] = this.corners;
    return bentAlongCoordinates(place.normal, [normalScale[0] * relief[0], normalScale[1] * relief[1], relief[2]], {
      first: combined(1, b, -1, a),
      second: combined(1, c, -1, a),
      alongFirst: this.turned(normalMap, this.alongEdge(normalMap, 1)),
      alongSecond: this.turned(normalMap, this.alongEdge(normalMap, 2)),
    });
  }

  private bentByHeights(map: MapLook, place: BentPlace, numbers: ArrayLike<number>, footprint: number): Vec3 {
    const [a, b, c] = this.corners;
    const flat = cross(combined(1, b, -1, a), combined(1, c, -1, a));
    const steps = pixelSteps(place.world, flat, place.projection);
    if (!steps) return place.normal;
    const triangle = new PlaceInTriangle(a, b, c);
    const [first, second] = [this.alongEdge(map, 1), this.alongEdge(map, 2)];
    const heightAt = (u: number, v: number): number => this.sampleAt(map, u, v, footprint)[0];
    const [u, v] = [numbers[map.uv], numbers[map.uv + 1]];
    const here = heightAt(u, v);
    const riseAlong = (step: Vec3): number => {
      const [s, t] = triangle.sharesOf(step);
      return (
        this.look.bumpScale * (heightAt(u + s * first[0] + t * second[0], v + s * first[1] + t * second[1]) - here)
      );
    };
    return bentByHeights(place.normal, steps, [riseAlong(steps[0]), riseAlong(steps[1])], place.side);
  }

  /** The change of a map's coordinates from the first corner of the current triangle to another. */
  private alongEdge({ uv }: MapLook, corner: number): readonly [number, number] {
    const { corners, firstTriangle, stride, numbers } = this.details;
    const c = 3 * (this.triangle - firstTriangle);
    const [from, to] = [stride * corners[c] + uv, stride * corners[c + corner] + uv];
    return [numbers[to] - numbers[from], numbers[to + 1] - numbers[from + 1]];
  }

  /** A change of coordinates, by the transform of a map. */
  private turned({ transform: m }: MapLook, [u, v]: readonly [number, number]): readonly [number, number] {
    return [m[0] * u + m[1] * v, m[3] * u + m[4] * v];
  }

  private alphaMargin(numbers: ArrayLike<number>, map: Rgba, alphaMap: Rgba): number {
    const { alphaTest, opacity, vertexColor: o } = this.look;
    if (alphaTest <= 0) return 1;
    return opacity * map[3] * alphaMap[1] * (o === null ? 1 : numbers[o + 3]) - alphaTest;
  }

  private sample(map: MapLook | null, numbers: ArrayLike<number>, footprint: number, reading: Reading): Rgba {
    const sampler = map && this.samplers.get(map);
    if (!sampler) return WHITE;
    if (reading !== 'here') return reading === 'least' ? sampler.least : sampler.most;
    return this.sampleAt(map, numbers[map.uv], numbers[map.uv + 1], footprint);
  }

  private sampleAt(map: MapLook, u: number, v: number, footprint: number): Rgba {
    return this.samplers.get(map)!.read(u, v, footprint * (this.densities.get(map) ?? 0));
  }
}

/** The greatest number of pixels per unit of a triangle, over all directions. */
function densityOf({ bb, bc, cc }: EdgeProducts, ab: readonly [number, number], ac: readonly [number, number]): number {
  const determinant = bb * cc - bc * bc;
  if (!(determinant > 0)) return 0;
  const [pp, pq, qq] = [ab[0] ** 2 + ab[1] ** 2, ab[0] * ac[0] + ab[1] * ac[1], ac[0] ** 2 + ac[1] ** 2];
  // The greater eigenvalue of one metric relative to the other.
  const half = (0.5 * (cc * pp - 2 * bc * pq + bb * qq)) / determinant;
  const product = (ab[0] * ac[1] - ab[1] * ac[0]) ** 2 / determinant;
  return Math.sqrt(half + Math.sqrt(Math.max(half * half - product, 0)));
}

const WHITE: Rgba = [1, 1, 1, 1];
const NO_LIGHT: Rgba = [0, 0, 0, 0];
const NOWHERE: Vec3 = [0, 0, 0];

/** The vectors in the plane of a place that lead one pixel to the right and one up on the picture; null at grazing angles. */
function pixelSteps(world: Vec3, normal: Vec3, projection: Projection): readonly [Vec3, Vec3] | null {
  const [x, y] = projection.project(...projection.toView(world));
  const wayTo = (px: number, py: number): Vec3 | null => {
    const { origin, direction } = projection.rayThrough(px, py);
    const t = dot(combined(1, world, -1, origin), normal) / dot(direction, normal);
    return Number.isFinite(t) ? combined(1, combined(1, origin, t, direction), -1, world) : null;
  };
  const [right, up] = [wayTo(x + 1, y), wayTo(x, y - 1)];
  return right && up && [right, up];
}

/** The vector that a pixel of a normal map encodes. */
export const unpacked = ([r, g, b]: Rgba): Vec3 => [2 * r - 1, 2 * g - 1, 2 * b - 1];

/** The edges from the first corner of a triangle, and the changes of two coordinates along them. */
export interface EdgeSlopes {
  first: Vec3;
  second: Vec3;
  alongFirst: readonly [number, number];
  alongSecond: readonly [number, number];
}

/** The normal of a tangent-space normal map, as in three.js. World space. */
function bentAlongCoordinates(normal: Vec3, relief: Vec3, edges: EdgeSlopes): Vec3 {
  const [ofFirst, ofSecond] = [cross(edges.second, normal), cross(normal, edges.first)];
  const right = combined(edges.alongFirst[0], ofFirst, edges.alongSecond[0], ofSecond);
  const up = combined(edges.alongFirst[1], ofFirst, edges.alongSecond[1], ofSecond);
  const scale = 1 / Math.sqrt(Math.max(dot(right, right), dot(up, up)) || 1);
  return normalize(combined(1, combined(scale * relief[0], right, scale * relief[1], up), relief[2], normal));
}

/** The normal of an object-space normal map. side: 1 on front faces, −1 on back faces. */
function bentInObject(relief: Vec3, toWorld: Mat3, side: number): Vec3 {
  const [x, y, z] = normalize(timesVector(toWorld, relief));
  return [side * x, side * y, side * z];
}

/**
 * The normal of a bump map (Mikkelsen, 2010). The steps lead one pixel to the right and up on the picture: heights are in pixels, whatever
 * the size of the surface.
 *
 * @param rises changes of height along both steps
 * @param side 1 on front faces, −1 on back faces
 */
function bentByHeights(
  normal: Vec3,
  [right, up]: readonly [Vec3, Vec3],
  rises: readonly [number, number],
  side: number,
): Vec3 {
  const [x, y] = [normalize(right), normalize(up)];
  const [ofRight, ofUp] = [cross(y, normal), cross(normal, x)];
  const determinant = side * dot(x, ofRight);
  const gradient = combined(rises[0], ofRight, rises[1], ofUp);
  return normalize(combined(Math.abs(determinant), normal, -Math.sign(determinant), gradient));
}
