import { STIPPLE_CONSTANTS } from '../look/constants/patternConstants.js';
import { combined, dot, normalize, timesVector, type Vec3 } from '../look/vectors.js';
import { asPhase } from '../mesh/phases.js';
import type { Bvh } from './Bvh.js';
import type { DrawnScene, StippledSurface } from './DrawnScene.js';
import { between, STRIDE, type SurfacePlace } from './LineSurface.js';
import type { Projection } from './Projection.js';
import { isClipped } from './paint/PaintLook.js';
import { PlaceReader } from './paint/PlaceReader.js';
import type { Translucency } from './paint/Translucency.js';
import { type ScreenMap, screenGradient, screenMap } from './shading/screenGradient.js';
import {
  coverOf,
  type DotPlane,
  type DotSize,
  directionOfNeedles,
  dotArea,
  dotOctave,
  grownBy,
  inLayer,
  layerTones,
  ownCover,
  planesNear,
  roundScreenMap,
  setShift,
} from './shading/stipple.js';
import { subdivide } from './subdivide.js';
import { ToneReader } from './ToneReader.js';
import { seenSides } from './traceFamily.js';

/** The dots of one ink, and of one material or part if these have layers of their own. */
export interface DotLayer {
  ink: string;
  group: string;
  dots: Dot[];
}

/** Draws the dots of stippled surfaces. above: height above surfaces at which rays start, world units. Yields its progress. */
export function* drawDots(
  scene: DrawnScene,
  projection: Projection,
  bvh: Bvh,
  translucency: Translucency,
  above: number,
): Generator<number, DotLayer[], void> {
  const layers: DotLayer[] = [];
  const { stippled } = scene;
  for (const [i, one] of stippled.entries()) {
    const drawing = dotsOf(one, scene, projection, bvh, translucency, above);
    const dots = yield* asPhase(drawing, i / stippled.length, (i + 1) / stippled.length);
    const layer = layers.find(({ ink, group }) => ink === one.ink && group === one.group);
    if (layer) for (const dot of dots) layer.dots.push(dot);
    else layers.push({ ink: one.ink, group: one.group, dots });
  }
  return layers;
}

/** A disc, pixels of the picture. */
export interface Dot {
  x: number;
  y: number;
  radius: number;
}

/** The inputs for placing the dots of a surface. */
interface DotScene extends StippledSurface {
  places: PlaceReader;
  toneReader: ToneReader;
  projection: Projection;
  bvh: Bvh;
  translucency: Translucency;
  /** Per triangle 1 if its front is visible, −1 if its back is, 0 if nothing of it is drawn. */
  sides: Int8Array;
  /** Height above the surface at which rays start, world units. */
  above: number;
}

const { FILLING, FROM_BEHIND } = STIPPLE_CONSTANTS;

/** The cover that dots overlap at where everything is covered. */
const MOST_COVER = 0.999;
/** Factor on the area of dots that closes the last specks of paper. */
const FILLED = 2.5;
/** Smaller dots are omitted, pixels. */
const LEAST_RADIUS = 0.05;
/** Octaves of margin, for places between the corners of a triangle. */
const SPARE = 0.15;
/** Most cells of a triangle; a triangle with more is broken. */
const MOST_CELLS = 1 << 16;

/** Places the visible dots of a surface. Yields its progress. */
function* dotsOf(
  stippled: StippledSurface,
  { illumination }: DrawnScene,
  projection: Projection,
  bvh: Bvh,
  translucency: Translucency,
  above: number,
): Generator<number, Dot[], void> {
  const { surface, look, paint } = stippled;
  yield* asPhase(subdivide(surface, projection), 0, 0.1);
  const sides = yield* asPhase(seenSides(surface, projection), 0.1, 0.15);
  const toneReader = new ToneReader(look, illumination, bvh, projection);
  const places = new PlaceReader(surface, paint, sides, projection);
  const placer = new DotPlacer({ ...stippled, places, toneReader, projection, bvh, translucency, sides, above });
  for (let t = 0; t < sides.length; t++) {
    if (t % 64 === 63) yield 0.15 + (0.85 * t) / sides.length;
    if (sides[t] !== 0) placer.onTriangle(t);
  }
  return placer.dots;
}

/** The planes of dots at a place, and the screen map there. */
interface DotReading {
  planes: DotPlane[];
  areaOf: (plane: DotPlane) => number;
  /**
   * The share of a dot's area that is left on the flat triangle, whose angle differs from that of the smooth surface that dots are round
   * for.
   */
  flattenedOn: (plane: DotPlane) => number;
}

/** The least and the greatest cover of a layer's dots at a place. */
type Covers = readonly [least: number, most: number];

/** The same at a corner of a triangle. */
interface CornerReading extends DotReading {
  covers: Covers;
}

class DotPlacer {
  readonly dots: Dot[] = [];

  constructor(private readonly scene: DotScene) {}

  onTriangle(t: number): void {
    const { surface, places, layers, size } = this.scene;
    const corners = [0, 1, 2].map((k) => {
      const v = surface.triangles[3 * t + k];
      return between(surface.vertices, v, v, 0);
    });
    const read = corners.map((numbers) => places.read(numbers, t));
    const readings = read.map((place) => this.read(place));
    const tones = read.map((place) => this.tonesAt(t, place));
    const count = layerTones(1, layers).length;
    for (let layer = 0; layer < count; layer++) {
      const covered = readings.map((reading, k): CornerReading => {
        const [least, most] = tones[k].map((tone) => this.coverIn(layer, tone));
        return { ...reading, covers: [least, most] };
      });
      if (covered.every(({ covers }) => covers[1] <= 0)) continue;
      for (const { plane, from, to } of planesOf(covered, size)) {
        for (let level = Math.floor(from) + 1; level <= Math.floor(to) + 1; level++)
          this.onPlane(t, { corners, places: read }, { plane, level, layer });
      }
    }
  }

  /** Bounds of the tones around a corner of a triangle. */
  private tonesAt(t: number, place: SurfacePlace): readonly [number, number] {
    const { places, toneReader } = this.scene;
    if (places.hasRelief) return [0, 1];
    const tones = places
      .paintsAt(t, place)
      .map((paint) => toneReader.read({ ...place, paint }, toneReader.hasShadows ? 'traced' : 'none').tone);
    return [Math.min(...tones), Math.max(...tones)];
  }

  private coverIn(layer: number, tone: number): number {
    return Math.min(coverOf(layerTones(tone, this.scene.layers)[layer]), MOST_COVER);
  }

  private read(place: SurfacePlace): DotReading {
    const { surface, projection } = this.scene;
    const { view, fieldNormal } = place;
    const { isOrthographic } = projection;
    const sight: Vec3 = isOrthographic ? [0, 0, 1] : combined(-1, view, 0, view);
    const viewToField = place.posed?.smooth ?? surface.viewToField;
    const toViewer = normalize(timesVector(viewToField, sight));
    const isBehind = dot(fieldNormal, toViewer) < FROM_BEHIND;
    const front = isBehind ? combined(-1, fieldNormal, 0, fieldNormal) : fieldNormal;
    const unitsPerPixel = projection.unitsPerPixel(-view[2]);
    const seen = { view, isOrthographic, unitsPerPixel };
    const round = roundScreenMap(screenMap(front, viewToField, seen), unitsPerPixel);
    const flat = screenMap(place.flatNormal, place.posed?.flat ?? surface.viewToField, seen, true);
    return {
      planes: planesNear(directionOfNeedles(front, toViewer)),
      areaOf: (plane) => areaIn(plane, round),
      flattenedOn: (plane) => areaIn(plane, round) / Math.max(areaIn(plane, flat), 1e-30),
    };
  }

  /** Places the dots of a plane on a triangle, with cells of one level. */
  private onPlane(
    t: number,
    { corners, places }: { corners: readonly Float64Array[]; places: readonly SurfacePlace[] },
    cellsOf: CellsOfLayer,
  ): void {
    const { set, size, layers } = this.scene;
    const { plane, level, layer } = cellsOf;
    const cells = 2 ** level;
    const [shiftU, shiftV] = setShift(plane.axis, size.tilesPerObjectUnit);
    const [a, b, c] = places.map(({ field }) => {
      const place = inLayer(field, layer, layers);
      return [cells * (dot(place, plane.u) + shiftU), cells * (dot(place, plane.v) + shiftV)];
    });
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
        this.addDot(t, numbers, cellsOf, set.texels[texel + 2] / 255);
      }
    }
  }

  private addDot(
    t: number,
    numbers: Float64Array,
    { plane: { axis }, level, layer }: CellsOfLayer,
    born: number,
  ): void {
    const { places, clip, toneReader, size, projection, bvh, translucency, surface, above } = this.scene;
    const place = places.read(numbers, t);
    if ((place.paint !== null && place.paint.alphaMargin < 0) || (clip && isClipped(clip, place.world))) return;
    const { planes, areaOf, flattenedOn } = this.read(place);
    const plane = planes.find((one) => isSame(one.axis, axis));
    if (!plane) return;
    const cover = this.coverIn(layer, toneReader.read(place, toneReader.hasShadows ? 'traced' : 'none').tone);
    if (cover <= 0) return;
    const pixelArea = areaOf(plane);
    const own = ownCover(cover, plane.share);
    const octave = dotOctave(pixelArea, own, size);
    if (Math.floor(octave) + 1 !== level) return;
    const area = flattenedOn(plane) * dotArea(pixelArea, own, octave) * grownBy(octave - Math.floor(octave), born);
    const filling = 1 + ((FILLED - 1) * Math.max(cover - FILLING, 0)) / (1 - FILLING);
    const radius = Math.sqrt((filling * area) / Math.PI);
    const [x, y] = projection.project(...place.view);
    if (!(radius >= LEAST_RADIUS) || !projection.contains(x, y)) return;
    const { way, end } = projection.wayToEye(...place.world);
    if (bvh.isHidden(place.world, way, above / Math.hypot(...way), end, surface.parents[t])) return;
    const left = translucency.transmittance(place.world, surface.parents[t]);
    if (left === 0) return;
    const faded = left === 1 ? 1 : left * translucency.deepening(place.world, surface.parents[t]);
    this.dots.push({ x, y, radius: radius * Math.sqrt(faded) });
  }
}

/** Cells of one size in which a layer has dots of a plane. */
interface CellsOfLayer {
  plane: DotPlane;
  level: number;
  layer: number;
}

/** Area of a pixel in a plane, object units². */
function areaIn({ u, v }: DotPlane, map: ScreenMap): number {
  const [a, b] = [screenGradient(u, map), screenGradient(v, map)];
  return Math.abs(a[0] * b[1] - a[1] * b[0]);
}

const wrapped = (cell: number, cells: number): number => ((cell % cells) + cells) % cells;

const isSame = (a: Vec3, b: Vec3): boolean => dot(a, b) > 0.999;

/** The planes that have dots at any of the corners, with the octaves of their cells. */
function planesOf(readings: readonly CornerReading[], size: DotSize): { plane: DotPlane; from: number; to: number }[] {
  const found: { plane: DotPlane; from: number; to: number }[] = [];
  for (const { planes } of readings) {
    for (const plane of planes) {
      if (found.some((one) => isSame(one.plane.axis, plane.axis))) continue;
      let [from, to] = [Infinity, -Infinity];
      for (const { planes: others, areaOf, covers } of readings) {
        const share = others.find((one) => isSame(one.axis, plane.axis))?.share ?? 0;
        const [least, most] = covers.map((cover) =>
          dotOctave(areaOf(plane), ownCover(Math.max(cover, 0), share), size),
        );
        from = Math.min(from, least - SPARE);
        to = Math.max(to, most + SPARE);
      }
      found.push({ plane, from, to });
    }
  }
  return found;
}
