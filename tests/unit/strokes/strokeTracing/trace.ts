import type { HandStroke } from '../../../../src/strokes/hand/Hand.js';
import type { ScannedImage } from '../../../../src/strokes/strokeTracing/ScannedImage.js';
import { type TraceOptions, traceStrokesSteps } from '../../../../src/strokes/strokeTracing/traceStrokesSteps.js';

/** Traces a picture to the end, by default in pixels. */
export function trace(image: ScannedImage, options: TraceOptions = { millimetresPerPixel: 1 }): HandStroke[] {
  const steps = traceStrokesSteps({ image, ...options });
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** Measures of a stroke, in pixels and degrees. */
export interface Measured {
  length: number;
  /** The median width. */
  width: number;
  /** Of the chord, from 0 to 180. */
  angle: number;
  /** The middle of the chord. */
  x: number;
  y: number;
}

export function measure({ points, widths }: HandStroke): Measured {
  const last = points.length - 2;
  let length = 0;
  for (let i = 2; i <= last; i += 2) length += Math.hypot(points[i] - points[i - 2], points[i + 1] - points[i - 1]);
  const angle = (Math.atan2(points[last + 1] - points[1], points[last] - points[0]) * 180) / Math.PI;
  return {
    length,
    width: [...widths].sort((a, b) => a - b)[widths.length >> 1],
    angle: (angle + 180) % 180,
    x: 0.5 * (points[0] + points[last]),
    y: 0.5 * (points[1] + points[last + 1]),
  };
}
