import { FILE_CHANGE_KINDS, type FileChangeKind, type HowRead } from '../files/common/fileChanges.js';
import {
  type CameraView,
  cameraParts,
  inSingle,
  MAX_VIEWS,
  readView,
  type SavedView,
  takeCamera,
  writeView,
} from './CameraView.js';
import { PRESET_NAMES } from './presetLabels.js';
import { firstView, presetLook } from './presets.js';
import { readRanges, writeRanges } from './ranges.js';
import { acceptSetting, defaultSettings, SETTING_KEYS, SETTINGS, type Settings } from './settings.js';

/** What is selected of a model's file, by indices from 0. Left out for the usual. */
export interface ModelChoice {
  /** Index of the material variant; undefined for the file's default materials. */
  readonly variant: number | undefined;
  /** Index of the clip; undefined for the first. */
  readonly clip: number | undefined;
  /** Kinds of changes that are switched from what is usual, in the order of `FILE_CHANGE_KINDS`; undefined for none. */
  readonly switched?: readonly FileChangeKind[] | undefined;
  /** Indices of the parts that are hidden, in rising order; undefined for none. */
  readonly hidden?: readonly number[] | undefined;
}

export const NO_CHOICE: ModelChoice = { variant: undefined, clip: undefined };

export const isSameChoice = (a: ModelChoice, b: ModelChoice): boolean =>
  a.clip === b.clip && isReadAlike(a, b) && isSameList(a.hidden, b.hidden);

/** Whether a file is read in the same way for two choices; the rest of a choice is how the model is shown. */
export const isReadAlike = (a: HowRead, b: HowRead): boolean =>
  a.variant === b.variant && isSameList(a.switched, b.switched);

/** Whether two lists have the same values. */
export const isSameList = (a: readonly unknown[] = [], b: readonly unknown[] = []): boolean =>
  a === b || (a.length === b.length && a.every((value, i) => value === b[i]));

/** What a link brings back. */
export interface LinkedDrawing {
  settings: Settings;
  /** Whether the link names a model, which is that of the settings or that of the address. */
  namesModel: boolean;
  /** Undefined if the model is to be framed. */
  camera: CameraView | undefined;
  /** Of a model on the web, which stands in the place of that of the settings. */
  address: string | undefined;
  views: readonly SavedView[];
  /** The user's own hand, as the text that `readHand` reads, if it is drawn with. It is not read yet. */
  handText: string | undefined;
  /** What is selected of the model's file. */
  choice: ModelChoice;
}

/**
 * Settings and camera as the hash of a URL. Defaults are left out, but for the model, which a link without one leaves as
 * it is, and the technique: no hash at all stands for the first view.
 *
 * @param address of the user's own model, if it is on the web; a link cannot refer to a dropped file
 * @param views that are kept with the drawing
 * @param hand the user's own hand as a text; without it, a link cannot say that it is drawn with
 * @param choice what is selected of the model's file. Indices are numbers from 1 on in a link, and hidden parts are ranges of them
 */
export function writeLink(
  settings: Settings,
  camera: CameraView | undefined,
  address?: string,
  views: readonly SavedView[] = [],
  hand?: string,
  choice: ModelChoice = NO_CHOICE,
): string {
  const parameters = new URLSearchParams();
  if (settings.model === 'file' && address) parameters.set('model', address);
  for (const key of SETTING_KEYS) {
    // As fields have them: a third is 0.333, and not a number of seventeen digits.
    const value = acceptSetting(key, settings[key]) ?? settings[key];
    if (value === 'file' || (value === 'ownHand' && hand === undefined)) continue;
    if (value === SETTINGS[key].default && key !== 'technique' && key !== 'model') continue;
    parameters.set(key, String(value));
  }
  if (settings.mapStyle === 'ownHand' && hand !== undefined) parameters.set('hand', hand);
  for (const key of CHOICES) if (choice[key] !== undefined) parameters.set(key, String(choice[key] + 1));
  if (choice.switched?.length) parameters.set('switched', choice.switched.join(','));
  if (choice.hidden?.length) parameters.set('hidden', writeRanges(choice.hidden));
  if (camera) {
    const parts = cameraParts(camera).map((part) => (typeof part === 'number' ? shortest(part) : part));
    parameters.set('camera', parts.join(','));
  }
  for (const view of views) parameters.append('view', writeView(view));
  return parameters.toString();
}

const CHOICES = ['variant', 'clip'] as const;

/** Every number of single precision is told by so many digits. */
const MAX_DIGITS = 9;

/** The shortest decimal that is read back as the same number of single precision. */
function shortest(value: number): number {
  const single = Math.fround(value);
  for (let digits = 1; digits < MAX_DIGITS; digits++) {
    const short = Number(single.toPrecision(digits));
    if (Math.fround(short) === single) return short;
  }
  return Number(single.toPrecision(MAX_DIGITS));
}

/** Reads what {@link writeLink} wrote. Unknown names and invalid values are ignored. Nothing at all is the first view; `preset` is what the others differ from. */
export function readLink(hash: string): LinkedDrawing {
  const parameters = new URLSearchParams(hash.replace(/^#/, ''));
  const preset = PRESET_NAMES.find((name) => name === parameters.get('preset'));
  const settings = parameters.size === 0 ? firstView() : { ...defaultSettings(), ...(preset && presetLook(preset)) };
  const address = addressOf(parameters.get('model') ?? '');
  let namesModel = address !== undefined;
  for (const key of SETTING_KEYS) {
    const text = parameters.get(key);
    const value = text === null ? undefined : acceptSetting(key, text);
    if (value === undefined || value === 'file') continue;
    Object.assign(settings, { [key]: value });
    namesModel ||= key === 'model';
  }
  const handText = settings.mapStyle === 'ownHand' ? (parameters.get('hand') ?? undefined) : undefined;
  if (settings.mapStyle === 'ownHand' && handText === undefined) settings.mapStyle = SETTINGS.mapStyle.default;
  const parts = (parameters.get('camera') ?? '').split(',');
  const camera = takeCamera(parts);
  return {
    settings,
    namesModel,
    camera: camera && parts.length === 0 ? inSingle(camera) : undefined,
    address,
    views: parameters
      .getAll('view')
      .slice(0, MAX_VIEWS)
      .map(readView)
      .filter((view) => view !== undefined),
    handText,
    choice: readChoice(parameters),
  };
}

function readChoice(parameters: URLSearchParams): ModelChoice {
  const [variant, clip] = CHOICES.map((key) => indexOf(parameters.get(key) ?? ''));
  const kinds = (parameters.get('switched') ?? '').split(',');
  const switched = FILE_CHANGE_KINDS.filter((kind) => kinds.includes(kind));
  const hidden = readRanges(parameters.get('hidden') ?? '');
  return {
    ...{ variant, clip },
    ...(switched.length > 0 && { switched }),
    ...(hidden.length > 0 && { hidden }),
  };
}

/** The index that a number from 1 on stands for; undefined for anything else. */
const indexOf = (text: string): number | undefined => (/^[1-9]\d{0,3}$/.test(text) ? Number(text) - 1 : undefined);

/** As long as the name of a host can be in the domain name system. */
const MAX_HOST = 253;

/** An address that the page may ask for, whole; undefined for anything else. */
function addressOf(text: string): string | undefined {
  if (!URL.canParse(text)) return undefined;
  const address = new URL(text);
  if (address.protocol !== 'https:' || address.hostname.length > MAX_HOST) return undefined;
  // `https://name:password@host`: no browser fetches that, and the name may be that of another host.
  address.username = '';
  address.password = '';
  return address.href;
}
