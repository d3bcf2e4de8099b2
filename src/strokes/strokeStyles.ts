import type { StrokeLayer, StrokeStyle } from './StrokeStyle.js';
import { STROKE_WIDTHS, type StrokeStyleName } from './strokeStyleNames.js';

const along: StrokeLayer = { across: false, slope: 0, from: 0, thresholdsFrom: 0 };

/** A style without its widths. */
type StrokeShape = Omit<StrokeStyle, 'width' | 'widthRange'>;

const hatching: StrokeShape = {
  length: [0.28, 0.6],
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

const stippling: StrokeShape = {
  length: [0, 0],
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

// A function makes the styles: bundlers assume that a spread has side effects, and would never drop a constant.
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: it is a table.
const makeStyles = () =>
  ({
    /** Pen strokes side by side. */
    hatching: { ...hatching, ...STROKE_WIDTHS.hatching },

    /** Pen strokes, with a second layer at right angles from half tone on. */
    crossHatching: {
      ...hatching,
      ...STROKE_WIDTHS.crossHatching,
      layers: [along, { across: true, slope: 0, from: 0.45, thresholdsFrom: 0.32 }],
      thresholds: { maxInk: 0.6, swell: 0.15, proposals: 400 },
    },

    /** Fine pen strokes in three directions, sixty degrees apart, that begin one after the other. */
    tripleHatching: {
      ...hatching,
      ...STROKE_WIDTHS.tripleHatching,
      layers: [
        along,
        { across: true, slope: 0.577, from: 0.28, thresholdsFrom: 0.2 },
        { across: true, slope: -0.577, from: 0.52, thresholdsFrom: 0.4 },
      ],
      thresholds: { maxInk: 0.72, swell: 0.1, proposals: 300 },
    },

    /** Thin even lines as if drawn with a ruler, with a second layer from half tone on. */
    ruled: {
      ...hatching,
      ...STROKE_WIDTHS.ruled,
      length: [0.5, 0.95],
      widthSpread: 0.02,
      taper: 0,
      slope: 0.001,
      bow: 0,
      wave: 0,
      layers: [along, { across: true, slope: 0.577, from: 0.42, thresholdsFrom: 0.3 }],
      thresholds: { maxInk: 0.8, swell: 0.08, proposals: 500 },
    },

    /** Long lines like the contours of a map. */
    contours: {
      ...hatching,
      ...STROKE_WIDTHS.contours,
      length: [0.5, 1.5],
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
      ...STROKE_WIDTHS.dashes,
      length: [0.045, 0.09],
      taper: 5,
      slope: 0.09,
      bow: 0,
      wave: 0,
      maxInk: 0.9,
      proposals: 80,
      thresholds: { maxInk: 0.6, swell: 0.08, proposals: 80 },
    },

    /** Dots. */
    stippling: { ...stippling, ...STROKE_WIDTHS.stippling },

    /** Soft grey strokes on paper with a fine grain. */
    pencil: {
      ...hatching,
      ...STROKE_WIDTHS.pencil,
      length: [0.22, 0.5],
      widthSpread: 0.25,
      taper: 30,
      slope: 0.05,
      bow: 0.006,
      wave: 0.004,
      maxInk: 0.8,
      proposals: 120,
      thresholds: { maxInk: 0.66, swell: 0.15, proposals: 200 },
      grain: { radius: 1, edge: 2, contrast: 1.6, pressure: [0.6, 1.5], streak: 9, roughness: 0.22 },
    },

    /** Broad crumbling strokes on rough paper. */
    charcoal: {
      ...hatching,
      ...STROKE_WIDTHS.charcoal,
      length: [0.16, 0.42],
      widthSpread: 0.25,
      taper: 16,
      slope: 0.1,
      bow: 0.01,
      wave: 0.006,
      maxInk: 0.84,
      proposals: 60,
      thresholds: { maxInk: 0.5, swell: 0.25, proposals: 100 },
      grain: { radius: 1, edge: 2.5, contrast: 5, pressure: [0.7, 1.5], streak: 7, roughness: 0.36 },
    },

    /** Thick wedges as cut into wood, which close until only slivers of paper remain. */
    woodcut: {
      ...hatching,
      ...STROKE_WIDTHS.woodcut,
      length: [0.2, 0.46],
      widthSpread: 0.15,
      taper: 90,
      slope: 0.03,
      bow: 0.004,
      wave: 0.002,
      proposals: 300,
      thresholds: { maxInk: 0.46, swell: 0.3, proposals: 300 },
    },
  }) as const satisfies Record<StrokeStyleName, StrokeStyle>;

/** The styles that the generator can draw. */
export const strokeStyles = /* @__PURE__ */ makeStyles();
