import { type Box3, type Camera, Matrix4, Vector4 } from 'three';
import type { ViewedCamera } from '../pictureOffset.js';

/** The nearest and the farthest depth, along the line of sight, that a camera sees. */
export interface SeenDepths {
  front: number;
  back: number;
}

/** The part of a box that a camera sees: its depths, and its bounds on the sheet, from −1 to 1. */
export interface SeenBox extends SeenDepths {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** Numbers per corner: x, y and w in clip space, and its depth. */
const NUMBERS_PER_CORNER = 4;
/** The greatest number of corners: a rectangle gains at most one with each of the five cuts. */
const MAX_CORNERS = 9;
/** The five clipping planes, as factors on the numbers of a corner; positive within the sheet. The last is that of the eye. */
const SHEET = [
  [1, 0, 1, 0],
  [-1, 0, 1, 0],
  [0, 1, 1, 0],
  [0, -1, 1, 0],
  [0, 0, 0, 1],
] as const;
/** The corners of the six faces of a box, each as three bits: x, y and z. */
const FACES = [
  [0, 2, 6, 4],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 3, 7, 6],
  [0, 1, 3, 2],
  [4, 5, 7, 6],
] as const;

const toView = /* @__PURE__ */ new Matrix4();
const corner = /* @__PURE__ */ new Vector4();
let polygon = /* @__PURE__ */ new Float64Array(NUMBERS_PER_CORNER * MAX_CORNERS);
let kept = /* @__PURE__ */ new Float64Array(NUMBERS_PER_CORNER * MAX_CORNERS);

/**
 * Finds the depths of the sides of a box and their bounds on the sheet, clipped to the sheet. If a picture is drawn in tiles, the sheet
 * is the whole picture. Allocates nothing.
 *
 * @param frame the matrix from the space of the box to world space
 * @returns whether any of the box is seen; if not, `target` is unchanged
 */
export function seenBox(box: Box3, frame: Matrix4, camera: Camera, target: SeenBox): boolean {
  toView.multiplyMatrices(camera.matrixWorldInverse, frame);
  let [front, left, bottom] = [Infinity, Infinity, Infinity];
  let [back, right, top] = [-Infinity, -Infinity, -Infinity];
  for (const face of FACES) {
    for (let i = 0; i < face.length; i++) writeCorner(box, face[i], camera, i);
    let count: number = face.length;
    for (const plane of SHEET) count = cut(count, plane);
    for (let i = 0; i < NUMBERS_PER_CORNER * count; i += NUMBERS_PER_CORNER) {
      const [x, y] = [polygon[i] / polygon[i + 2], polygon[i + 1] / polygon[i + 2]];
      front = Math.min(front, polygon[i + 3]);
      back = Math.max(back, polygon[i + 3]);
      left = Math.min(left, x);
      right = Math.max(right, x);
      bottom = Math.min(bottom, y);
      top = Math.max(top, y);
    }
  }
  if (!(back > 0 && back < Infinity)) return false;
  target.front = Math.max(front, 0);
  target.back = back;
  target.left = left;
  target.right = right;
  target.bottom = bottom;
  target.top = top;
  return true;
}

/** Writes a corner of a box, given by three bits, as corner `i` of the polygon. */
function writeCorner({ min, max }: Box3, bits: number, camera: Camera, i: number): void {
  corner.set(bits & 1 ? max.x : min.x, bits & 2 ? max.y : min.y, bits & 4 ? max.z : min.z, 1).applyMatrix4(toView);
  const depth = -corner.z;
  corner.applyMatrix4(camera.projectionMatrix);
  const { view } = camera as ViewedCamera;
  if (view?.enabled) {
    const { fullWidth, fullHeight, offsetX, offsetY, width, height } = view;
    corner.x = (corner.x * width + (2 * offsetX + width - fullWidth) * corner.w) / fullWidth;
    corner.y = (corner.y * height - (2 * offsetY + height - fullHeight) * corner.w) / fullHeight;
  }
  polygon[NUMBERS_PER_CORNER * i] = corner.x;
  polygon[NUMBERS_PER_CORNER * i + 1] = corner.y;
  polygon[NUMBERS_PER_CORNER * i + 2] = corner.w;
  polygon[NUMBERS_PER_CORNER * i + 3] = depth;
}

/** Cuts off the part of the polygon beyond a plane (Sutherland and Hodgman, 1974). @returns the number of corners that remain */
function cut(count: number, plane: (typeof SHEET)[number]): number {
  let left = 0;
  for (let i = 0; i < count; i++) {
    const next = (i + 1) % count;
    const [here, there] = [within(i, plane), within(next, plane)];
    if (here >= 0) copyBetween(i, i, 0, left++);
    if (here >= 0 !== there >= 0) copyBetween(i, next, here / (here - there), left++);
  }
  [polygon, kept] = [kept, polygon];
  return left;
}

function within(i: number, plane: (typeof SHEET)[number]): number {
  let sum = 0;
  for (let k = 0; k < NUMBERS_PER_CORNER; k++) sum += plane[k] * polygon[NUMBERS_PER_CORNER * i + k];
  return sum;
}

function copyBetween(from: number, to: number, share: number, target: number): void {
  for (let k = 0; k < NUMBERS_PER_CORNER; k++) {
    const [a, b] = [polygon[NUMBERS_PER_CORNER * from + k], polygon[NUMBERS_PER_CORNER * to + k]];
    kept[NUMBERS_PER_CORNER * target + k] = a + share * (b - a);
  }
}
