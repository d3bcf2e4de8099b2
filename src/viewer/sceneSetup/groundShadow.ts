import {
  MathUtils,
  Matrix4,
  type Mesh,
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  Vector3,
  Vector4,
} from 'three';
import type { Motion } from '../drawing/Motion.js';
import { drawnMeshes, isSolid, placements, rangesOf } from '../drawing/meshes.js';

/** Size of the cells of a grid over the model, in radii. */
const CELL = 1 / 32;
/** Number of cells along each side of the grid. Parts of a moving model outside it count in the outermost cells. */
const CELLS = 80;
/** Edges are split into parts of at most this length, placed at their midpoints. Triangles with shorter edges are placed at their centres. */
const LONGEST = CELL / 2;
/**
 * The largest horizontal distance between a caster and the geometry that it represents: half the diagonal of a cell, and two thirds of a
 * triangle of that length.
 */
const CASTER_ERROR = CELL * Math.SQRT1_2 + (2 / 3) * LONGEST;
/** The maximum number of sampled poses of a clip, and of corners in all of them. */
const MOST_POSES = 8;
const MOST_CORNERS = 60_000;
/** The maximum number of corners of a still model, which take some 30 ms; larger meshes are sampled evenly. */
const MOST_STILL_CORNERS = 450_000;
/** Meshes with fewer corners are never sampled. */
const FEW_CORNERS = 3_000;

/**
 * The parts of a model that cast shadows, as vertical segments: x, z, and the heights of bottom and top for each. They follow the edges of
 * triangles, since no triangle's shadow extends beyond that of its edges. Hidden and see-through parts cast none.
 *
 * @param root the model in the world, with a radius of 1 around the origin
 * @param motion of the model, all of whose poses count
 */
export function castersOf(root: Object3D, motion?: Motion): Float32Array {
  const pieces = new UprightPieces();
  root.updateWorldMatrix(true, true);
  const casting = drawnMeshes(root);
  const corners = casting.reduce((sum, mesh) => sum + cornersOf(mesh), 0);
  if (!motion) {
    const step = Math.ceil(corners / MOST_STILL_CORNERS);
    for (const mesh of casting) addEdges(mesh, cornersOf(mesh) < FEW_CORNERS ? 1 : step, pieces);
    return pieces.take();
  }
  const poses = motion.duration > 0 ? MathUtils.clamp(Math.floor(MOST_CORNERS / corners), 1, MOST_POSES) : 1;
  const step = Math.ceil((corners * poses) / MOST_CORNERS);
  const { time } = motion;
  for (let pose = 0; pose < poses; pose++) {
    if (poses > 1) motion.time = (pose / poses) * motion.duration;
    root.updateWorldMatrix(true, true);
    for (const mesh of casting) addEdges(mesh, step, pieces);
  }
  motion.time = time;
  root.updateWorldMatrix(true, true);
  return pieces.take();
}

const cornersOf = (mesh: Mesh): number => rangesOf(mesh, isSolid).reduce((sum, { count }) => sum + count, 0);

const ends = [new Vector3(), new Vector3(), new Vector3()];
const place = new Vector3();

/** Adds the edges of every `step`th triangle, in the present pose. */
function addEdges(mesh: Mesh, step: number, pieces: UprightPieces): void {
  const { index } = mesh.geometry;
  const ranges = rangesOf(mesh, isSolid);
  for (const matrix of placements(mesh)) {
    for (const { start, count } of ranges) {
      for (let first = start; first + 2 < start + count; first += 3 * step) {
        for (let i = 0; i < 3; i++) {
          const corner = first + i;
          mesh.getVertexPosition(index ? index.getX(corner) : corner, ends[i]).applyMatrix4(matrix);
        }
        addTriangle(ends[0], ends[1], ends[2], pieces);
      }
    }
  }
}

function addTriangle(a: Vector3, b: Vector3, c: Vector3, pieces: UprightPieces): void {
  if (Math.max(a.distanceToSquared(b), b.distanceToSquared(c), c.distanceToSquared(a)) < LONGEST ** 2) {
    place.addVectors(a, b).add(c).divideScalar(3);
    pieces.add(place, Math.min(a.y, b.y, c.y), Math.max(a.y, b.y, c.y));
    return;
  }
  addEdge(a, b, pieces);
  addEdge(b, c, pieces);
  addEdge(c, a, pieces);
}

function addEdge(from: Vector3, to: Vector3, pieces: UprightPieces): void {
  const parts = Math.ceil(from.distanceTo(to) / LONGEST);
  // A mesh with NaN coordinates is not drawn.
  if (!(parts < Infinity)) return;
  if (parts <= 1) pieces.add(from, from.y, to.y);
  const rise = (to.y - from.y) / parts;
  for (let i = 0; parts > 1 && i < parts; i++)
    pieces.add(place.lerpVectors(from, to, (i + 0.5) / parts), from.y + i * rise, from.y + (i + 1) * rise);
}

/** The height range that a model fills in each column of a grid. */
class UprightPieces {
  private readonly lows = new Float32Array(CELLS ** 3).fill(Infinity);
  private readonly highs = new Float32Array(CELLS ** 3).fill(-Infinity);

  /** Adds a point that represents the height range at its place. */
  add({ x, y, z }: Vector3, one: number, other: number): void {
    const { lows, highs } = this;
    const cell = (cellOf(x) * CELLS + cellOf(z)) * CELLS + cellOf(y);
    lows[cell] = Math.min(lows[cell], one, other);
    highs[cell] = Math.max(highs[cell], one, other);
  }

  /** The vertical segments, with touching ones merged. */
  take(): Float32Array {
    const { lows, highs } = this;
    const pieces: number[] = [];
    for (let cell = 0; cell < lows.length; cell++) {
      if (lows[cell] === Infinity) continue;
      const column = Math.floor(cell / CELLS);
      let [low, high] = [lows[cell], highs[cell]];
      while ((cell + 1) % CELLS > 0 && lows[cell + 1] < Infinity) {
        cell++;
        low = Math.min(low, lows[cell]);
        high = Math.max(high, highs[cell]);
      }
      pieces.push(middleOf(Math.floor(column / CELLS)), middleOf(column % CELLS), low, high);
    }
    return Float32Array.from(pieces);
  }
}

const cellOf = (place: number): number => MathUtils.clamp(Math.floor(place / CELL + CELLS / 2), 0, CELLS - 1);

const middleOf = (cell: number): number => (cell + 0.5 - CELLS / 2) * CELL;

/** The maximum reach of shadows, in radii of the model; those of a low light would be endless. */
const REACH = 12;

/**
 * The shadows of points on level ground. Points at or above a lamp's height cast none.
 *
 * @param points xyz of each point
 * @param light the position of a lamp, or the direction to a sun
 * @param isSun whether the light is directional
 * @param height of the ground
 * @returns xyz of each shadow
 */
export function shadowOnGround(points: ArrayLike<number>, light: Vector3, isSun: boolean, height: number): number[] {
  const shadow: number[] = [];
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    // From the light to the point.
    const [dx, dy, dz] = isSun ? [-light.x, -light.y, -light.z] : [x - light.x, y - light.y, z - light.z];
    if (dy >= 0) continue;
    const steps = Math.min((height - y) / dy, REACH / Math.hypot(dx, dz));
    shadow.push(x + steps * dx, height, z + steps * dz);
  }
  return shadow;
}

/** A shadow ends at this share of the way from the middle of the sheet to its edges. */
const END = 0.99;
/**
 * A shadow fades early if its length, relative to the distance from its caster's foot to END, exceeds NEARS_END: each remaining part of
 * that distance then counts LEFT_COUNTS times. A shadow framed along with its model hardly fades early.
 */
const NEARS_END = 0.7;
const LEFT_COUNTS = 20;
/** Where the model itself comes this near to the edge, and then is cut by it, the shadow is cut by the edge instead of faded. */
const MODEL_NEARS = { from: 0.95, to: 1 } as const;
/** The fastest fading, which leaves some shadow where a model touches the ground. */
const MOST_FADE = 50;
/** The directions of the sheet's edges from its middle. */
const EDGES = [
  { right: 1, up: 0 },
  { right: -1, up: 0 },
  { right: 0, up: 1 },
  { right: 0, up: -1 },
] as const;

/** A light that casts a shadow on the ground. */
export interface GroundLight {
  /** The position of a lamp, or the direction to a sun. */
  position: Vector3;
  isSun: boolean;
  /** The width that the shadow camera sees at a place, in which fading is measured. */
  widthAt(place: Vector3): number;
}

/** The part of the picture that counts as the sheet, around its middle, in shares of width and height. */
export type SheetPart = readonly [number, number];

/** The whole picture as the sheet. */
export const WHOLE_SHEET: SheetPart = [1, 1];

/** From world to sheet coordinates, where points on the sheet have |x| and |y| ≤ w. */
const toSheet = new Matrix4();
const lightOnSheet = new Vector4();
const upOnSheet = new Vector4();
const low = new Vector4();
const high = new Vector4();
const foot = new Vector4();
const growth = new Vector4();
const caster = new Vector3();
const cast = new Vector3();
/** For each edge: the error of casters' positions, measured towards it in w. */
const errors = [0, 0, 0, 0];
/** For each edge: how near the model comes to it, and the fading it requires. */
const nearness = [0, 0, 0, 0];
const fades = [0, 0, 0, 0];

/**
 * The `shadowFade` at which a shadow on level ground ends before the edges of the sheet; 0 if it lies within them. Allocates nothing.
 *
 * The shadow of a point is its perspective projection from the light onto the ground. In homogeneous coordinates of the sheet it moves
 * along a straight line as the point rises, so that it meets each edge at one height.
 *
 * @param casters from `castersOf`
 * @param ground height of the ground
 */
export function fadeOnSheet(
  casters: ArrayLike<number>,
  ground: number,
  light: GroundLight,
  camera: PerspectiveCamera | OrthographicCamera,
  part: SheetPart,
): number {
  const { position, isSun } = light;
  const above = isSun ? position.y : position.y - ground;
  if (above <= 0) return 0;
  setSheet(camera, part);
  lightOnSheet.set(position.x, position.y, position.z, isSun ? 0 : 1).applyMatrix4(toSheet);
  upOnSheet.set(0, 1, 0, 0).applyMatrix4(toSheet);
  growth.copy(upOnSheet).multiplyScalar(above).sub(lightOnSheet);
  for (let edge = 0; edge < EDGES.length; edge++) errors[edge] = CASTER_ERROR * steepness(EDGES[edge]);
  nearness.fill(0);
  fades.fill(0);
  for (let i = 0; i + 3 < casters.length; i += 4) {
    const lowest = Math.max(casters[i + 2] - ground, 0);
    const highest = casters[i + 3] - ground;
    foot.set(casters[i], ground, casters[i + 1], 1).applyMatrix4(toSheet);
    low.copy(foot).addScaledVector(upOnSheet, lowest);
    high.copy(foot).addScaledVector(upOnSheet, highest);
    foot.multiplyScalar(above);
    // The range of heights whose shadows fall on the sheet.
    let from = 0;
    let to = Infinity;
    let met = 0;
    let nearing = 0;
    for (let edge = 0; edge < EDGES.length; edge++) {
      const { right, up } = EDGES[edge];
      nearness[edge] = Math.max(nearness[edge], shareTo(low, right, up), shareTo(high, right, up));
      const left = END * foot.w - right * foot.x - up * foot.y;
      const approach = right * growth.x + up * growth.y - END * growth.w;
      if (approach < 0) from = Math.max(from, left / approach);
      else if (left < approach * to) {
        to = left / approach;
        met = edge;
        nearing = approach;
      }
    }
    if (from > to || to >= (isSun ? Infinity : above)) continue;
    const sooner = (errors[met] * (isSun ? above : above - to)) / nearing;
    const height = Math.max(to - sooner, lowest);
    const length = Math.min(highest / Math.max(height, Number.EPSILON), 1);
    if (length < NEARS_END) continue;
    const share = MathUtils.smoothstep(length, NEARS_END, 1) / (1 + LEFT_COUNTS * (1 - length));
    caster.set(casters[i], ground + height, casters[i + 1]);
    const far = Math.max(castFar(ground, light, above), Number.EPSILON);
    fades[met] = Math.max(fades[met], Math.min((share * light.widthAt(cast)) / far, MOST_FADE));
  }
  let fade = 0;
  for (let edge = 0; edge < EDGES.length; edge++) {
    const { from, to } = MODEL_NEARS;
    fade = Math.max(fade, fades[edge] * (1 - MathUtils.smoothstep(nearness[edge], from, to)));
  }
  return fade;
}

/** Without the view offset, so that all tiles of a picture have one shadow. */
function setSheet(camera: PerspectiveCamera | OrthographicCamera, [wide, high]: SheetPart): void {
  camera.updateWorldMatrix(true, false);
  if ('isPerspectiveCamera' in camera) {
    const { fov, aspect, zoom } = camera as PerspectiveCamera;
    const slope = Math.tan(MathUtils.degToRad(fov) / 2) / zoom;
    toSheet.set(1 / (slope * aspect * wide), 0, 0, 0, 0, 1 / (slope * high), 0, 0, 0, 0, 1, 0, 0, 0, -1, 0);
  } else {
    const { left, right, top, bottom, zoom } = camera as OrthographicCamera;
    const [x, y] = [(2 * zoom) / (right - left) / wide, (2 * zoom) / (top - bottom) / high];
    toSheet.set(x, 0, 0, (-x * (left + right)) / 2, 0, y, 0, (-y * (top + bottom)) / 2, 0, 0, 1, 0, 0, 0, 0, 1);
  }
  toSheet.multiply(camera.matrixWorldInverse);
}

/** How fast a ground point approaches an edge of the sheet, in w per unit of movement straight towards it. */
function steepness({ right, up }: (typeof EDGES)[number]): number {
  const { elements } = toSheet;
  const along = (column: number): number =>
    right * elements[column] + up * elements[column + 1] - END * elements[column + 3];
  return Math.hypot(along(0), along(8));
}

/** The position of a point between the middle of the sheet (0) and one of its edges (1). */
function shareTo({ x, y, w }: Vector4, right: number, up: number): number {
  return w > 0 ? (right * x + up * y) / w : Infinity;
}

/** Projects the caster to its shadow. @returns the distance between the two */
function castFar(ground: number, { position, isSun }: GroundLight, above: number): number {
  const height = caster.y - ground;
  if (isSun) cast.copy(position);
  else cast.subVectors(position, caster);
  const steps = height / (isSun ? above : above - height);
  cast.multiplyScalar(-steps).add(caster);
  return cast.distanceTo(caster);
}
