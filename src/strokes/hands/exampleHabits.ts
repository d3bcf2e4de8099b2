import type { SwatchTone } from 'three-hatching';

/** The parameters of a way to draw. Lengths are in millimetres, angles in degrees, clockwise on the sheet. */
export interface PenHabits {
  /** Mean length of a stroke, and its deviation as a share of it. */
  length: number;
  lengthSpread: number;
  /** Width of a stroke where it is widest. */
  width: number;
  /** The deviation of the width between strokes and, slowly, along each, as a share of it. */
  pressure: number;
  /** The shares of the length over which a stroke grows from its start and narrows to its end. */
  taperStart: number;
  taperEnd: number;
  /** The width of the two tips as a share of the stroke's. */
  tips: readonly [start: number, end: number];
  /** Height of the arc over the chord, as a share of it, and its deviation. */
  curvature: number;
  curvatureSpread: number;
  /** How far the line strays from its arc, and the length after which it strays the other way. */
  wobble: number;
  wobbleLength: number;
  /** The direction of the first layer, and the deviation of strokes from their layer's direction. */
  angle: number;
  angleSpread: number;
  /** The distance of neighbours in each swatch. */
  spacing: Readonly<Record<SwatchTone, number>>;
  /** The deviation of that distance, as a share of it. */
  spacingSpread: number;
  /** Strokes per bundle; between bundles the gap is `bundleGap` distances. 1: no bundles. */
  bundle: number;
  bundleGap: number;
  /** How far the ends of neighbours stray along the layer, as a share of the length. */
  raggedness: number;
  /** The share of the length that runs beside the next stroke of the row; negative leaves gaps. */
  overlap: number;
  /** The angle of the second layer, and the lightest swatch that has it. */
  crossing?: { angle: number; from: SwatchTone } | undefined;
  /** Whether strokes go to and fro without lifting the pen. */
  isZigzag: boolean;
}

/** Six different ways to draw. */
export const exampleHabits = {
  /** A steel pen with a fine nib: long even strokes that lift off softly, crossed in the dark. */
  finePen: {
    length: 7.6,
    lengthSpread: 0.12,
    width: 0.26,
    pressure: 0.1,
    taperStart: 0.12,
    taperEnd: 0.4,
    tips: [0.6, 0.2],
    curvature: 0.035,
    curvatureSpread: 0.012,
    wobble: 0.03,
    wobbleLength: 3,
    angle: -48,
    angleSpread: 2.2,
    spacing: { light: 1.5, middle: 0.8, dark: 0.85 },
    spacingSpread: 0.14,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.06,
    overlap: -0.04,
    crossing: { angle: 62, from: 'dark' },
    isZigzag: false,
  },
  /** A pointed brush full of ink: bellied strokes that swell and end in points, bent from the wrist. */
  brush: {
    length: 16,
    lengthSpread: 0.14,
    width: 0.95,
    pressure: 0.16,
    taperStart: 0.32,
    taperEnd: 0.55,
    tips: [0.12, 0.04],
    curvature: 0.085,
    curvatureSpread: 0.03,
    wobble: 0.03,
    wobbleLength: 6,
    angle: -68,
    angleSpread: 4.5,
    spacing: { light: 3.4, middle: 1.9, dark: 1.1 },
    spacingSpread: 0.16,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.12,
    overlap: -0.1,
    isZigzag: false,
  },
  /** A cut reed that takes little ink: short blunt strokes in bundles, broad and narrow at random, as in Van Gogh's drawings from Arles. */
  reedPen: {
    length: 6.4,
    lengthSpread: 0.24,
    width: 0.64,
    pressure: 0.26,
    taperStart: 0,
    taperEnd: 0.25,
    tips: [1, 0.55],
    curvature: -0.05,
    curvatureSpread: 0.035,
    wobble: 0.07,
    wobbleLength: 1.6,
    angle: -18,
    angleSpread: 5.5,
    spacing: { light: 2.5, middle: 1.4, dark: 1.5 },
    spacingSpread: 0.24,
    bundle: 5,
    bundleGap: 1.1,
    raggedness: 0.14,
    overlap: -0.16,
    crossing: { angle: 34, from: 'dark' },
    isZigzag: false,
  },
  /** A ballpoint that never leaves the paper: loose, to and fro, over earlier strokes. */
  scribble: {
    length: 7,
    lengthSpread: 0.3,
    width: 0.28,
    pressure: 0.08,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    curvature: 0.05,
    curvatureSpread: 0.06,
    wobble: 0.14,
    wobbleLength: 2.6,
    angle: -35,
    angleSpread: 7,
    spacing: { light: 1.5, middle: 0.82, dark: 0.9 },
    spacingSpread: 0.42,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.12,
    overlap: 0.1,
    crossing: { angle: -55, from: 'dark' },
    isZigzag: true,
  },
  /** A technical pen along a ruler: straight, even, from edge to edge, crossed at right angles. */
  ruled: {
    length: 15.5,
    lengthSpread: 0.01,
    width: 0.35,
    pressure: 0.015,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    curvature: 0,
    curvatureSpread: 0,
    wobble: 0,
    wobbleLength: 5,
    angle: 0,
    angleSpread: 0.15,
    spacing: { light: 2.2, middle: 1.2, dark: 1.2 },
    spacingSpread: 0.02,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.003,
    overlap: -0.02,
    crossing: { angle: 90, from: 'dark' },
    isZigzag: false,
  },
  /** A nib that is set down and flicked away: tiny wedges, strewn. */
  stippleFlicks: {
    length: 1.5,
    lengthSpread: 0.25,
    width: 0.5,
    pressure: 0.18,
    taperStart: 0.06,
    taperEnd: 0.8,
    tips: [0.7, 0.05],
    curvature: 0.05,
    curvatureSpread: 0.04,
    wobble: 0,
    wobbleLength: 1,
    angle: 62,
    angleSpread: 13,
    spacing: { light: 1.4, middle: 0.72, dark: 0.42 },
    spacingSpread: 0.32,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.5,
    overlap: -0.45,
    isZigzag: false,
  },
} as const satisfies Record<string, PenHabits>;
