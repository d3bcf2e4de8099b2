/** How a style draws. Lengths are in tiles, widths in texels of every level, as in `Stroke`. */
export interface StrokeStyle {
  /** Lines are drawn between these lengths; [0, 0] draws dots. */
  length: readonly [shortest: number, longest: number];
  /** In the middle of the stroke. */
  width: number;
  /**
   * Between these widths the level nesting can be kept. A thinner stroke (with `widthSpread`) may fall between texels so
   * that none is half covered; a wider one reaches texels of a coarse level that it does not on the finer one.
   */
  widthRange: readonly [narrowest: number, widest: number];
  /** Each stroke's width differs from `width` by at most this part of it. */
  widthSpread: number;
  /** Texels over which each end narrows. */
  taper: number;
  /** Each stroke's angle to the direction of its layer is at most this, as a tangent. */
  slope: number;
  /** Greatest arc of a stroke. */
  bow: number;
  /** Greatest S-bend of a stroke. */
  wave: number;
  /** Mean ink of the darkest image. */
  maxInk: number;
  /** The directions of strokes, from the first to the last that is drawn. Layers that are drawn have equal ink. */
  layers: readonly StrokeLayer[];
  /** For each stroke, the best of so many proposals is drawn. 1 draws at random. */
  proposals: number;
  /** What is different in a threshold map. */
  thresholds: ThresholdStyle;
  /** The paper's, where it shows. */
  grain?: Grain;
}

/** One direction of strokes, which cross those of other layers. */
export interface StrokeLayer {
  /** Whether the strokes run along v instead of u. */
  across: boolean;
  /** Their angle to that axis, as a tangent. */
  slope: number;
  /** Mean ink from which on the layer is drawn. */
  from: number;
  /** The same in thresholds, and counted like all inks there. */
  thresholdsFrom: number;
}

/**
 * How a style draws thresholds, where the ink of strokes is not given but follows from what their swelling adds. Inks are
 * therefore those of the strokes as images draw them.
 */
export interface ThresholdStyle {
  /** Strokes are added up to this ink. From there on they only swell, so that even gaps remain between them and close. */
  maxInk: number;
  /** Ink that is added while a stroke swells from a hairline to its width. */
  swell: number;
  proposals: number;
}

/** How rough paper breaks strokes up. */
export interface Grain {
  /** Texels by which the noise of the paper is blurred: grains are about twice as wide. */
  radius: number;
  /** Texels over which a stroke fades at its edge. */
  edge: number;
  /** How sharply the paper's depth decides between ink and paper: 1 gives greys, 10 specks. */
  contrast: number;
  /** Each stroke's pressure lies between these: the part of the paper that it blackens in its middle. */
  pressure: readonly [least: number, most: number];
  /** Ink that comes later in the deepest places of the paper than on its peaks, in thresholds. */
  roughness: number;
}

const along: StrokeLayer = { across: false, slope: 0, from: 0, thresholdsFrom: 0 };

const hatching: StrokeStyle = {
  length: [0.28, 0.6],
  width: 1.9,
  widthRange: [1.2, 2.6],
  widthSpread: 0.12,
  taper: 22,
  slope: 0.016,
  bow: 0.0025,
  wave: 0.003,
  maxInk: 0.95,
  layers: [along],
  proposals: 400,
  thresholds: { maxInk: 0.54, swell: 0.15, proposals: 400 },
};

const stippling: StrokeStyle = {
  length: [0, 0],
  width: 2.4,
  widthRange: [1.65, 2.5],
  widthSpread: 0.12,
  taper: 0,
  slope: 0,
  bow: 0,
  wave: 0,
  maxInk: 0.85,
  layers: [along],
  proposals: 24,
  thresholds: { maxInk: 0.5, swell: 0.05, proposals: 48 },
};

/** The styles that the generator can draw: materials, and hands. */
export const strokeStyles = {
  /** Pen strokes side by side. */
  hatching,

  /** Pen strokes, and from half tone on others at right angles. */
  crossHatching: {
    ...hatching,
    layers: [along, { across: true, slope: 0, from: 0.45, thresholdsFrom: 0.32 }],
    thresholds: { maxInk: 0.6, swell: 0.15, proposals: 400 },
  },

  /** Fine pen strokes in three directions, sixty degrees apart, one after the other. */
  tripleHatching: {
    ...hatching,
    width: 1.7,
    layers: [
      along,
      { across: true, slope: 0.577, from: 0.28, thresholdsFrom: 0.2 },
      { across: true, slope: -0.577, from: 0.52, thresholdsFrom: 0.4 },
    ],
    thresholds: { maxInk: 0.72, swell: 0.1, proposals: 300 },
  },

  /** Thin even lines as if drawn with a ruler, and from half tone on a second set. */
  ruled: {
    ...hatching,
    length: [0.5, 0.95],
    width: 1.4,
    widthRange: [1.2, 2.6],
    widthSpread: 0.02,
    taper: 0,
    slope: 0.001,
    bow: 0,
    wave: 0,
    layers: [along, { across: true, slope: 0.577, from: 0.42, thresholdsFrom: 0.3 }],
    thresholds: { maxInk: 0.8, swell: 0.08, proposals: 500 },
  },

  /** Long lines that run on like the contours of a map. */
  contours: {
    ...hatching,
    length: [0.5, 1.5],
    width: 1.8,
    widthSpread: 0.06,
    taper: 48,
    slope: 0.006,
    bow: 0.004,
    wave: 0.006,
    proposals: 500,
    thresholds: { maxInk: 0.46, swell: 0.22, proposals: 500 },
  },

  /** Short strokes with gaps between them. */
  dashes: {
    ...hatching,
    length: [0.045, 0.09],
    width: 2.2,
    widthRange: [1.65, 2.5],
    taper: 5,
    slope: 0.09,
    bow: 0,
    wave: 0,
    maxInk: 0.9,
    proposals: 80,
    thresholds: { maxInk: 0.6, swell: 0.08, proposals: 80 },
  },

  /** Dots. */
  stippling,

  /** Soft grey strokes on paper with a fine grain. */
  pencil: {
    ...hatching,
    length: [0.22, 0.5],
    width: 1.8,
    widthRange: [1.6, 2.4],
    widthSpread: 0.25,
    taper: 30,
    slope: 0.05,
    bow: 0.006,
    wave: 0.004,
    maxInk: 0.8,
    proposals: 120,
    thresholds: { maxInk: 0.66, swell: 0.15, proposals: 200 },
    grain: { radius: 1, edge: 2, contrast: 1.6, pressure: [0.6, 1.5], roughness: 0.22 },
  },

  /** Broad crumbling strokes on rough paper. */
  charcoal: {
    ...hatching,
    length: [0.16, 0.42],
    width: 2.6,
    widthRange: [2, 2.6],
    widthSpread: 0.25,
    taper: 16,
    slope: 0.1,
    bow: 0.01,
    wave: 0.006,
    maxInk: 0.84,
    proposals: 60,
    thresholds: { maxInk: 0.5, swell: 0.25, proposals: 100 },
    grain: { radius: 1, edge: 2.5, contrast: 5, pressure: [0.7, 1.5], roughness: 0.36 },
  },

  /** Stout wedges cut into wood, which close until only slivers of paper remain. */
  woodcut: {
    ...hatching,
    length: [0.2, 0.46],
    width: 2.5,
    widthSpread: 0.15,
    taper: 90,
    slope: 0.03,
    bow: 0.004,
    wave: 0.002,
    proposals: 300,
    thresholds: { maxInk: 0.46, swell: 0.3, proposals: 300 },
  },
} as const satisfies Record<string, StrokeStyle>;

/** The names of the styles. */
export type StrokeStyleName = keyof typeof strokeStyles;
