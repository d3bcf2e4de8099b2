import { type Stroke, strokeOffset } from './Stroke.js';

/** Ink that is added while a stroke grows from its middle to its ends. */
const GROWTH = 0.2;

/** Beside its centre line a stroke counts over so many texels. No gap between strokes is wider at full density. */
const REACH = 8;

/** Beyond its ends a line counts until this multiple of its half length. */
const REACH_FORWARD = 1.4;

/**
 * Lowers a toroidal field to that of one stroke where it is lower.
 *
 * The field of a stroke is the ink at which it appears, plus a term that grows with the square of the distance from its
 * centre line and one with the fourth power of the distance from its middle. So {field < ink} is a hairline at first, that
 * grows longer and swells with the ink, with pointed ends and without a step anywhere.
 *
 * @param field (size·cellsPerTexel)² numbers in rows of growing v; changed in place
 * @param size texels per side, a power of two
 * @param cellsPerTexel cells of the field per texel and side, a power of two
 * @param birth the mean ink of the strokes so far, at which this one appears
 * @param swell how much ink later it has its width
 * @returns the number of cells visited
 */
export function drawThresholdField(
  field: Float32Array,
  size: number,
  cellsPerTexel: number,
  stroke: Stroke,
  birth: number,
  swell: number,
): number {
  const cells = size * cellsPerTexel;
  const mask = cells - 1;
  // "Forward" is the axis the stroke runs along, "sideways" the other one.
  const forwardStride = stroke.across ? cells : 1;
  const sidewaysStride = stroke.across ? 1 : cells;
  const centre = (stroke.across ? stroke.v : stroke.u) * size;
  const base = (stroke.across ? stroke.u : stroke.v) * size;
  const halfLength = 0.5 * stroke.length * size;
  const isDot = halfLength === 0;
  const sidewaysScale = (4 * swell) / (stroke.width * stroke.width);
  const reachForward = isDot ? REACH : REACH_FORWARD * halfLength;
  const first = Math.ceil((centre - reachForward) * cellsPerTexel - 0.5);
  const last = Math.floor((centre + reachForward) * cellsPerTexel - 0.5);
  let visited = 0;
  for (let column = first; column <= last; column++) {
    const forward = (column + 0.5) / cellsPerTexel - centre;
    const x = isDot ? 0 : forward / halfLength;
    const middle = isDot ? base : base + size * strokeOffset(stroke, x);
    const onCentreLine = birth + (isDot ? forward * forward * sidewaysScale : GROWTH * x * x * x * x);
    const start = (column & mask) * forwardStride;
    const firstRow = Math.ceil((middle - REACH) * cellsPerTexel - 0.5);
    const lastRow = Math.floor((middle + REACH) * cellsPerTexel - 0.5);
    for (let row = firstRow; row <= lastRow; row++) {
      const sideways = (row + 0.5) / cellsPerTexel - middle;
      const value = onCentreLine + sideways * sideways * sidewaysScale;
      const cell = start + (row & mask) * sidewaysStride;
      if (value < field[cell]) field[cell] = value;
    }
    visited += lastRow - firstRow + 1;
  }
  return visited;
}
