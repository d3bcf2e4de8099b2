import type { HandStroke, SwatchTone } from 'three-hatching';
import { type Random, random } from '../random.js';
import type { PenHabits } from './exampleHabits.js';

/** The side of a swatch, and the distance between two swatches, in millimetres. */
const SIDE = 15.5;
const STEP = 22;
const TONES: readonly SwatchTone[] = ['light', 'middle', 'dark'];
/** Millimetres between the points of a stroke, at most. */
const SPACING = 0.5;
/** The same for strokes with grain. */
const FINE_SPACING = 0.12;
/** The width of a stroke where the tool skips: nothing that is seen. */
const LEAST_WIDTH = 0.001;
/** The scale by which a logistic distribution is nearest to a normal one of deviation 1. */
const LOGISTIC = 1.702;
/** Strokes drawn to and fro before the pen is lifted. */
const ZIGZAG = 9;

/** Draws swatches of 15.5 mm in a row, light, middle and dark, with the given habits. */
export function drawSwatches(habits: PenHabits, seed: number): HandStroke[] {
  return TONES.flatMap((tone, i) => drawSwatch(habits, tone, [STEP * (i + 0.5), 0.5 * STEP], seed * TONES.length + i));
}

function drawSwatch(
  habits: PenHabits,
  swatch: SwatchTone,
  middle: readonly [number, number],
  seed: number,
): HandStroke[] {
  const next = random(seed);
  const { crossing } = habits;
  const angles = [habits.angle];
  if (crossing && TONES.indexOf(swatch) >= TONES.indexOf(crossing.from)) angles.push(habits.angle + crossing.angle);
  return angles.flatMap((angle) => drawLayer(habits, swatch, angle, middle, next));
}

/** The start of a stroke: x along the layer, y across it, from the middle of the swatch. */
interface Place {
  x: number;
  y: number;
  /** The index of its row. */
  row: number;
}

function drawLayer(
  habits: PenHabits,
  swatch: SwatchTone,
  angle: number,
  middle: readonly [number, number],
  next: Random,
): HandStroke[] {
  const turn = (angle * Math.PI) / 180;
  const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
  const strokes: HandStroke[] = [];
  let pen: { points: number[]; widths: number[]; count: number; row: number } | undefined;
  const lift = (): void => {
    if (!pen) return;
    const { points, widths } = habits.isZigzag ? rounded(rounded(pen)) : pen;
    strokes.push({ points: points.map(thousandths), widths: widths.map(thousandths), swatch });
    pen = undefined;
  };
  for (const [i, { x, y, row }] of placesOf(habits, habits.spacing[swatch], next).entries()) {
    for (const line of strandsOf(habits, drawStroke(habits, i, next), next)) {
      const points = line.map(([along, across]) => {
        const [u, v] = [x + along, y + across];
        return [middle[0] + u * cosine - v * sine, middle[1] + u * sine + v * cosine] as const;
      });
      if (pen && (!habits.isZigzag || pen.row !== row || pen.count >= ZIGZAG)) lift();
      pen ??= { points: [], widths: [], count: 0, row };
      pen.points.push(...points.flat());
      pen.widths.push(...line.map(([, , width]) => width));
      pen.count++;
    }
  }
  lift();
  return strokes;
}

/** Rounds the turns of a zigzag by cutting its corners (Chaikin 1974). */
function rounded({ points, widths }: { points: number[]; widths: number[] }): { points: number[]; widths: number[] } {
  const last = widths.length - 1;
  const cut: { points: number[]; widths: number[] } = { points: points.slice(0, 2), widths: [widths[0]] };
  for (let i = 0; i < last; i++) {
    for (const share of [0.25, 0.75]) {
      const at = (values: readonly number[], from: number, to: number): number =>
        values[from] + share * (values[to] - values[from]);
      cut.points.push(at(points, 2 * i, 2 * i + 2), at(points, 2 * i + 1, 2 * i + 3));
      cut.widths.push(at(widths, i, i + 1));
    }
  }
  cut.points.push(...points.slice(2 * last));
  cut.widths.push(widths[last]);
  return cut;
}

/** Rows of strokes side by side. */
function placesOf(habits: PenHabits, spacing: number, next: Random): Place[] {
  const { length, overlap, spacingSpread, bundle, bundleGap, raggedness } = habits;
  const reach = 0.5 * SIDE;
  const step = length * (1 - overlap);
  const rows = Math.max(1, Math.round(SIDE / step));
  const places: Place[] = [];
  for (let row = 0; row < rows; row++) {
    const x = (row - 0.5 * (rows - 1)) * step;
    let inBundle = Math.floor(bundle * next());
    for (let y = -reach + spacing * next(); y < reach; ) {
      places.push({ x: x + raggedness * length * gaussian(next), y, row });
      y += spacing * Math.max(0.25, 1 + spacingSpread * gaussian(next));
      if (bundle > 1 && ++inBundle >= bundle) {
        inBundle = Math.floor(0.4 * bundle * next());
        y += bundleGap * spacing;
      }
    }
  }
  return places;
}

/** A point of a stroke. */
type PenPoint = [along: number, across: number, width: number];

/** The points of one stroke along x, with its middle at 0. */
function drawStroke(habits: PenHabits, index: number, next: Random): PenPoint[] {
  const length = habits.length * Math.max(0.4, 1 + habits.lengthSpread * gaussian(next));
  const turn = (habits.angleSpread * gaussian(next) * Math.PI) / 180;
  const height = length * (habits.curvature + habits.curvatureSpread * gaussian(next));
  const width = habits.width * Math.max(0.4, 1 + 0.7 * habits.pressure * gaussian(next));
  const stray = strayOf(length, habits.wobbleLength, next);
  const swell = strayOf(length, 0.4 * habits.length, next);
  const hooked = habits.hooks ? length * Math.max(0, 1 + 0.4 * gaussian(next)) : 0;
  const count = Math.max(5, Math.ceil(length / (habits.grain ? FINE_SPACING : SPACING)) + 1);
  const line = Array.from({ length: count }, (_, i): PenPoint => {
    const place = i / (count - 1);
    const along = (place - 0.5) * length;
    const across = height * (1 - (2 * place - 1) ** 2) + habits.wobble * stray(place) + hooked * hookAt(habits, place);
    const pressed = Math.max(0.3, 1 + 0.7 * habits.pressure * swell(place)) * pressedAt(habits, place);
    return [
      along * Math.cos(turn) - across * Math.sin(turn),
      along * Math.sin(turn) + across * Math.cos(turn),
      width * pressed * taperAt(habits, place),
    ];
  });
  return habits.isZigzag && index % 2 === 1 ? line.reverse() : line;
}

/** How far a place of a stroke lies aside by the hooks of its ends, in lengths: parabolas that turn to the angle of the hook. */
function hookAt({ hooks }: PenHabits, place: number): number {
  if (!hooks) return 0;
  const aside = (way: number, degrees: number): number =>
    0.5 * hooks.share * Math.max(0, 1 - way / hooks.share) ** 2 * Math.tan((degrees * Math.PI) / 180);
  return aside(place, hooks.start) + aside(1 - place, hooks.end);
}

/** The pressure at a place of a stroke, by cubic interpolation (Catmull and Rom 1974). */
function pressedAt({ pressed }: PenHabits, place: number): number {
  if (!pressed) return 1;
  const last = pressed.length - 1;
  const at = place * last;
  const i = Math.min(last - 1, Math.floor(at));
  const t = at - i;
  const [before, from, to, after] = [-1, 0, 1, 2].map((k) => pressed[Math.max(0, Math.min(last, i + k))]);
  const [a, b] = [0.5 * (to - before), 0.5 * (after - from)];
  return from + t * (a + t * (3 * (to - from) - 2 * a - b + t * (2 * (from - to) + a + b)));
}

/** The lines that a stroke leaves: itself, or one for each strand, by the grain of the paper and with what was skipped. */
function strandsOf(habits: PenHabits, line: PenPoint[], next: Random): PenPoint[][] {
  const { count, breadth } = habits.strands ?? { count: 1, breadth: 0 };
  return Array.from({ length: count }, (_, strand) => {
    const aside = count > 1 ? breadth * (strand / (count - 1) - 0.5) + (0.25 * breadth * gaussian(next)) / count : 0;
    return onPaper(
      habits,
      line.map(([along, across, width]) => [along, across + aside, width]),
      next,
    );
  });
}

/** A line as a rough sheet takes it: its width trembles, and it lacks where the tool skips. */
function onPaper({ length, grain, skips }: PenHabits, line: PenPoint[], next: Random): PenPoint[] {
  if (!grain) return line;
  const rough = strayOf(length, grain.length, next);
  const touch = skips && strayOf(length, skips.length, next);
  return line.map(([along, across, width], i) => {
    const place = i / (line.length - 1);
    const touched = width * Math.max(0.25, 1 + grain.depth * rough(place));
    if (!skips || !touch) return [along, across, touched];
    const missing = Math.max(0, skips.share[0] + place * (skips.share[1] - skips.share[0]));
    // Below this value lie as many of the deviates, by the logistic distribution.
    const level = Math.log(missing / (1 - missing)) / LOGISTIC;
    // A skip begins and ends in a point.
    const share = Math.max(0, Math.min(1, 3 * (touch(place) - level)));
    return [along, across, Math.max(LEAST_WIDTH, share * touched)];
  });
}

/** The width at a place of a stroke, as a share of its full width. */
function taperAt({ taperStart, taperEnd, tips }: PenHabits, place: number): number {
  const from = taperStart > 0 ? Math.min(1, place / taperStart) : 1;
  const to = taperEnd > 0 ? Math.min(1, (1 - place) / taperEnd) : 1;
  return (tips[0] + (1 - tips[0]) * from) * (tips[1] + (1 - tips[1]) * to);
}

/** A smooth random function around 0, with a deviation of 1, that crosses zero about every `wave` of the length. */
function strayOf(length: number, wave: number, next: Random): (place: number) => number {
  const knots = Math.max(2, Math.round(length / wave) + 1);
  const values = Array.from({ length: knots + 3 }, () => gaussian(next));
  return (place) => {
    const at = place * (knots - 1);
    const i = Math.min(knots - 2, Math.floor(at));
    const t = at - i;
    // A uniform cubic B-spline; its mean square is 0.48 of that of its knots.
    const weights = [(1 - t) ** 3, 3 * t ** 3 - 6 * t * t + 4, -3 * t ** 3 + 3 * t * t + 3 * t + 1, t ** 3];
    return weights.reduce((sum, weight, k) => sum + (weight / 6) * values[i + k], 0) / Math.sqrt(0.48);
  };
}

const gaussian = (next: Random): number => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());

/** Rounds to thousandths. Adding 0 turns −0 into 0, as JSON does. */
const thousandths = (value: number): number => Math.round(1000 * value) / 1000 + 0;
