import type { HandStroke, SwatchTone } from '../../../../src/strokes/hand/Hand.js';
import { random } from '../../../../src/strokes/random.js';

/** What a swatch is drawn with. Lengths are in millimetres, angles in degrees. */
export interface SwatchDrawing {
  seed: number;
  rows: number;
  columns: number;
  length: number;
  lengthSpread: number;
  angle: number;
  angleSpread: number;
  curvature: number;
  taperStart: number;
  taperEnd: number;
  width: number;
  widthSpread: number;
  wobble: number;
  spacing: number;
  spacingSpread: number;
  overlap: number;
  /** Strokes per bundle; between bundles the gap is `bundleGap` times the distance in them. */
  bundle: number;
  bundleGap: number;
  swatch: SwatchTone;
}

export const DRAWING: SwatchDrawing = {
  seed: 1,
  rows: 24,
  columns: 1,
  length: 12,
  lengthSpread: 0,
  angle: 0,
  angleSpread: 0,
  curvature: 0,
  taperStart: 0,
  taperEnd: 0,
  width: 0.4,
  widthSpread: 0,
  wobble: 0,
  spacing: 1.2,
  spacingSpread: 0,
  overlap: 0,
  bundle: 1,
  bundleGap: 1,
  swatch: 'middle',
};

/** A random number of the standard normal distribution. */
function normal(next: () => number): number {
  return Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
}

/** Draws strokes of known numbers: rows of them, one below the other. */
export function drawSwatch(drawing: Partial<SwatchDrawing>): HandStroke[] {
  const d = { ...DRAWING, ...drawing };
  const next = random(d.seed);
  const strokes: HandStroke[] = [];
  const turn = (d.angle * Math.PI) / 180;
  let across = 0;
  for (let row = 0; row < d.rows; row++) {
    for (let column = 0; column < d.columns; column++) {
      const length = d.length * (1 + d.lengthSpread * normal(next));
      const along = column * d.length * (1 - d.overlap);
      strokes.push(drawStroke(d, next, length, along, across, turn));
    }
    const inBundle = (row + 1) % d.bundle !== 0;
    across += d.spacing * (inBundle ? 1 : d.bundleGap) * Math.max(0.05, 1 + d.spacingSpread * normal(next));
  }
  return strokes;
}

function drawStroke(
  d: SwatchDrawing,
  next: () => number,
  length: number,
  along: number,
  across: number,
  turn: number,
): HandStroke {
  const count = 90;
  const tilt = (d.angleSpread * Math.PI * normal(next)) / 180;
  const phase = 2 * Math.PI * next();
  const waves = 5 + 3 * next();
  const heavy = 1 + d.widthSpread * normal(next);
  // A parabola of this height over its chord is longer than the chord by 8/3 of the height's square.
  const chord = length / (1 + (8 / 3) * d.curvature ** 2);
  const points: number[] = [];
  const widths: number[] = [];
  for (let i = 0; i < count; i++) {
    const share = i / (count - 1);
    const s = 2 * share - 1;
    const x = 0.5 * chord * s;
    const y = d.curvature * chord * (1 - s * s) + d.wobble * Math.SQRT2 * Math.sin(phase + 2 * Math.PI * waves * share);
    const [dx, dy] = [x * Math.cos(tilt) - y * Math.sin(tilt), x * Math.sin(tilt) + y * Math.cos(tilt)];
    const [px, py] = [50 + along + dx, 20 + across + dy];
    points.push(px * Math.cos(turn) - py * Math.sin(turn), px * Math.sin(turn) + py * Math.cos(turn));
    const start = d.taperStart > 0 ? Math.min(1, share / d.taperStart) : 1;
    const end = d.taperEnd > 0 ? Math.min(1, (1 - share) / d.taperEnd) : 1;
    widths.push(Math.max(0.02, d.width * heavy * Math.min(start, end)));
  }
  return { points, widths, swatch: d.swatch };
}
