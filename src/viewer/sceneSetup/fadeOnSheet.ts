import { MathUtils, Matrix4, type OrthographicCamera, type PerspectiveCamera, Vector3, Vector4 } from 'three';
import { CASTER_ERROR } from './castersOf.js';

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
