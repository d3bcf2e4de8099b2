import type { UpAxis } from '../files/mesh/UpAxis.js';
import { evenPoints } from './evenPoints.js';
import { type FrontClues, frontEvidence, lengthAlong, type MeasuredView } from './frontEvidence.js';
import { measureView, type ViewMeasures } from './measureView.js';
import { type MirrorPlanes, mirrorPlanes } from './mirrorPlanes.js';
import { isWalled, planOf } from './planOf.js';
import { createSeenMap, drawSeenMap, type SeenMap } from './seenMap.js';
import { type ViewSurface, type ViewTriangles, viewSurface } from './viewSurface.js';

/** A direction to the eye, in degrees: around the up axis from the front to the right, and above the horizon. */
export interface ChosenView {
  azimuth: number;
  elevation: number;
}

/** The directions that are tried first, and the steps to those around the best. */
const AZIMUTHS = Array.from({ length: 12 }, (_, i) => 30 * i);
const ELEVATIONS = [15, 30];
/** What is seen best from at least this elevation is tried from this one, too. */
const FROM_ABOVE = { least: 30, elevation: 45 };
const AROUND = [
  [-15, 0],
  [15, 0],
  [0, -7.5],
  [0, 7.5],
];
/** How many views are chosen, and how far apart they are around the up axis. */
const MOST_VIEWS = 4;
const APART = 60;
/** A view at least this far from the first one, in degrees, is from behind. */
const BEHIND = 160;

/** The weight of each measure, per standard deviation among the views of a surface. */
const WEIGHTS = {
  visibility: 0.35,
  outline: 0.15,
  depth: 0.1,
  relief: 0.35,
  inner: 0.15,
  sides: 0.3,
  backs: -0.6,
} satisfies Partial<Record<keyof ViewMeasures, number>>;
/** The weight of the logarithm of the area that a view covers, which is least for a plate that is seen edge-on. */
const COVER = 1.5;
/** A measure that hardly varies is no reason: deviations count as at least this share of the mean. */
const LEAST_DEVIATION = 0.06;
/** The weight of a view three-quarter from the front and turned to it, and the deviation in degrees that still counts. */
const FRONT = { weight: 4, tolerance: 25 };
/** The angle between a view and the front: for what is narrow, such as a face, and for what is long, such as a horse. */
const THREE_QUARTER = { narrow: 28, long: 50 };
/** Evidence below this is weak. */
const CLEAR = 0.4;
/** How much evidence a clear plane of symmetry is for a direction along it. */
const MIRRORED = 2.5;
/** How much evidence a broad side is, by the logarithm of the area that it covers. */
const BROAD = 0.3;
/** The weight of a view from the side of +z, if nothing else tells two views apart. */
const CONVENTION = 0.3;
/** The weight of an elevation, and the deviation from the best one that costs as much, in degrees. */
const ABOVE = { weight: 1, tolerance: 15 };
/** The best elevations by kind of surface, in degrees. */
const BEST_ELEVATION = { tall: 14, usual: 20, low: 30, terrain: 38, room: 38, walled: 50 };

/** Finds the views that show a surface best: the best one first, the others from other sides. Yields its progress in [0, 1]. */
export function* chooseViews(triangles: ViewTriangles, up: UpAxis): Generator<number, ChosenView[], void> {
  const surface = viewSurface(triangles, up);
  if (surface.areas.length === 0) return [];
  yield 0.1;
  const map = createSeenMap(surface);
  const look = (azimuth: number, elevation: number): MeasuredView => {
    drawSeenMap(map, surface, azimuth, elevation);
    return { azimuth, elevation, measures: measureView(map, surface) };
  };
  const views: MeasuredView[] = [];
  const all = AZIMUTHS.length * (ELEVATIONS.length + 1) + MOST_VIEWS * AROUND.length;
  function* tryAll(elevation: number): Generator<number, void, void> {
    for (const azimuth of AZIMUTHS) {
      views.push(look(azimuth, elevation));
      yield Math.min(1, 0.1 + (0.9 * views.length) / all);
    }
  }
  for (const elevation of ELEVATIONS) yield* tryAll(elevation);
  const ofShape = elevationOfShape(surface, map);
  if (bestElevation(views, ofShape) >= FROM_ABOVE.least) yield* tryAll(FROM_ABOVE.elevation);
  const score = scoreOf(surface, views, ofShape);
  for (const { azimuth, elevation } of apart(views, score)) {
    for (const [around, above] of AROUND) {
      views.push(look((azimuth + around + 360) % 360, elevation + above));
      yield Math.min(1, 0.1 + (0.9 * views.length) / all);
    }
  }
  return apart(views, score).map(({ azimuth, elevation }) => ({ azimuth, elevation }));
}

/** The best views that are far enough apart. One of them is from behind the first, since the front may be taken for the back. */
function apart(views: readonly MeasuredView[], score: (view: MeasuredView) => number): MeasuredView[] {
  const sorted = views.map((view) => ({ view, value: score(view) })).sort((a, b) => b.value - a.value);
  const chosen: MeasuredView[] = [];
  const isBehind = ({ azimuth }: MeasuredView): boolean => angleBetween(azimuth, chosen[0].azimuth) >= BEHIND;
  const take = (isWanted: (view: MeasuredView) => boolean): void => {
    for (const { view } of sorted) {
      if (chosen.length === MOST_VIEWS) return;
      if (isWanted(view) && chosen.every(({ azimuth }) => angleBetween(azimuth, view.azimuth) >= APART))
        chosen.push(view);
    }
  };
  take(() => chosen.length < 2);
  if (!chosen.some(isBehind)) take(isBehind);
  take(() => true);
  return chosen;
}

const angleBetween = (a: number, b: number): number => Math.abs(((((a - b) % 360) + 540) % 360) - 180);

/** The function that rates a view, by the measures of the views that were tried first. @param ofShape the best elevation of what is no room */
function scoreOf(
  surface: ViewSurface,
  views: readonly MeasuredView[],
  ofShape: number,
): (view: MeasuredView) => number {
  const points = evenPoints(surface);
  const planes = mirrorPlanes(points);
  const clues = { points, squareness: squarenessOf(surface, planes.best), landmarks: surface.landmarks };
  const keys = Object.keys(WEIGHTS) as (keyof typeof WEIGHTS)[];
  const spread = keys.map((key) => {
    const values = views.map(({ measures }) => measures[key]);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    const square = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
    return { key, mean, deviation: Math.max(Math.sqrt(square), LEAST_DEVIATION * Math.abs(mean), 1e-3) };
  });
  const { azimuth: front, clarity } = frontOf(clues, planes, views);
  const length = lengthAlong(clues, front);
  const { narrow, long } = THREE_QUARTER;
  const ideal = narrow + (long - narrow) * Math.max(0, Math.min(1, length - 0.7));
  const best = bestElevation(views, ofShape);
  const widest = Math.max(...views.map(({ measures }) => measures.cover));
  return ({ azimuth, elevation, measures }) => {
    const rated = spread.reduce(
      (sum, { key, mean, deviation }) => sum + (WEIGHTS[key] * (measures[key] - mean)) / deviation,
      0,
    );
    const off = angleBetween(azimuth, front);
    const threeQuarter = Math.exp(-(((off - ideal) / FRONT.tolerance) ** 2));
    const turned = Math.cos((off * Math.PI) / 180);
    const above = ((elevation - best) / ABOVE.tolerance) ** 2;
    const covers = COVER * logRatio(measures.cover, widest);
    const usual = CONVENTION * Math.cos((azimuth * Math.PI) / 180);
    return rated + covers + usual + clarity * FRONT.weight * (threeQuarter + turned) - ABOVE.weight * above;
  };
}

/** The likely front of a surface, and how clear it is, from 0 to 1: along a plane that mirrors it, if there is one. */
function frontOf(
  clues: FrontClues,
  { best, clarityAt }: MirrorPlanes,
  views: readonly MeasuredView[],
): { azimuth: number; clarity: number } {
  const covers = views.slice(0, AZIMUTHS.length).map(({ measures }) => measures.cover);
  const widest = Math.max(...covers);
  const directions = [best, best + 180, ...AZIMUTHS].map((azimuth) => {
    const evidence = frontEvidence(clues, views, azimuth);
    const mirrors = clarityAt(azimuth);
    const cover = covers[Math.round(azimuth / 30) % AZIMUTHS.length];
    return { azimuth, evidence, mirrors, rated: evidence + MIRRORED * mirrors + BROAD * logRatio(cover, widest) };
  });
  const { azimuth, mirrors, evidence } = directions.reduce((a, b) => (b.rated > a.rated ? b : a));
  return { azimuth, clarity: Math.max(0, Math.min(1, evidence / CLEAR)) * Math.min(1, 0.4 + mirrors) };
}

const logRatio = (cover: number, widest: number): number => Math.log((cover + 1e-3) / (widest + 1e-3));

const bestElevation = (views: readonly MeasuredView[], ofShape: number): number =>
  isRoom(views) ? BEST_ELEVATION.room : ofShape;

/** The best elevation of a surface that is no room. */
function elevationOfShape(surface: ViewSurface, map: SeenMap): number {
  if (isWalled(planOf(surface, map))) return BEST_ELEVATION.walled;
  if (isTerrain(surface)) return BEST_ELEVATION.terrain;
  const height = surface.halfHeight / surface.halfWidth;
  if (height > 1) return BEST_ELEVATION.tall;
  return height < 0.35 ? BEST_ELEVATION.low : BEST_ELEVATION.usual;
}

/** Whether most of what is seen from outside shows its back, or lies beyond the middle since what is nearer is not drawn. */
function isRoom(views: readonly MeasuredView[]): boolean {
  const mean = (key: 'backs' | 'near'): number =>
    views.reduce((sum, { measures }) => sum + measures[key], 0) / views.length;
  return mean('backs') > 0.4 || mean('near') < -0.15;
}

/** The cosine of the angle within which a triangle faces along an axis. */
const ALONG = 0.96;

/** The share of a surface that faces up, down, or along or across a horizontal direction. @param azimuth of the direction, in degrees */
function squarenessOf({ normals, areas, area }: ViewSurface, azimuth: number): number {
  const x = Math.sin((azimuth * Math.PI) / 180);
  const z = Math.cos((azimuth * Math.PI) / 180);
  let square = 0;
  for (let triangle = 0; triangle < areas.length; triangle++) {
    const nx = normals[3 * triangle];
    const ny = normals[3 * triangle + 1];
    const nz = normals[3 * triangle + 2];
    if (Math.max(Math.abs(ny), Math.abs(nx * x + nz * z), Math.abs(nx * z - nz * x)) > ALONG) square += areas[triangle];
  }
  return square / area;
}

/** Whether a surface is low, and most of it faces upwards. */
function isTerrain({ normals, areas, area, halfHeight, halfWidth }: ViewSurface): boolean {
  let upward = 0;
  for (let triangle = 0; triangle < areas.length; triangle++) upward += normals[3 * triangle + 1] * areas[triangle];
  return halfHeight < 0.5 * halfWidth && Math.abs(upward) > 0.4 * area;
}
