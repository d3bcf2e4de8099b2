import type { PlotterPen } from 'three-hatching/svg';
import { type HatchingPreset, presets } from '../scene/presets.js';
import type { PenLayers } from '../vector/plot/pens.js';
import { SHEET_SIZES, SHEET_WORDS, type Sheet, sheetNamed } from '../vector/svg/sheetSizes.js';
import type { FileChangeKind } from '../viewer/files/common/fileChanges.js';
import { readOptions, shown, UsageError } from './readOptions.js';
import { metresOf, type PenWidths, penLayers, penWidths } from './readPens.js';
import { STANDARD } from './standardStreams.js';

/** The changes to a file that `--as-written` leaves out. */
const AS_WRITTEN = ['orientation', 'up', 'hidden', 'ceiling'] as const satisfies readonly FileChangeKind[];
type AsWritten = (typeof AS_WRITTEN)[number];

/** A direction in degrees: `azimuth` around the up axis, from the viewer's side to the right, and `elevation` above the horizon. */
interface DirectionInDegrees {
  azimuth: number;
  elevation: number;
}

/** One of the views that show the model best. */
export interface BestView {
  /** From 1 on. */
  rank: number;
}

/** The options of the command line that control the drawing: plain data, sent to the drawing thread. Lengths are in millimetres. */
export interface DrawingOptions {
  /** Undefined for the preset of the link, or else of the playground's first view. */
  preset: string | undefined;
  /** The hash of a playground link. */
  link: string | undefined;
  /** A direction, or a rank among the cameras of the file, then the views that show the model best; undefined for the view of the link, or else the best one. */
  view: DirectionInDegrees | BestView | undefined;
  /** The name of a camera of the model, or its number, counted from 1. */
  camera: string | undefined;
  /** Enlargement of the picture; at 1, the model fills it. */
  zoom: number;
  orthographic: boolean;
  light: DirectionInDegrees | undefined;
  /** Whether the model's own lights are used, if it has any. */
  usesFileLights: boolean;
  shadows: boolean | undefined;
  /** The up axis of the model; undefined to detect it. */
  up: 'y' | 'z' | 'x' | '-y' | '-z' | '-x' | undefined;
  /** The name of a material variant of the model, or its number, counted from 1. */
  variant: string | undefined;
  /** Changes that are not made to what the file says. */
  asWritten: readonly AsWritten[];
  /** Whether both sides of surfaces are drawn, also where a glTF file has one. */
  bothSides: boolean;
  /** Names of parts of the model that are hidden; `*` stands for any letters. */
  hide: readonly string[];
  /** Names of the only parts that are drawn; empty for all. */
  only: readonly string[];
  /** The format of the model as a file extension, where neither content nor name tells it. */
  format: string | undefined;
  /** The name of a clip of the model, or its number, counted from 1. */
  clip: string | undefined;
  /** The number of frames of a turn or of the clip; undefined for a single picture. */
  frames: number | undefined;
  kind: 'print' | 'pen';
  pen: PenWidths;
  pens: PenLayers | readonly PlotterPen[] | undefined;
  /** Metres after which a pen is filled again. */
  refill: number | undefined;
  /** Whether each pen has a file of its own. */
  isSplit: boolean;
  /** Whether a note in the margin tells of model, look and pens. */
  note: boolean;
  /** What is written. */
  written: 'svg' | 'dxf';
  /** Whether a pen's lines are placed evenly or lie as on the canvas; undefined for the default. */
  lines: 'even' | 'canvas' | undefined;
  /** Shorter lines of a pen are left out, millimetres; undefined for the default. */
  shortest: number | undefined;
  /** How often pens may pass over a place; undefined for the default. */
  maxPasses: number | undefined;
  sheet: Sheet;
  margin: number;
  dpi: number;
  /** `#rrggbb`, or undefined for none. */
  paper: string | undefined;
  order: 'travel' | 'drawn';
  /** How hidden outlines are drawn; undefined for the setting of the look. */
  hidden: 'none' | 'dashed' | 'faint' | undefined;
  /** Seconds in which the SVG draws itself on a web page; undefined for a still drawing. */
  animate: number | undefined;
}

/** A number in decimal notation; NaN for anything else, also where JavaScript's `Number` accepts it, such as `0x10` or blanks. */
const numberOf = (text: string): number =>
  /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i.test(text) ? Number(text) : Number.NaN;

/** Directions by name. `iso` is the isometric view. */
const NAMED: Readonly<Record<string, DirectionInDegrees>> = {
  front: { azimuth: 0, elevation: 0 },
  back: { azimuth: 180, elevation: 0 },
  left: { azimuth: -90, elevation: 0 },
  right: { azimuth: 90, elevation: 0 },
  top: { azimuth: 0, elevation: 90 },
  bottom: { azimuth: 0, elevation: -90 },
  iso: { azimuth: 45, elevation: (180 / Math.PI) * Math.atan(Math.SQRT1_2) },
};

const NAMES = Object.keys(NAMED);

/** The views that are found for a model, by name. */
const BEST: Readonly<Record<string, BestView>> = {
  auto: { rank: 1 },
  auto2: { rank: 2 },
  auto3: { rank: 3 },
  auto4: { rank: 4 },
};

/**
 * Parses the view: a name, or azimuth and elevation in degrees.
 *
 * @throws UsageError if it is neither
 */
function viewOf(text: string | undefined): DrawingOptions['view'] {
  return BEST[text?.trim().toLowerCase() ?? ''] ?? directionOf('view', text, ['auto to auto4', ...NAMES]);
}

/**
 * Parses the direction after an option: a name, or azimuth and elevation in degrees.
 *
 * @throws UsageError if it is neither
 */
function directionOf(
  option: string,
  text: string | undefined,
  names: readonly string[] = NAMES,
): DirectionInDegrees | undefined {
  if (text === undefined) return undefined;
  const plain = text.trim().toLowerCase();
  if (NAMES.includes(plain)) return NAMED[plain];
  const [azimuth, elevation, ...rest] = plain.split(/[\s,]+/).map(numberOf);
  const isThere = rest.length === 0 && Math.abs(azimuth) <= 360 && Math.abs(elevation) <= 90;
  if (isThere) return { azimuth, elevation };
  throw new UsageError(
    `--${option} is "${text}", but must be two numbers in quotes, as "25 8": degrees around the model, from -360 to 360, and degrees above it, from -90 to 90; or ${names.slice(0, -1).join(', ')} or ${names.at(-1)}.`,
  );
}

/** A parsed command line of `draw`. */
type DrawRequest =
  | { action: 'help' }
  | { action: 'version' }
  | { action: 'draw'; models: string[]; out: string; force: boolean; jobs: number; options: DrawingOptions };

const OPTIONS = {
  preset: { type: 'string' },
  link: { type: 'string' },
  view: { type: 'string' },
  camera: { type: 'string' },
  zoom: { type: 'string' },
  orthographic: { type: 'boolean' },
  light: { type: 'string' },
  'no-file-lights': { type: 'boolean' },
  shadows: { type: 'boolean' },
  'no-shadows': { type: 'boolean' },
  up: { type: 'string' },
  variant: { type: 'string' },
  'as-written': { type: 'string' },
  'both-sides': { type: 'boolean' },
  hide: { type: 'string', multiple: true },
  only: { type: 'string', multiple: true },
  clip: { type: 'string' },
  frames: { type: 'string' },
  kind: { type: 'string' },
  pen: { type: 'string' },
  pens: { type: 'string' },
  refill: { type: 'string' },
  split: { type: 'string' },
  note: { type: 'boolean' },
  lines: { type: 'string' },
  shortest: { type: 'string' },
  'max-passes': { type: 'string' },
  sheet: { type: 'string' },
  margin: { type: 'string' },
  dpi: { type: 'string' },
  paper: { type: 'string' },
  order: { type: 'string' },
  hidden: { type: 'string' },
  animate: { type: 'string' },
  out: { type: 'string' },
  force: { type: 'boolean' },
  jobs: { type: 'string' },
  format: { type: 'string' },
  help: { type: 'boolean', short: 'h' },
  version: { type: 'boolean' },
} as const;

/** Whether a technique draws lines or dots. All others are raster pictures, which SVG cannot hold. */
const isLined = (technique = ''): boolean => ['engraving', 'pen', 'woodcut', 'stipple'].includes(technique);

/** The presets that are drawn as lines or dots. */
const LINED = Object.entries<HatchingPreset>(presets)
  .filter(([, { material }]) => isLined(material.technique))
  .map(([name]) => name);

/** The file extensions that are read, as `--format` takes them. Listed here because the readers are loaded in the drawing threads alone. */
export const FORMAT_ENDINGS: readonly string[] = [
  ...['glb', 'gltf', 'obj', 'fbx', 'dae', 'usdz', 'usdc', 'usda', 'usd', '3mf', '3ds', 'wrl', 'ply', 'stl', 'off'],
  'zip',
];

const AXES = ['y', 'z', 'x', '-y', '-z', '-x'] as const;

/** What is drawn where an option is left out. */
const DEFAULTS = { zoom: 1, pen: 0.3, sheet: 'A4', margin: 10, dpi: 96, order: 'travel', jobs: 1 } as const;

export const DRAW_HELP = `three-hatching draw: draws models as SVG files, for print or for a plotter's pen.

  npx three-hatching draw model.glb --preset engraving --view "25 8" --light "-45 40" --sheet A4 --out drawing.svg
  npx three-hatching draw "models/*.stl" --pen 0.3 --out "plots/{name}.svg" --jobs 4

It reads GLB, glTF, OBJ, PLY, STL, FBX, DAE, USDZ, 3MF, 3DS, VRML and OFF files, also packed with gzip or in a ZIP;
- is the standard input.

  --preset <name>          the look: ${LINED.join(', ')} (default engraving)
  --link <address>         the look, view and lights of a link of the playground; nothing is fetched
  --view "<around> <up>"   where the eye is: degrees around the model and above it; or front, back, left, right,
                           top, bottom or iso; or auto, auto2, auto3 or auto4: the first camera of the file, or
                           else the best view that is found for the model, and others (default auto)
  --camera <name>          draws from this camera of a glTF file; its number will do
  --zoom <factor>          how much larger than to fill the sheet (default ${DEFAULTS.zoom})
  --orthographic           without perspective
  --light "<around> <up>"  where the light is, as the eye (default: as the file has it, or else where it suits the view)
  --no-file-lights         puts the light where it suits the view also where a glTF file has lights
  --shadows, --no-shadows  whether the light casts shadows (default: as the look has it, which is yes)
  --up <axis>              the axis that points up: y, z, x, -y, -z or -x (default: as the format has it)
  --kind <print|pen>       filled lines, or lines for one pen (default print)
  --pen <mm>               the width of the pen; draws for a pen (default ${DEFAULTS.pen}); or several widths, as
                           "0.3, outlines 0.5", for outlines, hidden, lines, background or dots
  --pens <layers>          a layer for each ink, material or part, or for each of your pens, as "black 0.3, red 0.5",
                           to which colours are matched: a plotter pauses before it (default layer: each kind of lines)
  --refill <metres>        pauses after so many metres of line, as 40m, to fill the pen
  --split pen              a file for each pen
  --note                   tells of the pens and their time in the margin, in a layer that plotters leave out
  --lines <even|canvas>    lines of a pen evenly apart, or just those of the canvas (default even)
  --shortest <mm>          leaves out lines of a pen that are shorter, as each takes a lift (default 1)
  --max-passes <1|2|3>     leaves out lines and dots where pens have passed so often already (default 2)
  --sheet <size>           ${Object.keys(SHEET_SIZES).join(', ')}, turned to suit the model;
                           "A4 landscape" or "A4 portrait"; or as 200x150 in millimetres or 8.5x11in (default ${DEFAULTS.sheet})
  --margin <mm>            what stays blank on all sides (default ${DEFAULTS.margin})
  --dpi <number>           CSS pixels to an inch: more makes finer lines (default ${DEFAULTS.dpi})
  --paper <#rrggbb>        a rectangle of this colour below the drawing, in print
  --order <travel|drawn>   paths for a short way of the pen, or as they were found (default ${DEFAULTS.order})
  --hidden <kind>          outlines behind surfaces: none, dashed or faint (default: as the look has them)
  --animate <seconds>      files that draw themselves on a web page
  --frames <count>         numbered files of a turn of the model, or of its clip
  --hide <name>            leaves out a part of the model; may be given several times, and * stands for any letters
  --only <name>            draws this part alone; as --hide
  --variant <name>         a variant of the materials of a glTF file; its number will do
  --as-written <kinds>     leaves the model as its file says: orientation, up, hidden or ceiling, or several with commas
                           (default: triangles that face inward are turned, models stand, hidden parts and ceilings are left out)
  --both-sides             draws both sides of surfaces, also where a glTF file has one
  --clip <name>            poses the model by this clip; its number will do
  --format <name>          the format of a model that does not tell it: stl, obj, …; or dxf, to write lines of a pen in DXF
  --out <file>             the SVG file to write to, or a DXF file; - is the standard output;
                           for several models a folder, or a name with {name} and {frame}
  --force                  replaces files
  --jobs <count>           how many models are drawn at a time (default ${DEFAULTS.jobs})
  --help                   prints this text
  --version                prints the version of three-hatching

Of an option that is given twice the last value counts, except of --hide and --only.
`;

/**
 * Parses the command line of `draw`.
 *
 * @param args the arguments after the name of the command
 * @throws UsageError if they are not valid
 */
export function parseDrawing(args: readonly string[]): DrawRequest {
  const { values, positionals: models } = readOptions(args, OPTIONS, 'draw --help');
  if (values.help || args.length === 0) return { action: 'help' };
  if (values.version) return { action: 'version' };
  if (models.length === 0) throw new UsageError('There is no model to draw; name a file after draw.');
  if (!values.out?.trim()) throw new UsageError('--out is missing; name the file to write the drawing to.');
  const written = isDxf(values) ? 'dxf' : 'svg';
  const forPens = PEN_OPTIONS.filter((name) => values[name] !== undefined);
  const kind =
    choice('kind', values.kind, ['print', 'pen']) ?? (forPens.length > 0 || written === 'dxf' ? 'pen' : 'print');
  if (kind === 'print' && forPens.length > 0)
    throw new UsageError(`--${forPens[0]} and --kind print exclude each other; pass only one of them.`);
  if (kind === 'print' && written === 'dxf')
    throw new UsageError(
      'A DXF file holds lines of a pen, not areas of a print; leave out --kind, or name a file that ends in .svg.',
    );
  if (values.camera !== undefined && values.view !== undefined)
    throw new UsageError('--camera and --view exclude each other; pass only one of them.');
  if (kind === 'pen' && values.paper !== undefined)
    throw new UsageError('--paper is for print; a pen would draw the border of the sheet.');
  if (kind !== 'pen' && values.lines !== undefined)
    throw new UsageError('--lines is for a pen; a print has the lines of the canvas. Pass --kind pen, or --pen.');
  if (kind !== 'pen' && values.shortest !== undefined)
    throw new UsageError('--shortest is for a pen; a print has no lifts. Pass --kind pen, or --pen with its width.');
  if (kind !== 'pen' && values['max-passes'] !== undefined)
    throw new UsageError(
      '--max-passes is for a pen; a print wets paper once. Pass --kind pen, or --pen with its width.',
    );
  if (values.shadows && values['no-shadows'])
    throw new UsageError('--shadows and --no-shadows exclude each other; pass only one of them.');
  const sheet = sheetOf(values.sheet ?? DEFAULTS.sheet);
  const margin = number('margin', values.margin, { least: 0, most: 1000 }) ?? DEFAULTS.margin;
  if (2 * margin >= Math.min(...sheet.size))
    throw new UsageError(`--margin is ${margin}, which leaves nothing of a sheet of ${sheet.size.join(' × ')} mm.`);
  const link = linkOf(values.link);
  if (link !== undefined && values.preset === undefined) checkLines(link);
  const options: DrawingOptions = {
    preset: presetOf(values.preset),
    view: viewOf(values.view),
    camera: nameOf('camera', values.camera),
    zoom: number('zoom', values.zoom, { least: 0.05, most: 100 }) ?? DEFAULTS.zoom,
    orthographic: values.orthographic ?? false,
    light: directionOf('light', values.light),
    usesFileLights: !values['no-file-lights'],
    shadows: values['no-shadows'] ? false : values.shadows,
    up: choice('up', values.up, AXES),
    variant: nameOf('variant', values.variant),
    asWritten: asWrittenOf(values['as-written']),
    bothSides: values['both-sides'] ?? false,
    hide: namesOf('hide', values.hide),
    only: namesOf('only', values.only),
    format: values.format?.trim().toLowerCase() === 'dxf' ? undefined : formatOf(values.format),
    clip: nameOf('clip', values.clip),
    frames: whole('frames', values.frames, 9999),
    pen: penWidths(values.pen) ?? DEFAULTS.pen,
    pens: penLayers(values.pens),
    refill: metresOf('refill', values.refill),
    isSplit: choice('split', values.split, ['pen']) === 'pen',
    note: values.note ?? false,
    lines: choice('lines', values.lines, ['even', 'canvas']),
    shortest: number('shortest', values.shortest, { least: 0, most: 1000 }),
    maxPasses: passesOf(values['max-passes']),
    dpi: number('dpi', values.dpi, { least: 10, most: 1200 }) ?? DEFAULTS.dpi,
    paper: colour(values.paper),
    order: choice('order', values.order, ['travel', 'drawn']) ?? DEFAULTS.order,
    hidden: choice('hidden', values.hidden, ['none', 'dashed', 'faint']),
    animate: number('animate', values.animate, { least: 0.1, most: 3600 }),
    ...{ link, kind, sheet, margin, written },
  };
  if (options.isSplit && (written === 'dxf' || values.out.trim() === STANDARD))
    throw new UsageError(
      '--split pen writes several SVG files; name a file that ends in .svg, or a folder, after --out.',
    );
  if (options.note && written === 'dxf')
    throw new UsageError('--note is text of an SVG file; leave it out, or name a file that ends in .svg.');
  const jobs = whole('jobs', values.jobs, 64) ?? DEFAULTS.jobs;
  return { action: 'draw', models, out: values.out, force: values.force ?? false, jobs, options };
}

function passesOf(text: string | undefined): number | undefined {
  const passes = choice('max-passes', text, ['1', '2', '3']);
  return passes && Number(passes);
}

/** Options that only a pen's drawing has, and that ask for one. */
const PEN_OPTIONS = ['pen', 'pens', 'refill', 'split', 'note'] as const;

/** Whether DXF is written, by the name of the file or the format. */
const isDxf = ({ out, format }: { out?: string | undefined; format?: string | undefined }): boolean =>
  /\.dxf$/i.test(out?.trim() ?? '') || format?.trim().toLowerCase() === 'dxf';

function presetOf(text: string | undefined): string | undefined {
  if (text === undefined) return undefined;
  const name = Object.keys(presets).find((one) => one.toLowerCase() === text.trim().toLowerCase()) ?? text;
  if (LINED.includes(name)) return name;
  const reason = Object.hasOwn(presets, name)
    ? 'whose strokes are a picture and cannot leave as lines'
    : 'which is not a preset';
  throw new UsageError(`--preset is ${shown(name)}, ${reason}; use one of ${LINED.join(', ')}.`);
}

/** A format as a file extension: in lower case, without a dot. */
function formatOf(text: string | undefined): string | undefined {
  const format = text?.trim().toLowerCase().replace(/^\./, '');
  if (format === undefined || FORMAT_ENDINGS.includes(format)) return format;
  if (format === 'vrml') return 'wrl';
  throw new UsageError(
    `--format is ${shown(text)}, but must be ${FORMAT_ENDINGS.slice(0, -1).join(', ')} or ${FORMAT_ENDINGS.at(-1)}.`,
  );
}

/** The name or number after an option that selects a part of the file. */
function nameOf(option: string, text: string | undefined): string | undefined {
  if (text === undefined || text.trim() !== '') return text;
  throw new UsageError(`--${option} is ${shown(text)}, but must be a name, or a number from 1 on.`);
}

/** The kinds of changes after `--as-written`. */
function asWrittenOf(text: string | undefined): readonly AsWritten[] {
  const kinds = text?.split(',') ?? [];
  return [...new Set(kinds.map((kind) => choice('as-written', kind, AS_WRITTEN)!))];
}

/** The names of parts after an option that may be given several times. */
function namesOf(option: string, texts: readonly string[] = []): readonly string[] {
  if (texts.every((text) => text.trim() !== '')) return texts;
  throw new UsageError(`--${option} is ${shown('')}, but must be the name of a part.`);
}

/** The hash of a link, which may also be given alone. */
function linkOf(link: string | undefined): string | undefined {
  const hash = link?.slice(link.indexOf('#') + 1);
  if (hash === undefined || /^[\w%.~-]+=/.test(hash)) return hash;
  throw new UsageError('--link holds no drawing; copy the whole address of the playground, in quotes.');
}

/**
 * @throws UsageError if the link's look is not drawn as lines. Its technique is that of its preset unless the link overrides it
 */
function checkLines(link: string): void {
  const parameters = new URLSearchParams(link);
  const { material } =
    new Map<string, HatchingPreset>(Object.entries(presets)).get(parameters.get('preset') ?? '') ?? {};
  const technique = parameters.get('technique') ?? material?.technique;
  if (isLined(technique)) return;
  throw new UsageError(
    '--link is drawn with strokes that are a picture and cannot leave as lines; add --preset with one of its own, engraving, say.',
  );
}

function number(
  option: string,
  text: string | undefined,
  { least, most }: { least: number; most: number },
): number | undefined {
  if (text === undefined) return undefined;
  const value = numberOf(text);
  if (value >= least && value <= most) return value;
  throw new UsageError(`--${option} is ${shown(text)}, but must be a number from ${least} to ${most}.`);
}

function whole(option: string, text: string | undefined, most: number): number | undefined {
  if (text === undefined) return undefined;
  if (/^\d+$/.test(text) && Number(text) >= 1 && Number(text) <= most) return Number(text);
  throw new UsageError(`--${option} is ${shown(text)}, but must be a whole number from 1 to ${most}.`);
}

function choice<Choice extends string>(
  option: string,
  text: string | undefined,
  choices: readonly Choice[],
): Choice | undefined {
  if (text === undefined) return undefined;
  const found = choices.find((one) => one === text.trim().toLowerCase());
  if (found) return found;
  const others = choices.length > 1 ? `${choices.slice(0, -1).join(', ')} or ` : '';
  throw new UsageError(`--${option} is ${shown(text)}, but must be ${others}${choices.at(-1)}.`);
}

function colour(text: string | undefined): string | undefined {
  if (text === undefined || /^#[0-9a-f]{6}$/i.test(text)) return text?.toLowerCase();
  throw new UsageError(`--paper is ${shown(text)}, but must be a colour as "#f4f1e6", in quotes.`);
}

/**
 * The sheet for `--sheet`.
 *
 * @throws UsageError if none has that name
 */
export function sheetOf(text: string): Sheet {
  const sheet = sheetNamed(text);
  if (sheet) return sheet;
  throw new UsageError(`--sheet is ${shown(text)}, but must be ${SHEET_WORDS}.`);
}
