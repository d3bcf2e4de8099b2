import { asPhase } from '../../mesh/phases.js';
import { blurToroidal } from '../blurToroidal.js';
import { paperGrain } from '../paperGrain.js';
import { placeStrokes } from '../placeStrokes.js';
import { equalize } from '../ranking.js';
import { rasterizeStroke } from '../rasterizeStroke.js';
import { profileAt, type Stroke, strokeOffset } from '../Stroke.js';
import { type HatchImageRequest, type MapRequest, resolveHatchImageOptions } from './generateHatchImages.js';
import { encodeThresholds, type ThresholdLevel } from './thresholds.js';

/** The number of steps of tone in which strokes are placed, enough for an even image at any tone in between. */
const STEPS = 24;

/** Cells of the field per texel and side. */
const CELLS_PER_TEXEL = 2;

/** The value of the field beyond the reach of strokes, above any ink. */
const UNREACHED = 1e6;

/** The weights of four cells in a row, the inner two of which lie in the texel. */
const TENT = [0.125, 0.375, 0.375, 0.125] as const;

/** Cells visited between two yields, in about a millisecond. */
const WORK_PER_SLICE = 300_000;

/** The mean threshold is the same in every neighbourhood of this radius in texels, which holds several strokes side by side. */
const NEIGHBOURHOOD = 16;

/** The progress after the placement of strokes. */
const PLACED = 0.8;

/**
 * Draws the thresholds of a tonal art map: for each level an image of the tones at which its texels become ink. For every tone,
 * {threshold < tone} is an image of exactly that mean ink. As the tone rises, strokes appear between those already there, grow
 * longer and swell, until only thin lines of paper remain, which close at last.
 *
 * Thresholds are the method of Webb et al. 2002. Here they are drawn with distance profiles instead of steps, so that they can be
 * interpolated, and equalised, so that coverage equals tone. Texel [i][j] equals texel [size−1−i][size−1−j], so a stroke direction
 * and its opposite draw the same. A level has the strokes of the next coarser level, and new ones between them.
 *
 * @throws RangeError if an option is out of its range, at the first step. `tones` is ignored.
 * @returns the levels, finest first; yields progress in [0, 1]
 */
export function* generateThresholds(options: MapRequest = {}): Generator<number, ThresholdLevel[], void> {
  const request = resolveHatchImageOptions(options);
  const { maxInk, proposals } = request.style.thresholds;
  const layers = request.style.layers.map((layer) => ({ ...layer, from: layer.thresholdsFrom }));
  // Strokes are placed without grain, which is added to the thresholds afterwards.
  const style = { ...request.style, maxInk, layers, proposals, grain: undefined };
  const placing = placeStrokes({ ...request, style, tones: STEPS + 1, pairs: true });
  const strokes = yield* asPhase(placing, 0, PLACED);
  const levels: ThresholdLevel[] = [];
  for (let level = 0; level < request.levels; level++) {
    levels.push(yield* drawLevel(strokes, level, request));
  }
  return levels;
}

/** Draws the thresholds of one level. It draws one stroke of each pair into the field; the other follows by symmetry. */
function* drawLevel(
  strokes: Stroke[],
  level: number,
  request: HatchImageRequest,
): Generator<number, ThresholdLevel, void> {
  const size = request.size >> level;
  const { swell } = request.style.thresholds;
  const progress = PLACED + (1 - PLACED) * (1 - 1 / 4 ** (level + 1));
  const image = new Uint8Array(size * size).fill(255);
  const cells = size * CELLS_PER_TEXEL;
  const fields = request.style.layers.map(() => new Float32Array(cells * cells).fill(UNREACHED));
  let darkness = 0;
  let work = 0;
  for (let i = 0; i < strokes.length; i += 2) {
    const stroke = strokes[i];
    if (stroke.level < level) continue;
    darkness += rasterizeStroke(image, size, stroke) + rasterizeStroke(image, size, strokes[i + 1]);
    const field = fields[stroke.layer];
    work += drawThresholdField(field, size, CELLS_PER_TEXEL, stroke, darkness / (255 * size * size), swell);
    if (work >= WORK_PER_SLICE) {
      work = 0;
      yield progress;
    }
  }
  const half = averageHalf(fields[0], size);
  yield progress;
  for (const field of fields.slice(1)) {
    // Each layer is averaged by itself; otherwise there would be bumps where strokes of two layers cross.
    const across = averageHalf(field, size);
    for (let i = 0; i < half.length; i++) half[i] = Math.min(half[i], across[i]);
    yield progress;
  }
  const grain = paperGrain(request, level, request.style.grain?.streak);
  if (grain) {
    const roughness = request.style.grain!.roughness;
    // The values stay positive, as `equalize` requires; only their order matters.
    for (let i = 0; i < half.length; i++) half[i] += (roughness * grain.depths[i]) / 255;
  }
  const uneven = withHalfTurn(equalize(half));
  yield progress;
  // Places with denser strokes would be darker at every tone, which shows in repeated tiles.
  const local = blurToroidal(uneven, size, NEIGHBOURHOOD);
  yield progress;
  for (let i = 0; i < half.length; i++) half[i] = uneven[i] + 1 - local[i];
  const thresholds = withHalfTurn(equalize(half));
  yield progress;
  return encodeThresholds(size, thresholds);
}

/** Completes a field from its first half. The second half is the same after a half turn. */
function withHalfTurn(half: Float32Array): Float32Array {
  const whole = new Float32Array(2 * half.length);
  whole.set(half);
  for (let i = 0; i < half.length; i++) whole[whole.length - 1 - i] = half[i];
  return whole;
}

/**
 * Takes the lower of the field and its half turn, and filters it down to texels, for the first half of the rows. The filter reaches
 * half a texel beyond the texel on every side, because a narrower filter would break strokes up along their length.
 */
function averageHalf(field: Float32Array, size: number): Float32Array {
  const cells = size * CELLS_PER_TEXEL;
  const mask = cells - 1;
  const last = field.length - 1;
  const half = new Float32Array((size * size) / 2);
  for (let texel = 0; texel < half.length; texel++) {
    const firstRow = Math.floor(texel / size) * CELLS_PER_TEXEL - 1;
    const firstColumn = (texel % size) * CELLS_PER_TEXEL - 1;
    let sum = 0;
    for (let row = 0; row < 4; row++) {
      for (let column = 0; column < 4; column++) {
        const cell = ((firstRow + row) & mask) * cells + ((firstColumn + column) & mask);
        sum += TENT[row] * TENT[column] * Math.min(field[cell], field[last - cell]);
      }
    }
    half[texel] = sum;
  }
  return half;
}

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
