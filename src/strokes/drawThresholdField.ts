import { type Stroke, strokeOffset } from './Stroke.js';
import { profileAt } from './StrokeProfile.js';

/** Mean ink added to the image while a stroke grows from its middle to its ends. */
const GROWTH = 0.2;

/** The same for a stroke of a hand, which has its full length from the start except for its thin tapers. */
const EVEN_GROWTH = 0.05;
/** The same beyond its ends, where it grows until all is ink. */
const GROWTH_BEYOND = 1;
/** Bounds of the relative width of a stroke of a hand in its swelling. */
const [THINNEST, THICKEST] = [0.5, 1.5];

/** Texels on each side of its centre line that a stroke reaches. At full density no gap is wider. */
const REACH = 8;

/** A line reaches this multiple of its half length, measured from its middle. */
const REACH_FORWARD = 1.4;

/**
 * Lowers a toroidal field to the field of a stroke, wherever the latter is lower.
 *
 * The field of a stroke is the ink at which it appears, plus a term that grows with the square of the distance from its
 * centre line, plus one that grows with the fourth power of the distance from its middle. So {field < ink} begins as a
 * hairline. As ink rises, it grows longer and swells, with pointed ends and without steps.
 *
 * @param field (size·cellsPerTexel)² numbers in rows of growing v; changed in place
 * @param size texels per side, a power of two
 * @param cellsPerTexel cells of the field per texel and side, a power of two
 * @param startInk the mean ink at which the stroke appears, which is that of all strokes before it
 * @param swell the further ink after which the stroke has its full width
 * @returns the number of cells visited
 */
export function drawThresholdField(
  field: Float32Array,
  size: number,
  cellsPerTexel: number,
  stroke: Stroke,
  startInk: number,
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
  const { profile } = stroke;
  const cosine2 = 1 / (1 + stroke.slope * stroke.slope);
  const sidewaysScale = (4 * swell) / (stroke.width * stroke.width);
  const reachForward = isDot ? REACH : REACH_FORWARD * halfLength;
  const first = Math.ceil((centre - reachForward) * cellsPerTexel - 0.5);
  const last = Math.floor((centre + reachForward) * cellsPerTexel - 0.5);
  let visited = 0;
  for (let column = first; column <= last; column++) {
    const forward = (column + 0.5) / cellsPerTexel - centre;
    const x = isDot ? 0 : forward / halfLength;
    const middle = isDot ? base : base + size * strokeOffset(stroke, x);
    let onCentreLine = startInk + (isDot ? forward * forward * sidewaysScale : GROWTH * x * x * x * x);
    let scale = sidewaysScale;
    if (profile) {
      const width = Math.max(THINNEST, Math.min(THICKEST, profileAt(profile.width, x)));
      scale *= cosine2 / (width * width);
      onCentreLine = startInk + growthAt(profileAt(profile.width, x), x);
    }
    const start = (column & mask) * forwardStride;
    const firstRow = Math.ceil((middle - REACH) * cellsPerTexel - 0.5);
    const lastRow = Math.floor((middle + REACH) * cellsPerTexel - 0.5);
    for (let row = firstRow; row <= lastRow; row++) {
      const sideways = (row + 0.5) / cellsPerTexel - middle;
      const value = onCentreLine + sideways * sideways * scale;
      const cell = start + (row & mask) * sidewaysStride;
      if (value < field[cell]) field[cell] = value;
    }
    visited += lastRow - firstRow + 1;
  }
  return visited;
}

/** The further ink after which a stroke of a hand reaches x along its centre line: thin parts appear later. */
function growthAt(width: number, x: number): number {
  const thin = Math.max(0, 1 - width);
  const beyond = Math.max(0, Math.abs(x) - 1);
  return EVEN_GROWTH * x * x * x * x + GROWTH * thin * thin + GROWTH_BEYOND * beyond;
}
