import { MILLIMETRES_PER_INCH, SHEET_SIZES, type SheetName } from '../../vector/svg/sheetSizes.js';
import { strokeShare } from '../../viewer/sceneSetup/framing.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** Dots per inch of pictures in page size; the panel converts widths to print with it. */
const PAGE_DPI = 300;

type PaperFormat = Extract<Settings['pictureSize'], Lowercase<SheetName>>;

/** Paper sizes by setting, in portrait orientation, in millimetres. */
export const PAPER_FORMATS = Object.fromEntries(
  Object.entries(SHEET_SIZES).map(([name, size]) => [name.toLowerCase(), size]),
) as Record<PaperFormat, readonly [number, number]>;

/** The margin of the view around a sheet, in CSS pixels. */
const SHEET_MARGIN = 12;

/** The place of a picture on the view of the page, in pixels of the picture. */
export interface PrintPlan {
  /** The size of the picture in pixels. */
  width: number;
  height: number;
  /** The size of the whole view, and the offset of the picture in it, which is negative if the picture is larger. */
  viewWidth: number;
  viewHeight: number;
  left: number;
  top: number;
  /** Pixels of the picture per CSS pixel of the page, which scale strokes and lines. */
  scale: number;
  dpi: number;
}

/** A size in pixels; that of the page's view is in CSS pixels. */
export interface Size {
  width: number;
  height: number;
}

/** The page's view. */
export interface DrawnView extends Size {
  /** Whether a landscape sheet suits the view. */
  isWide: boolean;
}

/** A rectangle in CSS pixels of the page's view. */
export interface Bounds {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const toPixels = (millimetres: number, dpi: number): number => Math.round((millimetres / MILLIMETRES_PER_INCH) * dpi);

export const toMillimetres = (pixels: number, dpi: number): number => (pixels / dpi) * MILLIMETRES_PER_INCH;

/** The sides of the sheet of the settings in millimetres, in portrait orientation for a paper format; undefined for page size. */
export function sheetSides(settings: Settings): readonly [number, number] | undefined {
  const { pictureSize, pictureWidth, pictureHeight, pictureWidthInches, pictureHeightInches } = settings;
  if (pictureSize === 'own') return [pictureWidth, pictureHeight];
  if (pictureSize === 'inches')
    return [pictureWidthInches * MILLIMETRES_PER_INCH, pictureHeightInches * MILLIMETRES_PER_INCH];
  return pictureSize in PAPER_FORMATS ? PAPER_FORMATS[pictureSize as PaperFormat] : undefined;
}

/** The sheet of the settings in millimetres, in its orientation; undefined for page size. */
function sheetOf(settings: Settings, view: DrawnView): readonly [number, number] | undefined {
  const { pictureSize, pictureTurn } = settings;
  const sides = sheetSides(settings);
  if (!sides || !(pictureSize in PAPER_FORMATS)) return sides;
  const [short, long] = sides;
  const isWide = pictureTurn === 'suited' ? view.isWide : pictureTurn === 'landscape';
  return isWide ? [long, short] : [short, long];
}

/**
 * Where the sheet of the settings lies on the view: in the middle, as large as possible.
 *
 * @returns its shares of the view's width and height; undefined for page size
 */
export function sheetOnView(settings: Settings, view: DrawnView): readonly [number, number] | undefined {
  const sheet = sheetOf(settings, view);
  if (!sheet) return undefined;
  const [width, height] = [view.width, view.height].map((size) => Math.max(size - 2 * SHEET_MARGIN, size / 2));
  const pixels = Math.min(width / sheet[0], height / sheet[1]);
  return [(pixels * sheet[0]) / view.width, (pixels * sheet[1]) / view.height];
}

/** The plan of the picture by the settings: in page size, in a multiple of it, or on a sheet of paper. */
export function planPrint(settings: Settings, view: DrawnView): PrintPlan {
  const sheet = sheetOf(settings, view);
  const onView = sheetOnView(settings, view);
  if (!sheet || !onView) {
    const scale = Number(settings.pictureSize);
    const [width, height] = [Math.round(view.width * scale), Math.round(view.height * scale)];
    return { width, height, viewWidth: width, viewHeight: height, left: 0, top: 0, scale, dpi: PAGE_DPI };
  }
  const dpi = Number(settings.pictureDpi);
  const [width, height] = [toPixels(sheet[0], dpi), toPixels(sheet[1], dpi)];
  return { ...placeAt({ width, height }, view, width / (onView[0] * view.width)), dpi };
}

/** Centres the whole view in a picture, as large as possible. The picture's size is in pixels. */
export function placeView({ width, height }: Size, view: Size): Omit<PrintPlan, 'dpi'> {
  return placeAt({ width, height }, view, Math.min(width / view.width, height / view.height));
}

/** Centres the view in a picture. @param fit pixels of the picture per CSS pixel of the page */
function placeAt({ width, height }: Size, view: Size, fit: number): Omit<PrintPlan, 'dpi'> {
  const [viewWidth, viewHeight] = [view.width * fit, view.height * fit];
  return {
    ...{ width, height, viewWidth, viewHeight },
    left: -Math.round((width - viewWidth) / 2),
    top: -Math.round((height - viewHeight) / 2),
    scale: strokeScale(fit, { width: viewWidth, height: viewHeight }, view),
  };
}

/**
 * The factor on the widths of strokes and lines in a picture. They scale with the drawing, but are never finer than on a screen of as many
 * pixels: they are as fine as pixels can show there, and finer ones would cause moiré.
 *
 * @param fit pixels of the picture per CSS pixel of the page
 * @param shown size of the drawing in pixels of the picture
 */
export const strokeScale = (fit: number, shown: Size, view: Size): number =>
  Math.max(fit, strokeShare(shown.width, shown.height) / strokeShare(view.width, view.height));

/** A small version of a picture, for finding the bounds of the drawing. @param most pixels of its longer side */
export function coarsePlan(plan: PrintPlan, most: number): PrintPlan {
  const factor = Math.min(1, most / Math.max(plan.width, plan.height));
  const { viewWidth, viewHeight, left, top, scale, dpi } = plan;
  return {
    width: Math.ceil(plan.width * factor),
    height: Math.ceil(plan.height * factor),
    viewWidth: viewWidth * factor,
    viewHeight: viewHeight * factor,
    left: left * factor,
    top: top * factor,
    scale: scale * factor,
    dpi: dpi * factor,
  };
}

/**
 * Crops a picture to bounds in shares of its width and height. Graphics cards shade blocks of two by two pixels, counted from the lower
 * left; the crop keeps these blocks, since strokes would change otherwise.
 */
export function cutPlan(plan: PrintPlan, bounds: Bounds): PrintPlan {
  const left = toEven(Math.max(0, Math.floor(bounds.left * plan.width)));
  const top = Math.max(0, Math.floor(bounds.top * plan.height));
  const right = Math.min(plan.width, Math.ceil(bounds.right * plan.width));
  const below = toEven(Math.max(0, Math.floor((1 - bounds.bottom) * plan.height)));
  const [width, height] = [right - left, plan.height - below - top];
  return { ...plan, width, height, left: plan.left + left, top: plan.top + top };
}

const toEven = (pixels: number): number => pixels - (pixels % 2);

/** Millimetres in print per CSS pixel of the page. */
export function millimetresPerPixel(settings: Settings, view: DrawnView): number {
  const { scale, dpi } = planPrint(settings, view);
  return toMillimetres(scale, dpi);
}
