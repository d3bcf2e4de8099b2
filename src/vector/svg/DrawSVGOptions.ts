import { Color, type ColorRepresentation, type Plane } from 'three';
import { HIDDEN_OUTLINES, type HiddenOutlines } from '../../look/hiddenOutlines.js';
import { checkNumber } from '../../material/checkNumber.js';
import { checkColor } from '../../material/checkProperty.js';
import { checkOptions, type TaskOptions } from '../../worker/TaskOptions.js';
import type { DrawingPlan } from '../DrawnScene.js';
import { PEN_LAYERS, PEN_PARTS, type Pen, type PenLayers, type PenPart, type PenPlan } from '../plot/pens.js';
import { PLOTTERS, type PlotterName, type PlotterSpeeds } from '../plot/plotTime.js';
import type { SurfaceLines } from '../streamlines/SurfaceLines.js';
import { isSide, lyingSize, SHEET_WORDS, type SheetName, sheetNamed } from './sheetSizes.js';

/** Default duration of an animated drawing. */
const ANIMATION_SECONDS = 12;

/** Options of `drawSVG`. Lengths are in millimetres. A worker of `createWorker` runs `three-hatching/svg.worker`. */
export interface DrawSVGOptions extends TaskOptions {
  /**
   * `'print'`: filled outlines, whose width is the tone. `'pen'`: lines of one width for a plotter, whose number is the tone. Default:
   * `'print'`.
   */
  kind?: 'print' | 'pen' | undefined;
  /**
   * The sheet: a name, turned to suit the camera's picture unless followed by `portrait` or `landscape`; or a size, as `'200x150'` in
   * millimetres or `'8.5x11in'`; or width and height. Sides are from 1 to 5000 mm. Default: `'A4'`.
   */
  sheet?: SheetName | (string & {}) | readonly [width: number, height: number] | undefined;
  /** The blank margin around the picture, 0 or more. Default: 10. */
  margin?: number | undefined;
  /**
   * The width of the pen, above 0, with `kind: 'pen'`; or a width for some of `outlines`, `hidden` outlines, `lines`, `background` and `dots`.
   * Default: 0.3.
   */
  penWidth?: number | Readonly<Partial<Record<PenPart, number>>> | undefined;
  /**
   * With `kind: 'pen'`, what has a layer of its own: each kind of lines (`'layer'`), each `'ink'`, `'material'` or `'part'`, which is a mesh by its name; or the pens
   * of the plotter, to whose colours those of surfaces and inks are matched: each pen has a layer, which begins with a pause. Default: `'layer'`.
   */
  pens?: PenLayers | readonly PlotterPen[] | undefined;
  /** Metres of line after which a layer pauses, so that the pen can be filled, above 0, with `kind: 'pen'`. Default: never. */
  refill?: number | undefined;
  /** The plotter whose time is estimated, with `kind: 'pen'`: a name or its speeds. Default: `'axidraw'`. */
  plotter?: PlotterName | PlotterSpeeds | undefined;
  /** `'pen'`: the result has a file for each pen, too, with `kind: 'pen'`. Default: none. */
  split?: 'pen' | undefined;
  /**
   * With `kind: 'pen'`, text in the lower margin that plotters leave out, in a layer whose name begins with `%`: the pen, the paths, their length and the time
   * of each layer, below words of your own if a text is given. Default: false.
   */
  note?: boolean | string | undefined;
  /** Whether the result has the drawing in DXF, too, with `kind: 'pen'`. Default: false. */
  dxf?: boolean | undefined;
  /**
   * With `kind: 'pen'`, where engraved lines lie. `'even'`: along the directions of the canvas, but placed on the sheet, each in the middle
   * between its neighbours and as far from them as the tone asks for. `'canvas'`: just where the canvas has them, where every other one ends
   * as the tone gets lighter. Default: `'even'`.
   */
  lines?: 'even' | 'canvas' | undefined;
  /**
   * With `kind: 'pen'` and even lines, for frames of a moving picture: the drawing of the frame before, whose lines stay where they are on the surface as far as they
   * fit, or null for the first frame. Default: each drawing is made for itself.
   */
  before?: { surfaceLines: readonly SurfaceLines[] | null } | null | undefined;
  /**
   * With `kind: 'pen'`, lines shorter than this are left out, 0 or more: each would take the pen a lift. Dashes are lines of their own. Default:
   * 1.
   */
  shortest?: number | undefined;
  /**
   * With `kind: 'pen'`, the greatest number of times that pens pass over a place of the paper, 1, 2 or 3: beyond it lines that cross and dots are left
   * out, so that paper gets no wetter. Outlines come before lines. Default: 2.
   */
  maxPasses?: number | undefined;
  /**
   * The width of the thinnest line that a press can hold, 0 or more, with `kind: 'print'`: thinner lines become dashes of this width with
   * the same tone. 0 lets lines taper to nothing. Default: 0.05.
   */
  leastWidth?: number | undefined;
  /**
   * CSS pixels per inch of the sheet, above 0 and up to 2400, which the sizes of materials and outlines are converted by. More makes finer
   * lines. Default: 96, as in CSS.
   */
  dpi?: number | undefined;
  /**
   * Whether lights with `castShadow` cast shadows on meshes with `receiveShadow`: `'soft'` or true, as soft as on the canvas; `'hard'`,
   * with one ray instead of some 25; or false. Default: true.
   */
  shadows?: boolean | 'hard' | 'soft' | undefined;
  /** `'travel'`: a short way of the lifted pen. `'drawn'`: the order in which lines were found. Default: `'travel'`. */
  order?: 'travel' | 'drawn' | undefined;
  /**
   * Outlines and creases behind a surface, in a layer of their own: `'none'`, `'dashed'` or `'faint'`. Default: as each
   * `HatchingOutlineMaterial` has it.
   */
  hidden?: HiddenOutlines | undefined;
  /**
   * Duration in seconds, above 0, in which the drawing draws itself on a web page, path by path; true for 12. Users who prefer reduced
   * motion see the whole at once. Default: false.
   */
  animate?: number | boolean | undefined;
  /** The colour of a rectangle below the drawing; a pen would draw its border. Default: none. */
  paper?: ColorRepresentation | null | undefined;
  /**
   * A picture below the lines, in a layer of its own, as large as the camera's view, for strokes that cannot be drawn as lines: a data URL
   * of a PNG or JPEG, such as of the canvas. Only with `kind: 'print'`. Default: none.
   */
  picture?: string | null | undefined;
  /** Planes that clip everything, like those of a renderer; those of materials always clip. World space. Default: none. */
  clippingPlanes?: readonly Plane[] | undefined;
}

/** A pen of a plotter. */
export interface PlotterPen {
  color: ColorRepresentation;
  /** Millimetres, above 0. Default: that of `penWidth`. */
  width?: number | undefined;
  /** Default: the colour, if it is a text. */
  name?: string | undefined;
  /** Percent of the greatest speed, from 1 to 100. Default: the setting of the plotter. */
  speed?: number | undefined;
}

/** Options that only a plotter's drawing has. */
const FOR_PENS = {
  penWidth: 'Leave it out, or draw with a pen',
  lines: 'A print has the lines of the canvas',
  before: 'A print has the lines of the canvas, which keep their places',
  shortest: 'A print has no lifts',
  maxPasses: 'A print lays its inks down at once',
  pens: 'A print has an ink for each layer',
  refill: 'A print needs no ink again',
  plotter: 'A print takes no time to plot',
  split: 'A print has no pens',
  note: 'A print has no pens to tell of',
  dxf: 'A print is made of areas',
} as const;

const NAMES = {
  kind: true,
  sheet: true,
  margin: true,
  penWidth: true,
  pens: true,
  refill: true,
  plotter: true,
  split: true,
  note: true,
  dxf: true,
  lines: true,
  before: true,
  shortest: true,
  maxPasses: true,
  leastWidth: true,
  dpi: true,
  shadows: true,
  order: true,
  paper: true,
  hidden: true,
  animate: true,
  picture: true,
  clippingPlanes: true,
} satisfies Record<Exclude<keyof DrawSVGOptions, keyof TaskOptions>, true>;

/**
 * Checks the options.
 *
 * @param isWide whether the camera's picture is wider than high
 * @throws TypeError or RangeError that names the wrong one
 */
export function planOf(options: DrawSVGOptions, isWide = false): DrawingPlan {
  checkOptions('drawSVG', options, NAMES);
  const { kind = 'print', sheet = 'A4', order = 'travel', shadows = true, paper = null, picture = null } = options;
  checkChoice('kind', kind, ['print', 'pen']);
  checkChoice('order', order, ['travel', 'drawn']);
  if (options.hidden !== undefined) checkChoice('hidden', options.hidden, HIDDEN_OUTLINES);
  if (typeof shadows !== 'boolean' && shadows !== 'hard' && shadows !== 'soft')
    throw new TypeError("drawSVG: shadows must be true, 'soft', 'hard' or false, or left out.");
  checkPlanes(options.clippingPlanes ?? []);
  const isPen = kind === 'pen';
  for (const [name, why] of Object.entries(FOR_PENS) as [keyof typeof FOR_PENS, string][])
    if (!isPen && options[name] !== undefined) throw new TypeError(`drawSVG: ${name} is only for kind: 'pen'. ${why}.`);
  if (options.lines !== undefined) checkChoice('lines', options.lines, ['even', 'canvas']);
  if (isPen && options.leastWidth !== undefined)
    throw new TypeError("drawSVG: leastWidth is only for kind: 'print'. A pen has one width.");
  if (isPen && paper !== null)
    throw new TypeError("drawSVG: paper is only for kind: 'print'. A pen would draw the border of the sheet.");
  if (picture !== null) checkPicture(picture, isPen);
  if (paper !== null) checkColor('drawSVG: paper', paper);
  const [width, height] = sizeOf(sheet, isWide);
  const margin = checkNumber('margin', options.margin ?? 10, { from: 0 }, 'drawSVG');
  if (2 * margin >= Math.min(width, height))
    throw new RangeError(`drawSVG: a margin of ${margin} mm leaves nothing of a sheet of ${width} × ${height} mm.`);
  return {
    ...{ width, height, margin, order },
    pens: isPen ? pensOf(options) : null,
    plotter: plotterOf(options.plotter ?? 'axidraw'),
    isSplit: isSplit(options.split),
    note: noteOf(options.note ?? false),
    hasDxf: checkBoolean('dxf', options.dxf ?? false),
    lines: isPen ? (options.lines ?? 'even') : 'canvas',
    before: beforeOf(options),
    shortest: checkNumber('shortest', options.shortest ?? 1, { from: 0 }, 'drawSVG'),
    maxPasses: checkPasses(options.maxPasses ?? 2),
    leastWidth: checkNumber('leastWidth', options.leastWidth ?? 0.05, { from: 0 }, 'drawSVG'),
    dpi: checkNumber('dpi', options.dpi ?? 96, { above: 0, to: 2400 }, 'drawSVG'),
    animate: secondsOf(options.animate ?? false),
    paper: paper === null ? null : `#${new Color(paper).getHexString()}`,
    picture,
  };
}

/** The width of a pen, millimetres. */
const PEN_WIDTH = 0.3;
/** How often pens may pass over a place. */
const PASSES: readonly number[] = [1, 2, 3];

const checkWidth = (name: string, width: number): number => checkNumber(name, width, { above: 0 }, 'drawSVG');

function pensOf({ penWidth = PEN_WIDTH, pens = 'layer', refill }: DrawSVGOptions): PenPlan {
  const widths = widthsOf(penWidth);
  const listed = typeof pens === 'string' ? [] : listedPens(pens, widths.lines);
  if (typeof pens === 'string') checkChoice('pens', pens, PEN_LAYERS);
  return {
    layers: typeof pens === 'string' ? pens : 'pen',
    pens: listed,
    widths,
    refill: refill === undefined ? null : 1000 * checkNumber('refill', refill, { above: 0 }, 'drawSVG'),
  };
}

function widthsOf(penWidth: NonNullable<DrawSVGOptions['penWidth']>): Record<PenPart, number> {
  const given = typeof penWidth === 'object' && penWidth !== null ? penWidth : null;
  for (const name of Object.keys(given ?? {})) checkChoice('a part of penWidth', name, PEN_PARTS);
  const widthOf = (part: PenPart): number =>
    given ? checkWidth(`penWidth.${part}`, given[part] ?? PEN_WIDTH) : checkWidth('penWidth', penWidth as number);
  return Object.fromEntries(PEN_PARTS.map((part) => [part, widthOf(part)])) as Record<PenPart, number>;
}

function listedPens(pens: readonly PlotterPen[], width: number): Pen[] {
  if (!Array.isArray(pens) || pens.length === 0 || pens.some((pen) => typeof pen !== 'object' || pen === null))
    throw new TypeError(`drawSVG: pens must be ${quoted(PEN_LAYERS)} or a list of pens, each with its color.`);
  const listed = pens.map((pen, i): Pen => {
    checkColor(`drawSVG: pens[${i}].color`, pen.color);
    const ink = `#${new Color(pen.color).getHexString()}`;
    const speed =
      pen.speed === undefined
        ? null
        : Math.round(checkNumber(`pens[${i}].speed`, pen.speed, { from: 1, to: 100 }, 'drawSVG'));
    return {
      name: String(pen.name ?? (typeof pen.color === 'string' ? pen.color : ink)),
      width: checkWidth(`pens[${i}].width`, pen.width ?? width),
      ...{ ink, speed },
    };
  });
  const twice = listed.find(({ ink }, i) => listed.findIndex((pen) => pen.ink === ink) < i);
  if (twice) throw new RangeError(`drawSVG: pens has the colour ${twice.ink} twice, so they cannot be told apart.`);
  return listed;
}

function plotterOf(plotter: NonNullable<DrawSVGOptions['plotter']>): PlotterSpeeds {
  if (typeof plotter === 'string') {
    checkChoice('plotter', plotter, Object.keys(PLOTTERS));
    return PLOTTERS[plotter];
  }
  if (typeof plotter !== 'object' || plotter === null)
    throw new TypeError(`drawSVG: plotter must be ${quoted(Object.keys(PLOTTERS))} or its speeds.`);
  const names = Object.keys(PLOTTERS.axidraw) as (keyof PlotterSpeeds)[];
  return Object.fromEntries(
    names.map((name) => {
      const limits = name === 'lift' ? { from: 0 } : { above: 0 };
      return [name, checkNumber(`plotter.${name}`, plotter[name] ?? PLOTTERS.axidraw[name], limits, 'drawSVG')];
    }),
  ) as unknown as PlotterSpeeds;
}

function beforeOf({ before }: DrawSVGOptions): readonly SurfaceLines[] | null {
  if (before === undefined) return null;
  if (before === null || before?.surfaceLines) return before?.surfaceLines ?? [];
  throw new TypeError(
    'drawSVG: before must be a drawing that was itself made with before, or null for the first frame.',
  );
}

function checkPasses(passes: number): number {
  if (PASSES.includes(passes)) return passes;
  throw new RangeError(`drawSVG.maxPasses: ${String(passes)} is not 1, 2 or 3.`);
}

function isSplit(split: unknown): boolean {
  if (split !== undefined) checkChoice('split', split, ['pen']);
  return split === 'pen';
}

function checkBoolean(name: string, value: unknown): boolean {
  if (typeof value === 'boolean') return value;
  throw new TypeError(`drawSVG: ${name} is ${String(value)}, but must be true or false.`);
}

function noteOf(note: boolean | string): string | null {
  if (typeof note === 'string') return note;
  if (typeof note === 'boolean') return note ? '' : null;
  throw new TypeError(`drawSVG: note is ${String(note)}, but must be true, false or a text.`);
}

function secondsOf(animate: number | boolean): number | null {
  if (typeof animate === 'boolean') return animate ? ANIMATION_SECONDS : null;
  return checkNumber('animate', animate, { above: 0 }, 'drawSVG');
}

/** A data URL without characters that XML would have to escape. */
const PICTURE = /^data:image\/(png|jpeg);base64,[A-Za-z0-9+/]+=*$/;

function checkPicture(picture: unknown, isPen: boolean): void {
  if (isPen) throw new TypeError("drawSVG: picture is only for kind: 'print'. A pen draws no pictures.");
  if (typeof picture === 'string' && PICTURE.test(picture)) return;
  throw new TypeError(
    'drawSVG: picture must be a data URL of a PNG or a JPEG in base64, such as canvas.toDataURL() gives.',
  );
}

function checkPlanes(planes: unknown): void {
  if (Array.isArray(planes) && planes.every((plane) => plane?.normal?.isVector3)) return;
  throw new TypeError('drawSVG: clippingPlanes must be a list of Planes of three.js, or left out.');
}

function checkChoice(name: string, value: unknown, choices: readonly string[]): void {
  if (choices.includes(value as string)) return;
  throw new TypeError(`drawSVG: ${name} is ${String(value)}, but must be ${quoted(choices)}.`);
}

const quoted = (choices: readonly string[]): string => choices.map((one) => `'${one}'`).join(' or ');

function sizeOf(sheet: unknown, isWide: boolean): readonly [number, number] {
  const named = typeof sheet === 'string' ? sheetNamed(sheet) : undefined;
  if (named) return lyingSize(named, isWide);
  const isSize = Array.isArray(sheet) && sheet.length === 2 && sheet.every(isSide);
  if (isSize) return sheet as unknown as readonly [number, number];
  throw new RangeError(
    `drawSVG: sheet is ${JSON.stringify(sheet)}, but must be ${SHEET_WORDS}, or [width, height] in millimetres.`,
  );
}
