import { STIPPLE_CONSTANTS } from '../../engraving/constants/stippleConstants.js';
import { screenGradient, screenMap } from '../../engraving/screenGradient.js';
import {
  coverOf,
  type DotPlane,
  type DotSize,
  directionOfNeedles,
  dotArea,
  dotOctave,
  grownBy,
  ownCover,
  planesNear,
  roundScreenMap,
  setShift,
} from '../../engraving/stipple.js';
import { combined, dot, normalize, timesVector, type Vec3 } from '../../engraving/vectors.js';
import type { Bvh } from '../Bvh.js';
import { between, flatNormalOf, type LineSurface, placeFrom, STRIDE, type SurfacePlace } from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import type { Toner } from '../Toner.js';

/** The set of points that dots lie at: per cell the place within it, 255 for 1, and when in an octave it is born; four numbers. */
export interface DotSet {
  /** Cells per side after which it repeats. */
  cells: number;
  texels: Uint8Array;
}

/** A disc, pixels of the picture. */
export interface Dot {
  x: number;
  y: number;
  radius: number;
}

/** What dots are placed with. The field space of the surface is that of the object. */
export interface DotScene {
  surface: LineSurface;
  size: DotSize;
  set: DotSet;
  toner: Toner;
  projection: Projection;
  bvh: Bvh;
  /** Per triangle 1 where its front is seen, −1 where its back is, 0 where nothing is drawn of it. */
  sides: Int8Array;
  /** How far above the surface rays begin, world units. */
  above: number;
}

const { FILLING, FROM_BEHIND } = STIPPLE_CONSTANTS;

/** Where all is covered, dots overlap by as much as at this cover. */
const MOST_COVER = 0.999;
/** Where the last specks of paper fill, dots grow over them here, up to so many times their area. */
const FILLED = 2.5;
/** Smaller dots are left out, pixels. */
const LEAST_RADIUS = 0.05;
/** Octaves to spare, for places between the corners of a triangle. */
const SPARE = 0.15;
/** No triangle has more cells than this; where it would, it is broken. */
const MOST_CELLS = 1 << 16;

/** Places the dots of a surface that are seen. Yields its progress. */
export function* placeDots(scene: DotScene): Generator<number, Dot[], void> {
  const { sides } = scene;
  const placer = new DotPlacer(scene);
  for (let t = 0; t < sides.length; t++) {
    if (t % 64 === 63) yield t / sides.length;
    if (sides[t] !== 0) placer.onTriangle(t);
  }
  return placer.dots;
}

/** The planes that have dots at a place, and the way from them to the screen. */
interface DotReading {
  planes: DotPlane[];
  areaOf: (plane: DotPlane) => number;
  flattened: number;
  cover: number;
}

class DotPlacer {
  readonly dots: Dot[] = [];

  constructor(private readonly scene: DotScene) {}

  onTriangle(t: number): void {
    const { surface, sides } = this.scene;
    const corners = [0, 1, 2].map((k) => {
      const v = surface.triangles[3 * t + k];
      return between(surface.vertices, v, v, 0);
    });
    const flat = flatNormalOf(surface, t);
    const places = corners.map((numbers) => placeFrom(numbers, flat, sides[t]));
    const readings = places.map((place) => this.read(place));
    if (readings.every(({ cover }) => cover <= 0)) return;
    for (const { plane, from, to } of planesOf(readings, this.scene.size)) {
      for (let level = Math.floor(from) + 1; level <= Math.floor(to) + 1; level++)
        this.onPlane(t, { corners, places, flat }, plane, level);
    }
  }

  private read(place: SurfacePlace): DotReading {
    const { surface, projection, toner } = this.scene;
    const { view, fieldNormal } = place;
    const { isOrthographic } = projection;
    const sight: Vec3 = isOrthographic ? [0, 0, 1] : combined(-1, view, 0, view);
    const toViewer = normalize(timesVector(surface.viewToField, sight));
    const isBehind = dot(fieldNormal, toViewer) < FROM_BEHIND;
    const front = isBehind ? combined(-1, fieldNormal, 0, fieldNormal) : fieldNormal;
    const unitsPerPixel = projection.unitsPerPixel(-view[2]);
    const plain = screenMap(front, surface.viewToField, { view, isOrthographic, unitsPerPixel });
    const { map, flattened } = roundScreenMap(plain, unitsPerPixel);
    return {
      planes: planesNear(directionOfNeedles(front, toViewer)),
      areaOf: ({ u, v }) => {
        const [a, b] = [screenGradient(u, map), screenGradient(v, map)];
        return Math.abs(a[0] * b[1] - a[1] * b[0]);
      },
      flattened,
      cover: Math.min(coverOf(toner.read(place, toner.hasShadows ? 'traced' : 'none').tone), MOST_COVER),
    };
  }

  /** Places the dots of a plane on a triangle whose cells are those of a level. */
  private onPlane(
    t: number,
    { corners, places, flat }: { corners: Float64Array[]; places: SurfacePlace[]; flat: Vec3 },
    plane: DotPlane,
    level: number,
  ): void {
    const { set, size, sides } = this.scene;
    const cells = 2 ** level;
    const [shiftU, shiftV] = setShift(plane.axis, size.tilesPerUnit);
    const [a, b, c] = places.map(({ field }) => [
      cells * (dot(field, plane.u) + shiftU),
      cells * (dot(field, plane.v) + shiftV),
    ]);
    const left = Math.floor(Math.min(a[0], b[0], c[0]));
    const right = Math.floor(Math.max(a[0], b[0], c[0]));
    const low = Math.floor(Math.min(a[1], b[1], c[1]));
    const high = Math.floor(Math.max(a[1], b[1], c[1]));
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0 || !((right - left + 1) * (high - low + 1) < MOST_CELLS)) return;
    for (let y = low; y <= high; y++) {
      for (let x = left; x <= right; x++) {
        const texel = 4 * (wrapped(y, set.cells) * set.cells + wrapped(x, set.cells));
        const px = x + set.texels[texel] / 255 - a[0];
        const py = y + set.texels[texel + 1] / 255 - a[1];
        const ofB = (px * (c[1] - a[1]) - py * (c[0] - a[0])) / area;
        const ofC = ((b[0] - a[0]) * py - (b[1] - a[1]) * px) / area;
        if (ofB < 0 || ofC < 0 || ofB + ofC > 1) continue;
        const numbers = new Float64Array(STRIDE);
        for (let k = 0; k < STRIDE; k++)
          numbers[k] = corners[0][k] + ofB * (corners[1][k] - corners[0][k]) + ofC * (corners[2][k] - corners[0][k]);
        this.addDot(t, placeFrom(numbers, flat, sides[t]), plane, level, set.texels[texel + 2] / 255);
      }
    }
  }

  private addDot(t: number, place: SurfacePlace, { axis }: DotPlane, level: number, born: number): void {
    const { size, projection, bvh, surface, above } = this.scene;
    const { planes, areaOf, flattened, cover } = this.read(place);
    const plane = planes.find((one) => isSame(one.axis, axis));
    if (!plane || cover <= 0) return;
    const pixelArea = areaOf(plane);
    const own = ownCover(cover, plane.share);
    const octave = dotOctave(pixelArea, own, size);
    if (Math.floor(octave) + 1 !== level) return;
    const area = flattened * dotArea(pixelArea, own, octave) * grownBy(octave - Math.floor(octave), born);
    const filling = 1 + ((FILLED - 1) * Math.max(cover - FILLING, 0)) / (1 - FILLING);
    const radius = Math.sqrt((filling * area) / Math.PI);
    const [x, y] = projection.project(...place.view);
    if (!(radius >= LEAST_RADIUS) || !projection.contains(x, y)) return;
    const { way, end } = projection.wayToEye(...place.world);
    if (bvh.isHidden(place.world, way, above / Math.hypot(...way), end, surface.parents[t])) return;
    this.dots.push({ x, y, radius });
  }
}

const wrapped = (cell: number, cells: number): number => ((cell % cells) + cells) % cells;

const isSame = (a: Vec3, b: Vec3): boolean => dot(a, b) > 0.999;

/** The planes that have dots anywhere at corners, and the octaves of their cells. */
function planesOf(readings: readonly DotReading[], size: DotSize): { plane: DotPlane; from: number; to: number }[] {
  const found: { plane: DotPlane; from: number; to: number }[] = [];
  for (const { planes } of readings) {
    for (const plane of planes) {
      if (found.some((one) => isSame(one.plane.axis, plane.axis))) continue;
      let [from, to] = [Infinity, -Infinity];
      for (const { planes: others, areaOf, cover } of readings) {
        const share = others.find((one) => isSame(one.axis, plane.axis))?.share ?? 0;
        const octave = dotOctave(areaOf(plane), ownCover(Math.max(cover, 0), share), size);
        from = Math.min(from, octave - SPARE);
        to = Math.max(to, octave + SPARE);
      }
      found.push({ plane, from, to });
    }
  }
  return found;
}
