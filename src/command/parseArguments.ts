import { readFileSync, statSync } from 'node:fs';
import { type HatchingPreset, presets } from '../scene/presets.js';
import { checkHand } from '../strokes/hand/checkHand.js';
import type { Hand } from '../strokes/hand/Hand.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import { strokeStyles } from '../strokes/strokeStyles.js';
import { type MapDrawing, resolveMapDrawing } from '../strokes/tamImages/hatchImageOptions.js';
import { readOptions, UsageError } from './readOptions.js';

/** A parsed command line. */
type Request =
  | { action: 'help' }
  | { action: 'version' }
  | { action: 'list' }
  | { action: 'draw'; map: MapDrawing; out: string; force: boolean };

const OPTIONS = {
  style: { type: 'string' },
  preset: { type: 'string' },
  hand: { type: 'string' },
  out: { type: 'string' },
  size: { type: 'string' },
  tones: { type: 'string' },
  levels: { type: 'string' },
  seed: { type: 'string' },
  'stroke-texels': { type: 'string' },
  force: { type: 'boolean' },
  list: { type: 'boolean' },
  help: { type: 'boolean', short: 'h' },
  version: { type: 'boolean' },
} as const;

/** The map that is drawn without any option. */
const MAP = resolveMapDrawing();

export const HELP = `three-hatching tam: draws a tonal art map into a folder of PNG images and a map.json.

  npx three-hatching tam --style woodcut --out maps/woodcut

  --style <name>          the style of the strokes; --list prints all (default ${MAP.style})
  --preset <name>         draws the map of a preset instead of a style
  --hand <file>           draws with the strokes of a hand, a JSON file, instead of a style
  --out <folder>          the folder to write to; it is created, and must not hold a map yet
  --size <texels>         side of the finest level: 64, 128, 256, 512 or 1024 (default ${MAP.size})
  --tones <count>         number of tones including blank paper, 4 to 16 (default ${MAP.tones})
  --levels <count>        number of levels, each half as large as the previous (default: down to 16 texels)
  --seed <number>         a whole number; each places the strokes differently (default ${MAP.seed})
  --stroke-texels <count> width of the strokes in texels (default: that of the style)
  --force                 replaces an existing map
  --list                  prints the names of the styles
  --help                  prints this text
  --version               prints the version of three-hatching

Load it with TonalArtMap.load('maps/woodcut/map.json').

three-hatching draw: draws models as SVG files for print and plotters; see npx three-hatching draw --help.
`;

/**
 * Reads the command line.
 *
 * @param args the arguments, without node and the script
 * @throws UsageError if they are not valid
 */
export function parseArguments(args: readonly string[]): Request {
  const { values, positionals } = readOptions(args, OPTIONS, '--help');
  const isHelp = values.help || args.length === 0 || (positionals.length === 1 && positionals[0] === 'help');
  if (isHelp) return { action: 'help' };
  if (values.version) return { action: 'version' };
  const [command, ...rest] = positionals;
  if (command !== 'tam')
    throw new UsageError(`"${command ?? ''}" is not a command; the commands are tam and draw. See --help.`);
  if (rest.length > 0) throw new UsageError(`"${rest[0]}" is an unexpected argument; name the folder after --out.`);
  if (values.list) return { action: 'list' };
  if (!values.out) throw new UsageError('--out is missing; name the folder to write the map to.');
  const map: MapDrawing = {
    ...mapOfPreset(values),
    ...handOf(values),
    ...(values.style !== undefined && { style: values.style as StrokeStyleName }),
    size: wholeNumber('size', values.size),
    tones: wholeNumber('tones', values.tones),
    levels: wholeNumber('levels', values.levels),
    seed: wholeNumber('seed', values.seed),
    strokeTexels: values['stroke-texels'] === undefined ? undefined : Number(values['stroke-texels']),
  };
  try {
    resolveMapDrawing(map);
  } catch (error) {
    throw new UsageError(
      (error as Error).message.replace(/^TonalArtMap\.generate: /, '--').replace('--strokeTexels', '--stroke-texels'),
    );
  }
  return { action: 'draw', map, out: values.out, force: values.force ?? false };
}

/** The hand for `--hand`, which replaces a style. */
function handOf({ hand, style, preset }: { hand?: string; style?: string; preset?: string }): MapDrawing {
  if (hand === undefined) return {};
  const other = style === undefined ? 'preset' : 'style';
  if ((style ?? preset) !== undefined) {
    throw new UsageError(`--hand and --${other} exclude each other; pass only one of them.`);
  }
  return { hand: readHand(hand) };
}

/** The map options of a preset. */
function mapOfPreset({ preset, style }: { preset?: string; style?: string }): MapDrawing {
  if (preset === undefined) return {};
  if (style !== undefined) throw new UsageError('--preset and --style exclude each other; pass only one of them.');
  const drawn = Object.entries<HatchingPreset>(presets).filter(([, { tonalArtMap }]) => tonalArtMap !== null);
  const found = drawn.find(([name]) => name === preset)?.[1].tonalArtMap;
  if (found) return { ...found };
  const reason = Object.hasOwn(presets, preset) ? 'which needs no map' : 'which is not a preset';
  throw new UsageError(`--preset is ${preset}, ${reason}; use one of ${drawn.map(([name]) => name).join(', ')}.`);
}

/** The names of the styles, one per line. */
export const styleList = (): string => `${Object.keys(strokeStyles).join('\n')}\n`;

function wholeNumber(option: string, text: string | undefined): number | undefined {
  if (text === undefined) return undefined;
  if (!/^-?\d+$/.test(text)) throw new UsageError(`--${option} is ${text}, but must be a whole number.`);
  return Number(text);
}

/** The maximum size of a file, in bytes: 100,000 points take less than a tenth of it. */
const MAX_BYTES = 64 * 2 ** 20;

/** Messages for error codes of the file system, about the file after --hand. */
const MEANINGS: Readonly<Record<string, string>> = {
  ENOENT: 'is not there; check the path after --hand',
  ENOTDIR: 'is not there; check the path after --hand',
  EISDIR: 'is a folder; name the JSON file of a hand after --hand',
  EACCES: 'may not be read; change its permissions',
  EPERM: 'may not be read; change its permissions',
};

/**
 * Reads the JSON file of a hand.
 *
 * @throws UsageError whose message is a sentence, if it cannot be read or is no hand
 */
function readHand(path: string): Hand {
  const text = readText(path);
  let hand: unknown;
  try {
    hand = JSON.parse(text);
  } catch {
    throw new UsageError(`${path} is not JSON; --hand needs a file with { version, strokes, numbers }.`);
  }
  try {
    checkHand(path, hand);
  } catch (error) {
    throw new UsageError((error as Error).message);
  }
  return hand;
}

function readText(path: string): string {
  try {
    const { size } = statSync(path);
    if (size > MAX_BYTES) throw new UsageError(`${path} is larger than 64 MB, more than any hand needs.`);
    return readFileSync(path, 'utf8');
  } catch (error) {
    if (error instanceof UsageError) throw error;
    const { code } = error as NodeJS.ErrnoException;
    throw new UsageError(`${path} ${MEANINGS[code ?? ''] ?? `could not be read (${code})`}.`);
  }
}
