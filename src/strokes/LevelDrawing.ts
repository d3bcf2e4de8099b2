import type { PaperGrain } from './paperGrain.js';
import { rasterizeStroke } from './rasterizeStroke.js';
import type { Stroke } from './Stroke.js';
import { StrokeDensityField } from './StrokeDensityField.js';
import { StrokeEndField } from './StrokeEndField.js';
import type { StrokeStyle } from './StrokeStyle.js';

/** A level while its strokes are being placed. */
export interface LevelDrawing {
  /** Texels per side. */
  size: number;
  image: Uint8Array;
  /** 255·ink, summed over the image. */
  darkness: number;
  /** The grain of the paper, if the style has any. */
  grain: PaperGrain | undefined;
  /** The density of the strokes, for each layer of the style. */
  densities: StrokeDensityField[];
  /** The density of the ends of strokes, for each layer; empty for short strokes. */
  ends: StrokeEndField[];
  /** The ink drawn so far, for each layer, with overlaps counted twice. It keeps the layers at equal ink. */
  drawn: number[];
  /** The last stroke of each layer drawn for this level itself; only for hands that draw in bundles. */
  last: (Stroke | undefined)[];
  /** The share of the last stroke that fell on blank paper; for a stroke of a hand, its ink relative to that of its chord. */
  gain: number;
}

/** Lines influence each other up to this multiple of their mean distance. */
const LINE_REACH = 6;
/** Ends of lines influence each other up to this multiple of the mean distance of the lines. */
const END_REACH = 4;
/** Dots influence each other up to this multiple of their mean distance. */
const DOT_REACH = 3;

/** Largest ink of a wobbly stroke of a hand relative to that of its chord. */
const MOST_GAIN = 3;

/** Shorter strokes, in tiles, do not count as lines: the position of their ends does not matter. */
const SHORT = 0.15;

/** Creates a blank level of size² texels. */
export function startLevel(size: number, style: StrokeStyle, grain: PaperGrain | undefined): LevelDrawing {
  const { layers } = style;
  const short = style.length[1] < SHORT;
  return {
    size,
    image: new Uint8Array(size * size).fill(255),
    darkness: 0,
    grain,
    densities: layers.map(({ slope }) => new StrokeDensityField(size, short, slope, style.hand?.habit)),
    ends: short ? [] : layers.map(() => new StrokeEndField(size)),
    drawn: layers.map(() => 0),
    last: layers.map(() => undefined),
    gain: 1,
  };
}

/** The approximate number of texels that a stroke inks on blank paper. */
export const nominalArea = (width: number, length: number, size: number): number =>
  width * Math.max(width, length * size);

/** Draws a stroke on one level. Returns the number of cells visited. */
export function drawStroke(level: LevelDrawing, stroke: Stroke): number {
  const { size } = level;
  const { layer } = stroke;
  const gain = rasterizeStroke(level.image, size, stroke, level.grain);
  level.darkness += gain;
  const area = nominalArea(stroke.width, stroke.length, size);
  level.gain = Math.min(stroke.profile ? MOST_GAIN : 1, gain / (255 * area));
  level.drawn[layer] += area;
  // The reach is a few times the mean distance of strokes at this density; the first strokes influence the whole tile.
  const density = level.drawn[layer] / (size * size);
  const distance = stroke.length > 0 ? stroke.width / density : stroke.width / Math.sqrt(density);
  const reach = (times: number): number => Math.min(0.5 * size, times * distance);
  let work = area + level.densities[layer].add(stroke, reach(stroke.length > 0 ? LINE_REACH : DOT_REACH));
  if (level.ends.length > 0) work += level.ends[layer].add(stroke, reach(END_REACH));
  return work;
}
