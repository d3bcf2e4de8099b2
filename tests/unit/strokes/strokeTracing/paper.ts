import { type Random, random } from '../../../../src/strokes/random.js';

/** A stroke in pixels. */
export interface InkStroke {
  points: readonly (readonly [x: number, y: number])[];
  /** The width at each point. */
  widths: readonly number[];
  /** Whether its ends are cut straight instead of round. */
  isCut?: boolean;
}

/** The conditions under which a sheet of paper is photographed. */
export interface Photograph {
  width: number;
  height: number;
  /** The brightness of the paper at (x, y) ∈ [0, 1]². Default 235 all over. */
  light?: (x: number, y: number) => number;
  /** The share of the paper's brightness that ink takes away. Default 0.85. */
  depth?: number;
  /** The deviation of the blur, in pixels. Default 0. */
  blur?: number;
  /** The deviation of the noise, in steps of 255. Default 0. */
  noise?: number;
  seed?: number;
}

/** Draws strokes on paper as a camera sees them. It shares no code with the tracing. */
export function photograph(
  strokes: readonly InkStroke[],
  { width, height, light = () => 235, depth = 0.85, blur = 0, noise = 0, seed = 1 }: Photograph,
): { width: number; height: number; data: Uint8ClampedArray } {
  let ink: Float64Array = new Float64Array(width * height);
  for (const stroke of strokes) addInk(ink, width, height, stroke);
  if (blur > 0) ink = blurred(blurred(ink, width, height, blur, 1, width), height, width, blur, width, 1);
  const next = random(seed);
  const data = new Uint8ClampedArray(width * height);
  for (let i = 0; i < data.length; i++) {
    const paper = light((i % width) / width, Math.floor(i / width) / height);
    data[i] = paper * (1 - depth * ink[i]) + (noise > 0 ? noise * gaussian(next) : 0);
  }
  return { width, height, data };
}

function addInk(ink: Float64Array, width: number, height: number, { points, widths, isCut = false }: InkStroke): void {
  for (let k = 0; k < points.length - 1; k++) {
    const [ax, ay] = points[k];
    const [bx, by] = points[k + 1];
    const reach = 0.5 * Math.max(widths[k], widths[k + 1]) + 1;
    const squared = (bx - ax) ** 2 + (by - ay) ** 2 || 1;
    for (let y = Math.max(0, Math.floor(Math.min(ay, by) - reach)); y <= Math.max(ay, by) + reach && y < height; y++) {
      for (let x = Math.max(0, Math.floor(Math.min(ax, bx) - reach)); x <= Math.max(ax, bx) + reach && x < width; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const share = ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / squared;
        const along = Math.min(1, Math.max(0, share));
        const distance = Math.hypot(px - ax - along * (bx - ax), py - ay - along * (by - ay));
        const radius = 0.5 * (widths[k] + along * (widths[k + 1] - widths[k]));
        const beyond = Math.abs(share - along) * Math.sqrt(squared);
        const aside = Math.sqrt(Math.max(0, distance * distance - beyond * beyond));
        const inside = isCut ? Math.min(radius - aside, -beyond) : radius - distance;
        const covered = Math.min(1, 2 * radius, Math.max(0, inside + 0.5));
        ink[y * width + x] = Math.max(ink[y * width + x], covered);
      }
    }
  }
}

/** A Gaussian along one direction: `length` values `step` apart, in lines `stride` apart. */
function blurred(
  values: Float64Array,
  length: number,
  lines: number,
  deviation: number,
  step: number,
  stride: number,
): Float64Array {
  const reach = Math.ceil(3 * deviation);
  const result = new Float64Array(values.length);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-0.5 * ((i - reach) / deviation) ** 2));
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  for (let line = 0; line < lines; line++) {
    for (let i = 0; i < length; i++) {
      let sum = 0;
      for (let k = -reach; k <= reach; k++) {
        const at = Math.min(length - 1, Math.max(0, i + k));
        sum += weights[k + reach] * values[line * stride + at * step];
      }
      result[line * stride + i * step] = sum / total;
    }
  }
  return result;
}

export const gaussian = (next: Random): number => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());

/** A straight stroke of even width. */
export function straight(x: number, y: number, length: number, degrees: number, width: number): InkStroke {
  const angle = (degrees * Math.PI) / 180;
  const [dx, dy] = [0.5 * length * Math.cos(angle), 0.5 * length * Math.sin(angle)];
  return {
    points: [
      [x - dx, y - dy],
      [x + dx, y + dy],
    ],
    widths: [width, width],
  };
}
