import type { PaperGrain } from './paperGrain.js';
import { rasterizeStroke } from './rasterizeStroke.js';
import type { Stroke } from './Stroke.js';
import { StrokeDensityField } from './StrokeDensityField.js';
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

/** Half the length, in tiles, of the region around the end of a stroke that other ends should avoid. */
const REACH_FORWARD = 0.15;

/**
 * The density of the ends of strokes of one direction at each place of a level.
 *
 * Where many strokes end side by side, small holes appear. They hardly change the density along a stroke, but they repeat with
 * every tile and catch the eye. If the ends keep apart, there are no holes.
 */
class StrokeEndField {
  private readonly columns: number;
  private readonly values: Float32Array;

  /** @param size texels per side of the level, a power of two */
  constructor(private readonly size: number) {
    this.columns = Math.min(size, 64);
    this.values = new Float32Array(size * this.columns);
  }

  /**
   * Adds both ends of a stroke.
   *
   * @param reach half the height of the region around each, in texels
   * @returns the number of cells visited
   */
  add(stroke: Stroke, reach: number): number {
    return this.addEnd(stroke, -0.5, reach) + this.addEnd(stroke, 0.5, reach);
  }

  /** The density at both ends of a stroke, summed; 1 is one other end at the same place. */
  atEnds(stroke: Stroke): number {
    return this.at(stroke, -0.5) + this.at(stroke, 0.5);
  }

  private addEnd(stroke: Stroke, end: number, reach: number): number {
    const { size, columns, values } = this;
    const forward = this.forward(stroke, end) * columns;
    const sideways = this.sideways(stroke, end) * size;
    const reachForward = REACH_FORWARD * columns;
    const lastColumn = Math.floor(forward + reachForward - 0.5);
    const firstRow = Math.ceil(sideways - reach - 0.5);
    const lastRow = Math.floor(sideways + reach - 0.5);
    let visited = 0;
    for (let column = Math.ceil(forward - reachForward - 0.5); column <= lastColumn; column++) {
      const x = (column + 0.5 - forward) / reachForward;
      const start = (column & (columns - 1)) * size;
      for (let row = firstRow; row <= lastRow; row++) {
        const y = (row + 0.5 - sideways) / reach;
        const inside = 1 - x * x - y * y;
        if (inside > 0) values[start + (row & (size - 1))] += inside * inside;
        visited++;
      }
    }
    return visited;
  }

  private at(stroke: Stroke, end: number): number {
    const { size, columns, values } = this;
    const column = Math.floor(this.forward(stroke, end) * columns) & (columns - 1);
    const row = Math.floor(this.sideways(stroke, end) * size) & (size - 1);
    return values[column * size + row];
  }

  private forward(stroke: Stroke, end: number): number {
    return (stroke.across ? stroke.v : stroke.u) + end * stroke.length;
  }

  private sideways(stroke: Stroke, end: number): number {
    return (stroke.across ? stroke.u : stroke.v) + end * stroke.length * stroke.slope;
  }
}
