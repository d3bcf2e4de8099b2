import { STEP } from './LineGrower.js';
import type { LineLaws } from './LineLaws.js';
import { LinePoints, UNNUMBERED } from './LinePoints.js';
import { leastLength } from './placeLines.js';

const ROUNDS = 10;
/** The share of the way to the middle between its neighbours that a point goes in a round, also of a line that is carried from frame to frame; and the farthest, in distances between lines. */
const SHARE = 0.5;
const CARRIED_SHARE = 0.05;
const FARTHEST = 0.5;
/** Neighbours lie no farther than this many distances, and no more widths of the pen. */
const REACH = 2.4;
const FARTHEST_REACH = 17;
/** Neighbours lie beside a point to this share of a step. */
const ALONG = 0.8;
/** A line with one neighbour moves away where that is nearer than this share of the distance. */
const TOO_NEAR = 0.95;
/** Moves are smoothed over so many distances to both sides, within so many points, three times. */
const STIFF = 1.6;
const WINDOW = [4, 20] as const;
const SMOOTHINGS = 3;
/** Lines may come as near to an outline as this, in widths of the pen, or as they were. */
const BESIDE_OUTLINE = 0.4;
/** What is left of a line that was cut is kept from this share of its least length on. */
const KEPT = 0.8;
/** Points per step. */
const CHUNK = 1024;

/** Moves lines sideways until each lies in the middle between its neighbours, weighed by the distances asked for. Yields its progress. */
export function* evenOut(laws: LineLaws, points: LinePoints): Generator<number, LinePoints, void> {
  const moves = new Float64Array(points.count);
  for (let round = 0; round < ROUNDS; round++) {
    for (let i = 0; i < points.count; i++) points.apart[i] = laws.look(points.x[i], points.y[i]);
    points.registerAll();
    for (let i = 0; i < points.count; i++) {
      if (i % CHUNK === 0) yield (round + i / points.count) / ROUNDS;
      moves[i] = moveOf(points, i, laws.pen);
    }
    for (let line = 0; line < points.lines; line++) smoothMoves(points, line, moves, STEP * laws.pen);
    for (let i = 0; i < points.count; i++) {
      const share = points.ids[points.line[i]] === UNNUMBERED ? SHARE : CARRIED_SHARE;
      if (moves[i] !== 0) move(laws, points, i, share * moves[i]);
    }
    turn(points);
  }
  return yield* withoutCrowds(laws, points);
}

/** How far a point lies from the middle between its neighbours, to its left. */
function moveOf(points: LinePoints, i: number, pen: number): number {
  const apart = points.apart[i];
  points.gapsAt(i, Math.min(REACH * apart, FARTHEST_REACH * pen), ALONG * STEP * pen);
  const { left, right } = points;
  let move = 0;
  if (left < Infinity && right < Infinity) {
    const [toLeft, toRight] = [0.5 * (apart + points.leftApart), 0.5 * (apart + points.rightApart)];
    move = (left * toRight - right * toLeft) / (toLeft + toRight);
  } else if (left < TOO_NEAR * apart) move = 0.5 * (left - apart);
  else if (right < TOO_NEAR * apart) move = 0.5 * (apart - right);
  return Math.min(Math.max(move, -FARTHEST * apart), FARTHEST * apart);
}

/** Means over windows to both sides; beyond the ends of the line moves are those of its ends. */
function smoothMoves(points: LinePoints, line: number, moves: Float64Array, step: number): void {
  const [first, end] = [points.starts[line], points.starts[line + 1]];
  const last = end - first - 1;
  const sums = new Float64Array(end - first + 1);
  for (let round = 0; round < SMOOTHINGS; round++) {
    for (let i = first; i < end; i++) sums[i - first + 1] = sums[i - first] + moves[i];
    const [atFirst, atLast] = [moves[first], moves[end - 1]];
    for (let k = 0; k <= last; k++) {
      const half = Math.min(Math.max(Math.round((STIFF * points.apart[first + k]) / step), WINDOW[0]), WINDOW[1]);
      const [from, to] = [Math.max(k - half, 0), Math.min(k + half, last)];
      const beyond = (from - k + half) * atFirst + (k + half - to) * atLast;
      moves[first + k] = (sums[to + 1] - sums[from] + beyond) / (2 * half + 1);
    }
  }
}

function move({ fields: { sheet }, pen }: LineLaws, points: LinePoints, i: number, by: number): void {
  const [x, y] = [points.x[i], points.y[i]];
  const [toX, toY] = [x - points.uy[i] * by, y + points.ux[i] * by];
  if (sheet.isParted(x, y, toX, toY)) return;
  if (sheet.awayAt(toX, toY) < Math.min(BESIDE_OUTLINE * pen, sheet.awayAt(x, y))) return;
  points.x[i] = toX;
  points.y[i] = toY;
}

/** Sets directions to those of the moved lines. */
function turn(points: LinePoints): void {
  const { x, y, ux, uy, starts } = points;
  for (let line = 0; line < points.lines; line++) {
    const [first, end] = [starts[line], starts[line + 1]];
    for (let i = first; i < end; i++) {
      const [a, b] = [Math.max(i - 1, first), Math.min(i + 1, end - 1)];
      const length = Math.hypot(x[b] - x[a], y[b] - y[a]) || 1;
      ux[i] = (x[b] - x[a]) / length;
      uy[i] = (y[b] - y[a]) / length;
    }
  }
}

/** The lines without the parts that came too near to longer ones. */
function* withoutCrowds(laws: LineLaws, points: LinePoints): Generator<number, LinePoints, void> {
  const { pen, fields } = laws;
  const { x, y, ux, uy, apart, starts } = points;
  const kept = new LinePoints(fields.sheet, 3 * pen);
  const order = Array.from({ length: points.lines }, (_, line) => line);
  const pointsOf = (line: number): number => starts[line + 1] - starts[line];
  order.sort((a, b) => pointsOf(b) - pointsOf(a) || a - b);
  for (const [n, line] of order.entries()) {
    if (n % 16 === 0) yield 1;
    const parts: [first: number, end: number][] = [];
    let first = starts[line];
    const close = (end: number): void => {
      if ((end - first - 1) * STEP * pen >= KEPT * leastLength(laws, points, first, end)) parts.push([first, end]);
    };
    for (let i = starts[line]; i < starts[line + 1]; i++) {
      const isOut = kept.isTaken(x[i], y[i], laws.crowded);
      const isOff = i > first && fields.sheet.isParted(x[i - 1], y[i - 1], x[i], y[i]);
      if (isOut || isOff) close(i);
      if (isOut) first = i + 1;
      else if (isOff) first = i;
    }
    close(starts[line + 1]);
    for (const [k, [from, end]] of parts.entries()) {
      for (let i = from; i < end; i++) kept.push(x[i], y[i], ux[i], uy[i], apart[i]);
      kept.endLine(points.lots[line], k === 0 ? points.ids[line] : undefined);
    }
  }
  kept.numberLines();
  return kept;
}
