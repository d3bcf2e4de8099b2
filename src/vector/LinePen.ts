import { type Chain, ChainBuilder } from './Chain.js';
import { type LineTracer, lengthBetween, type MeasuredPlace, type TracingPen } from './LineTracer.js';
import type { Line } from './lineMarks.js';
import { hash01 } from './shading/hand.js';

/** Distance between samples for edges of shadows, and the precision of an edge, times the change at it. Pixels. */
const SHADOW_STEP = 3;
const EDGE = 0.02;
/** The greatest change of a shadow between two points of a line that is not an edge. */
const SHADOW_CHANGE = 0.05;

/** Draws a line into a chain, from node to node. */
export class LinePen implements TracingPen {
  private readonly builder = new ChainBuilder();
  private last: MeasuredPlace | undefined;

  constructor(
    private readonly tracer: LineTracer,
    private readonly line: Line,
  ) {}

  finish(isClosed: boolean): Chain[] {
    const { builder, line } = this;
    return builder.hasLine ? [builder.finish(isClosed, hash01(line.value))] : [];
  }

  /** Continues to a node over a triangle. */
  to(node: number, triangle: number): void {
    const { tracer, line, last } = this;
    const numbers = tracer.numbersAt(node, triangle);
    const measured = tracer.measure(numbers, triangle, line);
    const steps = last ? tracer.stepsTo(last.measured, measured) : 1;
    for (let i = 1; last && i < steps; i++) {
      const between = last.numbers.map((number, k) => number + (i / steps) * (numbers[k] - number));
      this.write({ numbers: between, measured: tracer.measure(between, triangle, line) }, triangle);
    }
    this.write({ numbers, measured }, triangle);
  }

  private write(place: MeasuredPlace, triangle: number): void {
    const { tracer, builder, last } = this;
    if (last && tracer.hasEdges) this.lookBetween(last, place, triangle);
    tracer.write(builder, place.measured, triangle);
    this.last = place;
  }

  /** Continues over the next triangle. On flat triangles widths differ slightly, and the mean of both is used. */
  turn(node: number, triangle: number): void {
    const numbers = this.tracer.numbersAt(node, triangle);
    const measured = this.tracer.measure(numbers, triangle, this.line);
    this.builder.share(measured.half, measured.margin, this.tracer.parentOf(triangle));
    this.last = { numbers, measured };
  }

  /** Searches for shadow edges between two places, and adds points where shadows change: two at one place for a hard edge. */
  private lookBetween(start: MeasuredPlace, end: MeasuredPlace, triangle: number): void {
    const change = this.tracer.shadowChange(start.measured, end.measured);
    if (change === 0 && start.measured.isBlank && end.measured.isBlank) return;
    const length = lengthBetween(start.measured, end.measured);
    if (change <= SHADOW_CHANGE ? length <= SHADOW_STEP : Math.min(change, 1) * length <= EDGE) return;
    const { tracer, builder, line } = this;
    const numbers = start.numbers.map((number, k) => 0.5 * (number + end.numbers[k]));
    const measured = tracer.measure(numbers, triangle, line);
    const middle = { numbers, measured };
    this.lookBetween(start, middle, triangle);
    const isApart =
      tracer.shadowChange(start.measured, measured) + tracer.shadowChange(measured, end.measured) > SHADOW_CHANGE;
    if (change > SHADOW_CHANGE || isApart) tracer.write(builder, measured, triangle);
    this.lookBetween(middle, end, triangle);
  }
}
