import { Color, type ColorRepresentation, type Plane } from 'three';
import { checkNumber } from '../material/checkNumber.js';
import { checkColor } from '../material/checkValues.js';
import type { DrawingPlan } from '../vector/DrawnScene.js';
import { checkOptions } from '../worker/checkOptions.js';

/** Sheets by name, upright: width and height in millimetres. */
const SHEETS = { A3: [297, 420], A4: [210, 297], A5: [148, 210] } as const;

/** Options of `drawSVG`. Lengths are in millimetres. */
export interface DrawSVGOptions {
  /**
   * `'print'`: filled outlines, whose width is the tone. `'pen'`: lines of one width for a plotter, which make the tone by their number.
   * Default: `'print'`.
   */
  kind?: 'print' | 'pen' | undefined;
  /** The sheet: a name, which stands upright, or width and height above 0. Default: `'A4'`. */
  sheet?: keyof typeof SHEETS | readonly [width: number, height: number] | undefined;
  /** What stays blank around the picture, 0 or more. Default: 10. */
  margin?: number | undefined;
  /** The width of the pen, above 0, with `kind: 'pen'`. Default: 0.3. */
  penWidth?: number | undefined;
  /**
   * CSS pixels to an inch of the sheet, above 0: what the sizes of materials and outlines become on paper. More makes finer lines. Default:
   * 96, as CSS has it.
   */
  dpi?: number | undefined;
  /** Whether lights with `castShadow` cast shadows, which have hard edges, on meshes with `receiveShadow`. Default: true. */
  shadows?: boolean | undefined;
  /** `'travel'`: a short way of the lifted pen. `'drawn'`: the order in which lines were found. Default: `'travel'`. */
  order?: 'travel' | 'drawn' | undefined;
  /** The colour of a rectangle below the drawing; a pen would draw its border. Default: none. */
  paper?: ColorRepresentation | null | undefined;
  /** Planes that clip everything, as those of a renderer do; those of materials clip by themselves. World space. Default: none. */
  clippingPlanes?: readonly Plane[] | undefined;
  /** Aborts the drawing: the promise rejects with the reason of the signal. */
  signal?: AbortSignal | undefined;
  /** Called as the drawing goes on, with a number that rises to 1. */
  onProgress?: ((progress: number) => void) | undefined;
}

const NAMES = {
  kind: true,
  sheet: true,
  margin: true,
  penWidth: true,
  dpi: true,
  shadows: true,
  order: true,
  paper: true,
  clippingPlanes: true,
} satisfies Record<Exclude<keyof DrawSVGOptions, 'signal' | 'onProgress'>, true>;

/** Checks options. @throws TypeError or RangeError that names the wrong one */
export function planOf(options: DrawSVGOptions): DrawingPlan {
  checkOptions('drawSVG', options, NAMES);
  const { kind = 'print', sheet = 'A4', order = 'travel', shadows = true, paper = null } = options;
  checkChoice('kind', kind, ['print', 'pen']);
  checkChoice('order', order, ['travel', 'drawn']);
  if (typeof shadows !== 'boolean') throw new TypeError('drawSVG: shadows must be true or false, or left out.');
  checkPlanes(options.clippingPlanes ?? []);
  const isPen = kind === 'pen';
  if (!isPen && options.penWidth !== undefined)
    throw new TypeError("drawSVG: penWidth is only for kind: 'pen'. Leave it out, or draw with a pen.");
  if (isPen && paper !== null)
    throw new TypeError("drawSVG: paper is only for kind: 'print'. A pen would draw the border of the sheet.");
  if (paper !== null) checkColor('drawSVG: paper', paper);
  const [width, height] = sizeOf(sheet);
  const margin = checkNumber('margin', options.margin ?? 10, { from: 0 }, 'drawSVG');
  if (2 * margin >= Math.min(width, height))
    throw new RangeError(`drawSVG: a margin of ${margin} mm leaves nothing of a sheet of ${width} × ${height} mm.`);
  return {
    ...{ width, height, margin, order },
    pen: isPen ? checkNumber('penWidth', options.penWidth ?? 0.3, { above: 0 }, 'drawSVG') : null,
    dpi: checkNumber('dpi', options.dpi ?? 96, { above: 0 }, 'drawSVG'),
    paper: paper === null ? null : `#${new Color(paper).getHexString()}`,
  };
}

function checkPlanes(planes: unknown): void {
  if (Array.isArray(planes) && planes.every((plane) => plane?.normal?.isVector3)) return;
  throw new TypeError('drawSVG: clippingPlanes must be a list of Planes of three.js, or left out.');
}

function checkChoice(name: string, value: unknown, choices: readonly string[]): void {
  if (choices.includes(value as string)) return;
  throw new TypeError(
    `drawSVG: ${name} is ${String(value)}, but must be ${choices.map((one) => `'${one}'`).join(' or ')}.`,
  );
}

function sizeOf(sheet: unknown): readonly [number, number] {
  if (typeof sheet === 'string' && Object.hasOwn(SHEETS, sheet)) return SHEETS[sheet as keyof typeof SHEETS];
  const isSize = Array.isArray(sheet) && sheet.length === 2 && sheet.every((side) => side > 0 && side < Infinity);
  if (isSize) return sheet as unknown as readonly [number, number];
  throw new RangeError(
    `drawSVG: sheet is ${JSON.stringify(sheet)}, but must be ${Object.keys(SHEETS).join(', ')} or [width, height] in millimetres.`,
  );
}
