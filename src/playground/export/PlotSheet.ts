/** Pixels per millimetre of the sheet, and the most pixels of a canvas: larger sheets have fewer per millimetre. */
const PER_MILLIMETRE = 10;
const MOST_PIXELS = 12e6;
/** Milliseconds in which paths are drawn before the browser may answer its user. */
const SLICE = 8;
/** Rows of pixels that are coloured in one slice. */
const BAND = 64;
/** The grey that one pass adds to a pixel of the ink map, of 255. */
const PASS = 32;

/** Colours of the ink map: paper, one pass, two, and more. */
export const PASS_COLORS = ['#ffffff', '#c9c4b8', '#4d6f9e', '#d2382c'] as const;

/** A path of the plot. */
interface PlotPath {
  data: string;
  ink: string;
  /** Millimetres. */
  width: number;
}

/** The paths of an SVG document of `drawSVG` with `kind: 'pen'`, in the order of plotting, with its size in millimetres. */
export function readPlot(svg: string): { width: number; height: number; paths: PlotPath[] } {
  const [width, height] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(svg)!.slice(1).map(Number);
  const paths: PlotPath[] = [];
  let [ink, pen] = ['#000000', 0];
  for (const [, color, size, data] of svg.matchAll(/stroke="(#\w+)" stroke-width="([\d.]+)"|<path d="([^"]+)"/g)) {
    if (data === undefined) [ink, pen] = [color, Number(size)];
    else paths.push({ data, ink, width: pen });
  }
  return { width, height, paths };
}

/** A sheet of paper on a canvas, on which a plot is drawn path by path. Long drawing is done in slices; a later call ends an earlier one. */
export class PlotSheet {
  readonly canvas = document.createElement('canvas');
  private readonly context: CanvasRenderingContext2D;
  private readonly paths: readonly PlotPath[];
  /** Pixels per millimetre. */
  private readonly scale: number;
  /** The number of paths on the canvas; null while it shows the ink map. */
  private drawn: number | null = null;
  private calls = 0;

  /** @param paper the colour of the sheet */
  constructor(
    svg: string,
    private readonly paper: string,
  ) {
    const { width, height, paths } = readPlot(svg);
    this.paths = paths;
    this.scale = Math.min(PER_MILLIMETRE, Math.sqrt(MOST_PIXELS / (width * height)));
    Object.assign(this.canvas, { width: Math.round(width * this.scale), height: Math.round(height * this.scale) });
    this.context = this.canvas.getContext('2d', { willReadFrequently: true })!;
  }

  get count(): number {
    return this.paths.length;
  }

  /** Shows the first paths. @returns whether no later call came before the last of them */
  async show(count: number): Promise<boolean> {
    if (this.drawn === null || this.drawn > count) {
      this.clear(this.paper);
      this.drawn = 0;
    }
    return this.inSlices(this.drawn, count, (i) => {
      this.stroke(this.paths[i], this.paths[i].ink);
      this.drawn = i + 1;
    });
  }

  /**
   * Shows in colours how often pens pass over each place. A path that crosses itself passes once.
   *
   * @returns the share of the inked area with three passes or more; null if a later call came
   */
  async showPasses(): Promise<number | null> {
    this.drawn = null;
    this.clear('#000000');
    const grey = `rgb(${PASS} ${PASS} ${PASS})`;
    const isCounted = await this.inSlices(0, this.count, (i) => {
      this.context.globalCompositeOperation = 'lighter';
      this.stroke(this.paths[i], grey);
    });
    if (!isCounted) return null;
    const { width, height } = this.canvas;
    const counts = new Uint32Array(PASS_COLORS.length);
    const isColoured = await this.inSlices(0, Math.ceil(height / BAND), (band) => {
      const top = BAND * band;
      const pixels = this.context.getImageData(0, top, width, Math.min(BAND, height - top));
      colourPasses(pixels.data, counts);
      this.context.globalCompositeOperation = 'source-over';
      this.context.putImageData(pixels, 0, top);
    });
    const inked = counts[1] + counts[2] + counts[3];
    return isColoured ? counts[3] / Math.max(inked, 1) : null;
  }

  /** Stops drawing. */
  stop(): void {
    this.calls++;
  }

  private clear(color: string): void {
    const { context, canvas } = this;
    context.globalCompositeOperation = 'source-over';
    context.fillStyle = color;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }

  private stroke({ data, width }: PlotPath, color: string): void {
    const { context, scale } = this;
    context.setTransform(scale, 0, 0, scale, 0, 0);
    Object.assign(context, { strokeStyle: color, lineWidth: width, lineCap: 'round', lineJoin: 'round' });
    context.stroke(new Path2D(data));
    context.setTransform(1, 0, 0, 1, 0, 0);
  }

  /** Calls a function for each number, in slices. @returns whether no later call came before the last */
  private async inSlices(from: number, to: number, each: (i: number) => void): Promise<boolean> {
    const call = ++this.calls;
    let end = performance.now() + SLICE;
    for (let i = from; i < to; i++) {
      if (performance.now() > end) {
        await new Promise((go) => setTimeout(go));
        if (call !== this.calls) return false;
        end = performance.now() + SLICE;
      }
      each(i);
    }
    return true;
  }
}

/** Turns added greys into the colours of their passes, and counts the pixels of each. */
function colourPasses(data: Uint8ClampedArray, counts: Uint32Array): void {
  for (let i = 0; i < data.length; i += 4) {
    const passes = Math.min(Math.round(data[i] / PASS), PASS_COLORS.length - 1);
    counts[passes]++;
    const color = Number.parseInt(PASS_COLORS[passes].slice(1), 16);
    data[i] = color >> 16;
    data[i + 1] = (color >> 8) & 255;
    data[i + 2] = color & 255;
    data[i + 3] = 255;
  }
}
