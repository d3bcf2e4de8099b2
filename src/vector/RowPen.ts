import { type Chain, ChainBuilder } from './Chain.js';
import { type LineTracer, lengthBetween, type Measured, type MeasuredPlace, type TracingPen } from './LineTracer.js';
import type { Line } from './lineMarks.js';
import { hash01 } from './shading/hand.js';
import { isSameStroke, type RowStroke } from './shading/handStrokes.js';

/** The greatest change of the half width and of the offset of a stroke between two points farther apart than the least step. Pixels. */
const CHANGE = 0.2;
const LEAST_STEP = 0.1;

/** The precision of the ends of strokes, pixels. */
const END = 0.02;

/** A stroke while it is drawn. */
interface OpenStroke {
  /** Where it was seen last. */
  stroke: RowStroke;
  readonly builder: ChainBuilder;
}

/** Draws the strokes of a hand along a row, from node to node, each into a chain of its own. */
export class RowPen implements TracingPen {
  private readonly chains = new Set<ChainBuilder>();
  private open: OpenStroke[] = [];
  /** The strokes at the start of the row. */
  private first: readonly { stroke: RowStroke; builder: ChainBuilder }[] = [];
  private last: MeasuredPlace | undefined;

  constructor(
    private readonly tracer: LineTracer,
    private readonly row: Line,
  ) {}

  to(node: number, triangle: number): void {
    const { tracer, last } = this;
    const place = this.measured(tracer.numbersAt(node, triangle), triangle);
    if (!last) {
      this.draw(place.measured, triangle);
      this.first = this.open.map(({ stroke, builder }) => ({ stroke, builder }));
    } else {
      const steps = tracer.stepsTo(last.measured, place.measured);
      let from = last;
      for (let i = 1; i <= steps; i++) {
        const next = i === steps ? place : this.between(last, place, i / steps, triangle);
        this.advance(from, next, triangle);
        from = next;
      }
    }
    this.last = place;
  }

  /** On flat triangles widths and offsets differ slightly, and the mean of both is used. */
  turn(node: number, triangle: number): void {
    const place = this.measured(this.tracer.numbersAt(node, triangle), triangle);
    const { uphill = [0, 0] } = place.measured;
    for (const stroke of strokesOf(place)) {
      const known = this.open.find((one) => isSameStroke(one.stroke, stroke));
      const shift = [stroke.shift * uphill[0], stroke.shift * uphill[1]] as const;
      known?.builder.share(this.tracer.halfOf(stroke), 1, this.tracer.parentOf(triangle), shift);
    }
    this.last = place;
  }

  finish(isClosed: boolean): Chain[] {
    const { first, open, chains, row } = this;
    // A stroke over the start of a closed row is one.
    if (isClosed)
      for (const { stroke, builder } of open) {
        const after = first.find((one) => isSameStroke(one.stroke, stroke) && one.builder !== builder);
        if (!after) continue;
        builder.append(after.builder);
        chains.delete(after.builder);
      }
    return [...chains].filter(({ count }) => count > 1).map((builder) => builder.finish(false, hash01(row.value)));
  }

  private measured(numbers: Float64Array, triangle: number): MeasuredPlace {
    return { numbers, measured: this.tracer.measure(numbers, triangle, this.row) };
  }

  private between(from: MeasuredPlace, to: MeasuredPlace, share: number, triangle: number): MeasuredPlace {
    const numbers = from.numbers.map((number, k) => number + share * (to.numbers[k] - number));
    return this.measured(numbers, triangle);
  }

  /** Draws from one place to the next, at more places where a stroke begins, ends or changes. */
  private advance(from: MeasuredPlace, to: MeasuredPlace, triangle: number): void {
    if (lengthBetween(from.measured, to.measured) > stepBetween(strokesOf(from), strokesOf(to))) {
      const middle = this.between(from, to, 0.5, triangle);
      this.advance(from, middle, triangle);
      this.advance(middle, to, triangle);
    } else this.draw(to.measured, triangle);
  }

  private draw(measured: Measured, triangle: number): void {
    const { strokes = [], uphill = [0, 0] } = measured;
    this.open = strokes.map((stroke): OpenStroke => {
      const known = this.open.find((one) => isSameStroke(one.stroke, stroke));
      const builder = known?.builder ?? new ChainBuilder();
      if (!known) this.chains.add(builder);
      const shift = [stroke.shift * uphill[0], stroke.shift * uphill[1]] as const;
      const half = this.tracer.halfOf(stroke);
      this.tracer.write(builder, { ...measured, half, margin: 1, shift }, triangle);
      return { stroke, builder };
    });
  }
}

const strokesOf = ({ measured: { strokes = [] } }: MeasuredPlace): readonly RowStroke[] => strokes;

/** How far apart two places may be measured, pixels, by the strokes there. */
function stepBetween(from: readonly RowStroke[], to: readonly RowStroke[]): number {
  const pairs = from.map((stroke) => [stroke, to.find((one) => isSameStroke(one, stroke))] as const);
  if (from.length !== to.length || pairs.some(([, other]) => !other)) return END;
  const changes = pairs.map(([a, b]) => Math.max(Math.abs(a.half - b!.half), Math.abs(a.shift - b!.shift)));
  return Math.max(0, ...changes) > CHANGE ? LEAST_STEP : Infinity;
}
