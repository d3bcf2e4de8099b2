/** The speeds of a plotter. */
export interface PlotterSpeeds {
  /** Speed of the pen on the paper, above it, and on the paper at most, mm/s. */
  draw: number;
  travel: number;
  fastest: number;
  /** Acceleration on the paper, and above it, mm/s². */
  drawAcceleration: number;
  travelAcceleration: number;
  /** Seconds that raising and lowering the pen take together. */
  lift: number;
}

const INCH = 25.4;
/** The speed and the accelerations of an AxiDraw at 100 %, mm/s and mm/s². */
const AXIDRAW = { speed: (8.6979 * INCH) / 1.1, down: 40 * INCH, up: 60 * INCH };

/** Plotters by name. The AxiDraw as its software is set at first: 25 % of its speed on the paper, 75 % above it, 75 % of its acceleration. */
export const PLOTTERS = {
  axidraw: {
    draw: 0.25 * AXIDRAW.speed,
    travel: 0.75 * AXIDRAW.speed,
    fastest: AXIDRAW.speed,
    drawAcceleration: 0.75 * AXIDRAW.down,
    travelAcceleration: 0.75 * AXIDRAW.up,
    lift: 0.3,
  },
} as const satisfies Readonly<Record<string, PlotterSpeeds>>;

export type PlotterName = keyof typeof PLOTTERS;

/** A path of a pen. Millimetres. */
interface PlottedPath {
  length: number;
  /** Where the pen is lowered, and where it is lifted. */
  start: readonly [x: number, y: number];
  end: readonly [x: number, y: number];
}

/**
 * The times at which a plotter has drawn each of its paths, in order, from the upper left corner of the sheet, seconds. It starts and stops at the
 * ends of each path, and does not slow down in bends.
 *
 * @param percent of the plotter's greatest speed on the paper; null for its own setting
 */
export function plotTimes(
  paths: readonly PlottedPath[],
  plotter: PlotterSpeeds,
  percent: number | null = null,
): Float64Array {
  const speed = percent === null ? plotter.draw : (percent / 100) * plotter.fastest;
  const times = new Float64Array(paths.length);
  let seconds = 0;
  let place: readonly [number, number] = [0, 0];
  for (const [i, { length, start, end }] of paths.entries()) {
    const away = Math.hypot(start[0] - place[0], start[1] - place[1]);
    seconds += moveSeconds(away, plotter.travel, plotter.travelAcceleration) + plotter.lift;
    seconds += moveSeconds(length, speed, plotter.drawAcceleration);
    times[i] = seconds;
    place = end;
  }
  return times;
}

/** The time of a move from rest to rest: it speeds up and slows down evenly. */
function moveSeconds(length: number, speed: number, acceleration: number): number {
  const isShort = length < (speed * speed) / acceleration;
  return isShort ? 2 * Math.sqrt(length / acceleration) : length / speed + speed / acceleration;
}

/** A time of plotting in words, such as `about 24 min`. */
export function plottingTime(seconds: number): string {
  const minutes = Math.max(1, Math.round(seconds / 60));
  return minutes < 60 ? `about ${minutes} min` : `about ${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
