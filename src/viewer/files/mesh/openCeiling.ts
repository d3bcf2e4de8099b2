import { disjointSets, join, rootOf } from '../../../mesh/disjointSets.js';
import { runToEnd } from '../../../mesh/phases.js';
import { weldPositions } from '../../../mesh/weldPositions.js';
import { type Plan, placeOf, planOf, showsFloor, withinBorder } from '../../views/planOf.js';
import { createSeenMap, drawSeenMap, NOTHING } from '../../views/seenMap.js';
import { type ViewSurface, viewSurface } from '../../views/viewSurface.js';
import { compact } from './cleanMesh.js';
import { areaOf, boundsOf, oneSided, type PictureRange, type PlainMesh, triangleCount } from './PlainMesh.js';
import type { UpAxis } from './UpAxis.js';

/** A ceiling lies above this share of the height, and covers at least this share of the plan's box, level. */
const CEILING = { above: 0.85, cover: 0.5 };
/** The least share of the plan, without its border, that is as high as the ceiling: what slopes around a lid is no room's wall. */
const LID = 0.75;
/** The least cosine between the normal of a level triangle and the up axis. */
const LEVEL = 0.98;
/** Sheets that are narrower than this share of the plan are the tops of walls. */
const WALL = 0.04;
/** With its ceiling a room is closed: from these sides and above at most this share of what is seen is its inside. */
const INSIDE = { share: 0.2, elevations: [15, 30], azimuths: [0, 60, 120, 180, 240, 300] };
/** The greatest height of a room as a share of its longer and of its shorter side: higher bodies are cupboards and cubes. */
const HIGHEST = { ofLonger: 0.9, ofShorter: 2.7 };

/** The axis that points up, and whether it does so with its negative end. */
const axisOf = (up: UpAxis): [axis: 0 | 1 | 2, sign: 1 | -1] => [
  up.endsWith('x') ? 0 : up.endsWith('y') ? 1 : 2,
  up.startsWith('-') ? -1 : 1,
];

/** Whether a part of a ceiling is see-through: it hides nothing then. */
const isOfGlass = ({ ranges }: PlainMesh, ceiling: Uint8Array): boolean =>
  ranges?.some(
    ({ start, count, isSeeThrough }) => isSeeThrough && ceiling.subarray(start / 3, (start + count) / 3).includes(1),
  ) ?? false;

/**
 * Leaves out the ceiling of closed rooms, so that they are seen into from above: a flat lid over walls, which hides a floor at the bottom
 * with things on it. Houses with pitched roofs, open halls and buildings of several floors stay as they are.
 *
 * @param up the axis that points up
 * @returns the open mesh; undefined if there is no ceiling to leave out
 */
export const openCeiling = (mesh: PlainMesh, up: UpAxis): PlainMesh | undefined => openedAt(mesh, up)?.open;

/** The triangles of the ceiling that `openCeiling` leaves out: 1 for each of them, else 0. Undefined if there is none to leave out. */
export const ceilingOf = (mesh: PlainMesh, up: UpAxis): Uint8Array | undefined => openedAt(mesh, up)?.ceiling;

function openedAt(mesh: PlainMesh, up: UpAxis): { open: PlainMesh; ceiling: Uint8Array } | undefined {
  const ceiling = findCeiling(mesh, up);
  // A plate is nothing but a lid.
  if (!ceiling?.includes(1) || !ceiling.includes(0) || isOfGlass(mesh, ceiling)) return undefined;
  const closed = surfaceOf(mesh, up);
  if (!isCovered(planOf(closed)) || !isClosed(closed)) return undefined;
  const open = withBothSides(withoutTriangles(mesh, ceiling));
  return showsFloor(planOf(surfaceOf(open, up))) ? { open, ceiling } : undefined;
}

/** Whether a ceiling hides most of what lies below it from above. */
const isCovered = ({ within }: Plan): boolean =>
  within.filter((height) => height > CEILING.above).length > LID * within.length;

/** A mesh of which both sides are drawn: walls that face outward alone would be missing from within. */
const withBothSides = (mesh: PlainMesh): PlainMesh => ({
  ...mesh,
  ...(mesh.isOneSided && { isOneSided: false }),
  ...(mesh.ranges && {
    ranges: mesh.ranges.map((range) => (range.isOneSided ? { ...range, isOneSided: false } : range)),
  }),
});

/** Marks the triangles of a lid that covers the plan; undefined if there is none. */
function findCeiling(mesh: PlainMesh, up: UpAxis): Uint8Array | undefined {
  const { positions } = mesh;
  const [axis, sign] = axisOf(up);
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const { low, high } = boundsOf(positions);
  const size = high.map((value, k) => value - low[k]);
  const plan = size[u] * size[v];
  const most = Math.min(HIGHEST.ofLonger * Math.max(size[u], size[v]), HIGHEST.ofShorter * Math.min(size[u], size[v]));
  if (size[axis] > most) return undefined;
  const least = sign > 0 ? low[axis] + CEILING.above * size[axis] : low[axis] + (1 - CEILING.above) * size[axis];
  const isHigh = (vertex: number): boolean =>
    sign > 0 ? positions[3 * vertex + axis] >= least : positions[3 * vertex + axis] <= least;
  const count = triangleCount(mesh);
  const corner = (at: number): number => mesh.indices?.[at] ?? at;
  const isLevel = new Uint8Array(count);
  let area = 0;
  for (let triangle = 0; triangle < count; triangle++) {
    const [a, b, c] = [0, 1, 2].map((k) => corner(3 * triangle + k));
    if (!(isHigh(a) && isHigh(b) && isHigh(c))) continue;
    const own = areaOf(positions, 3 * a, 3 * b, 3 * c);
    const across = levelArea(positions, a, b, c, u, v);
    if (across < LEVEL * own) continue;
    isLevel[triangle] = 1;
    area += across;
  }
  // Most models have no lid, and need no search for one.
  if (area < CEILING.cover * plan) return undefined;
  const firsts = firstVertices(mesh);
  const at = (index: number): number => firsts[corner(index)];
  const pieces = disjointSets(firsts.length);
  for (let i = 0; i < 3 * count; i += 3) for (const k of [i + 1, i + 2]) join(pieces, at(i), at(k));
  const reachesDown = new Uint8Array(pieces.length);
  for (let i = 0; i < 3 * count; i++) if (!isHigh(corner(i))) reachesDown[rootOf(pieces, at(i))] = 1;
  const sheets = wideSheets(mesh, isLevel, at, WALL * Math.min(size[u], size[v]), [u, v]);
  const ceiling = new Uint8Array(count);
  for (let triangle = 0; triangle < count; triangle++)
    ceiling[triangle] = sheets[triangle] | (1 - reachesDown[rootOf(pieces, at(3 * triangle))]);
  return ceiling;
}

/** For each vertex the first one of its part at the same place: parts of a file that merely touch are apart. */
function firstVertices({ positions, parts }: PlainMesh): Uint32Array {
  const { canonical } = runToEnd(weldPositions(new Float32Array(positions)));
  if (!parts) return canonical;
  const { names, ofVertices } = parts;
  const firsts = new Map<number, number>();
  return canonical.map((place, vertex) => {
    const key = place * names.length + ofVertices[vertex];
    const first = firsts.get(key) ?? vertex;
    if (first === vertex) firsts.set(key, vertex);
    return first;
  });
}

/** The area of a triangle as seen along an axis, across `u` and `v`. */
function levelArea(positions: ArrayLike<number>, a: number, b: number, c: number, u: number, v: number): number {
  const from = (vertex: number, across: number): number => positions[3 * vertex + across] - positions[3 * a + across];
  return Math.abs(from(b, u) * from(c, v) - from(c, u) * from(b, v)) / 2;
}

/** Marks the level triangles that make sheets wider than the tops of walls, which are the ratio of area to outline. */
function wideSheets(
  { positions }: PlainMesh,
  isLevel: Uint8Array,
  at: (corner: number) => number,
  width: number,
  [u, v]: readonly [number, number],
): Uint8Array {
  const sheets = disjointSets(isLevel.length);
  /** The level triangle at each edge; −1 where there are two. */
  const borders = new Map<number, number>();
  const vertices = positions.length / 3;
  for (let triangle = 0; triangle < isLevel.length; triangle++) {
    if (isLevel[triangle] === 0) continue;
    for (let k = 0; k < 3; k++) {
      const [a, b] = [at(3 * triangle + k), at(3 * triangle + ((k + 1) % 3))];
      const key = Math.min(a, b) * vertices + Math.max(a, b);
      const other = borders.get(key);
      if (other === undefined) borders.set(key, triangle);
      else {
        if (other >= 0) join(sheets, triangle, other);
        borders.set(key, -1);
      }
    }
  }
  const areas = new Float64Array(isLevel.length);
  const outlines = new Float64Array(isLevel.length);
  for (let triangle = 0; triangle < isLevel.length; triangle++) {
    if (isLevel[triangle] === 0) continue;
    const corners = [0, 1, 2].map((k) => at(3 * triangle + k)) as [number, number, number];
    areas[rootOf(sheets, triangle)] += levelArea(positions, ...corners, u, v);
  }
  for (const [key, triangle] of borders) {
    if (triangle < 0) continue;
    const [a, b] = [Math.floor(key / vertices), key % vertices];
    outlines[rootOf(sheets, triangle)] += Math.hypot(
      positions[3 * b + u] - positions[3 * a + u],
      positions[3 * b + v] - positions[3 * a + v],
    );
  }
  return isLevel.map((level, triangle) => {
    const sheet = rootOf(sheets, triangle);
    return level && areas[sheet] > width * outlines[sheet] ? 1 : 0;
  });
}

/** A mesh without some triangles, and without the parts that had no others. */
function withoutTriangles(mesh: PlainMesh, isLeftOut: Uint8Array): PlainMesh {
  const count = triangleCount(mesh);
  const kept = new Uint32Array(3 * count);
  const ranges: PictureRange[] = [];
  let length = 0;
  for (const range of mesh.ranges ?? [{ start: 0, count: 3 * count, picture: -1 }]) {
    const first = length;
    for (let corner = range.start; corner < range.start + range.count; corner += 3) {
      if (isLeftOut[corner / 3]) continue;
      for (let k = corner; k < corner + 3; k++) kept[length++] = mesh.indices?.[k] ?? k;
    }
    if (length > first) ranges.push({ ...range, start: first, count: length - first });
  }
  const open = compact(mesh, kept.slice(0, length));
  if (open.parts) {
    const { names, ofVertices } = open.parts;
    const used = [...new Set(ofVertices)].sort((a, b) => a - b);
    const numbers = new Map(used.map((part, i) => [part, i]));
    if (used.length < 2) delete open.parts;
    else
      open.parts = {
        names: used.map((part) => names[part]),
        ofVertices: ofVertices.map((part) => numbers.get(part)!),
      };
  }
  return { ...open, ...(mesh.ranges && { ranges }) };
}

const surfaceOf = (mesh: PlainMesh, up: UpAxis): ViewSurface =>
  viewSurface({ ...mesh, isSingleSided: oneSided(mesh) }, up);

/** Whether the inside of a model is hardly seen from its sides and from above. */
function isClosed(surface: ViewSurface): boolean {
  const map = createSeenMap(surface);
  const isWithin = withinBorder(surface);
  const { low, high } = boundsOf(surface.positions);
  const ceiling = low[1] + CEILING.above * (high[1] - low[1]);
  let [seen, inside] = [0, 0];
  for (const elevation of INSIDE.elevations) {
    for (const azimuth of INSIDE.azimuths) {
      drawSeenMap(map, surface, azimuth, elevation);
      for (let pixel = 0; pixel < map.triangles.length; pixel++) {
        if (map.triangles[pixel] === NOTHING) continue;
        seen++;
        const place = placeOf(map, pixel);
        if (place[1] < ceiling && isWithin(place[0], place[2])) inside++;
      }
    }
  }
  return inside < INSIDE.share * seen;
}
