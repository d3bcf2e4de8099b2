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
  /** The pressure along a stroke: shares of its width at even places from start to end, smooth between them. Default: even. */
  pressed?: readonly number[];
  /** How unevenly the tool touches the paper: the deviation of the width along a stroke, as a share of it, and the length after which it changes. */
  grain?: { depth: number; length: number };
  /** Places where the tool skips: their share of the length, at the start and at the end of a stroke, below 0 for none yet, and their distance. */
  skips?: { share: readonly [start: number, end: number]; length: number };
  /** Height of the arc over the chord, as a share of it, and its deviation. */
  curvature: number;
  curvatureSpread: number;
  /** How far the line strays from its arc, and the length after which it strays the other way. */
  wobble: number;
  wobbleLength: number;
  /** The hooks of the two ends: the share of the length that turns aside, and by how much. */
  hooks?: { share: number; start: number; end: number };
  /** Lines that one stroke draws beside each other, as the hairs of a brush: their number, and the breadth that they fill together. */
  strands?: { count: number; breadth: number };
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

/** Twelve different ways to draw, each by what a tool does. */
export const exampleHabits = {
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
  /** A flat brush with hardly any ink: hairs that part, skip over the tooth of the paper, and run dry towards the end. */
  dryBrush: {
    length: 14,
    lengthSpread: 0.12,
    width: 0.28,
    pressure: 0.14,
    taperStart: 0.03,
    taperEnd: 0.3,
    tips: [0.7, 0.2],
    grain: { depth: 0.35, length: 0.8 },
    skips: { share: [-0.5, 0.6], length: 1.7 },
    curvature: 0.03,
    curvatureSpread: 0.02,
    wobble: 0.02,
    wobbleLength: 5,
    strands: { count: 6, breadth: 2 },
    angle: -24,
    angleSpread: 3,
    spacing: { light: 5.2, middle: 3.6, dark: 2.5 },
    spacingSpread: 0.12,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.08,
    overlap: -0.08,
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
  /** A steel pen with a pointed nib: a hair line that the pressure of the finger opens and closes again, in even rows, crossed in the dark. */
  finePen: {
    length: 7.7,
    lengthSpread: 0.1,
    width: 0.38,
    pressure: 0.06,
    taperStart: 0.45,
    taperEnd: 0.5,
    tips: [0.22, 0.16],
    curvature: 0.065,
    curvatureSpread: 0.012,
    wobble: 0.015,
    wobbleLength: 4,
    angle: -48,
    angleSpread: 1.6,
    spacing: { light: 1.5, middle: 0.92, dark: 0.95 },
    spacingSpread: 0.08,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.04,
    overlap: -0.04,
    crossing: { angle: 62, from: 'dark' },
    isZigzag: false,
  },
  /** A goose quill: it is set down with a drop, hooks off, and ends in a long thin tail; thick and thin, and no two strokes alike. */
  quill: {
    length: 7.8,
    lengthSpread: 0.28,
    width: 0.62,
    pressure: 0.22,
    taperStart: 0.04,
    taperEnd: 0.85,
    tips: [0.8, 0.14],
    pressed: [1.25, 1, 0.75, 0.9, 1],
    curvature: 0.07,
    curvatureSpread: 0.05,
    wobble: 0.06,
    wobbleLength: 3.4,
    hooks: { share: 0.14, start: 50, end: 0 },
    angle: -56,
    angleSpread: 8,
    spacing: { light: 2.6, middle: 1.6, dark: 1.5 },
    spacingSpread: 0.3,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.18,
    overlap: -0.06,
    crossing: { angle: 48, from: 'dark' },
    isZigzag: false,
  },
  /** A ballpoint: lines of one thin width that are drawn twice over, fast and close, with the hook of the hand that goes back. */
  ballpoint: {
    length: 12,
    lengthSpread: 0.14,
    width: 0.2,
    pressure: 0.08,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    curvature: 0.03,
    curvatureSpread: 0.02,
    wobble: 0.05,
    wobbleLength: 5,
    hooks: { share: 0.08, start: 0, end: 65 },
    strands: { count: 2, breadth: 0.36 },
    angle: -38,
    angleSpread: 2.6,
    spacing: { light: 1.7, middle: 1.05, dark: 0.9 },
    spacingSpread: 0.22,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.07,
    overlap: 0.02,
    crossing: { angle: 28, from: 'dark' },
    isZigzag: false,
  },
  /** A felt tip: straight and broad, as wide at one end as at the other, with a spot at both where the ink runs while the pen rests. */
  feltTip: {
    length: 12.5,
    lengthSpread: 0.1,
    width: 0.9,
    pressure: 0.02,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    pressed: [1.4, 1.02, 0.97, 0.96, 0.96, 0.96, 0.96, 0.96, 0.97, 1.02, 1.35],
    curvature: 0,
    curvatureSpread: 0.012,
    wobble: 0.04,
    wobbleLength: 6,
    angle: -12,
    angleSpread: 2,
    spacing: { light: 3.2, middle: 2.1, dark: 2.3 },
    spacingSpread: 0.1,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.05,
    overlap: -0.1,
    crossing: { angle: 84, from: 'dark' },
    isZigzag: false,
  },
  /** A soft pencil on its point: grey by its grain, soft at both ends, close, one stroke over the other. */
  softPencil: {
    length: 7.6,
    lengthSpread: 0.18,
    width: 0.13,
    pressure: 0.2,
    taperStart: 0.3,
    taperEnd: 0.4,
    tips: [0.5, 0.3],
    grain: { depth: 0.3, length: 0.3 },
    skips: { share: [0.1, 0.16], length: 0.5 },
    curvature: 0.04,
    curvatureSpread: 0.02,
    wobble: 0.05,
    wobbleLength: 2.2,
    angle: -42,
    angleSpread: 4,
    spacing: { light: 1.3, middle: 0.82, dark: 0.55 },
    spacingSpread: 0.35,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.2,
    overlap: 0.12,
    crossing: { angle: 24, from: 'dark' },
    isZigzag: false,
    strands: { count: 3, breadth: 0.34 },
  },
  /** A wax crayon: broad and blunt, torn by the tooth of the paper into grains of every size. */
  crayon: {
    length: 7.7,
    lengthSpread: 0.16,
    width: 0.34,
    pressure: 0.2,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    grain: { depth: 0.3, length: 0.35 },
    skips: { share: [0.3, 0.34], length: 0.45 },
    curvature: -0.02,
    curvatureSpread: 0.03,
    wobble: 0.08,
    wobbleLength: 1.2,
    strands: { count: 6, breadth: 1.6 },
    angle: -62,
    angleSpread: 5,
    spacing: { light: 4.4, middle: 3, dark: 2.1 },
    spacingSpread: 0.18,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.06,
    overlap: -0.08,
    isZigzag: false,
  },
  /** Dürer's woodcut tool: long wedges, broad in the shade and pointed towards the light, side by side at one distance. */
  woodcut: {
    length: 16,
    lengthSpread: 0.07,
    width: 0.95,
    pressure: 0.03,
    taperStart: 0,
    taperEnd: 0.92,
    tips: [1, 0.05],
    curvature: 0.025,
    curvatureSpread: 0.006,
    wobble: 0.015,
    wobbleLength: 6,
    angle: -86,
    angleSpread: 0.7,
    spacing: { light: 2.3, middle: 1.5, dark: 1.15 },
    spacingSpread: 0.05,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.06,
    overlap: -0.06,
    isZigzag: false,
  },
  /** A fineliner that never leaves the paper: loose, to and fro, over earlier strokes. */
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
    wobble: 0.28,
    wobbleLength: 1.5,
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
  /** An etching needle: hair lines of one width, bitten by acid, short and trembling, crossed almost everywhere. */
  etchingNeedle: {
    length: 4.6,
    lengthSpread: 0.3,
    width: 0.13,
    pressure: 0.1,
    taperStart: 0,
    taperEnd: 0,
    tips: [1, 1],
    curvature: 0.02,
    curvatureSpread: 0.03,
    wobble: 0.04,
    wobbleLength: 0.8,
    angle: -30,
    angleSpread: 6,
    spacing: { light: 1, middle: 0.62, dark: 0.4 },
    spacingSpread: 0.32,
    bundle: 1,
    bundleGap: 0,
    raggedness: 0.3,
    overlap: 0.02,
    crossing: { angle: 72, from: 'middle' },
    isZigzag: false,
  },
} as const satisfies Record<string, PenHabits>;
