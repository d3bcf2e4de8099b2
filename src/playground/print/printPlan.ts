import { MILLIMETRES_PER_INCH, SHEET_SIZES, type SheetName } from '../../vector/svg/sheetSizes.js';
import { strokeShare } from '../../viewer/sceneSetup/strokeShare.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** Dots per inch of pictures in the size of the page. The panel measures strokes in print with it. */
const PAGE_DPI = 300;

type PaperFormat = Extract<Settings['pictureSize'], Lowercase<SheetName>>;

/** Sheets of paper by the settings that ask for them, upright, in millimetres. */
export const PAPER_FORMATS = Object.fromEntries(
  Object.entries(SHEET_SIZES).map(([name, size]) => [name.toLowerCase(), size]),
) as Record<PaperFormat, readonly [number, number]>;

/** The margin of the view around a sheet, on every side, in CSS pixels. */
const SHEET_MARGIN = 12;

/** Where a picture lies on the view of the page, in pixels of the picture. */
export interface PrintPlan {
  /** The size of the picture in pixels. */
  width: number;
  height: number;
  /** The size of the whole view of the page, and where the picture begins in it: at negative places if the picture is larger. */
  viewWidth: number;
  viewHeight: number;
  left: number;
  top: number;
  /** Pixels of the picture per CSS pixel of the page, by which strokes and lines are sized. */
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
  /** Whether a sheet should be wider than high to suit what the view shows. */
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

/** The sides of the sheet that the settings ask for, a format's as it stands upright, in millimetres; undefined for the size of the page. */
export function sheetSides(settings: Settings): readonly [number, number] | undefined {
  const { pictureSize, pictureWidth, pictureHeight, pictureWidthInches, pictureHeightInches } = settings;
  if (pictureSize === 'own') return [pictureWidth, pictureHeight];
  if (pictureSize === 'inches')
    return [pictureWidthInches * MILLIMETRES_PER_INCH, pictureHeightInches * MILLIMETRES_PER_INCH];
  return pictureSize in PAPER_FORMATS ? PAPER_FORMATS[pictureSize as PaperFormat] : undefined;
}

/** The sheet that the settings ask for, in millimetres; undefined for the size of the page. */
function sheetOf(settings: Settings, view: DrawnView): readonly [number, number] | undefined {
  const { pictureSize, pictureTurn } = settings;
  const sides = sheetSides(settings);
  if (!sides || !(pictureSize in PAPER_FORMATS)) return sides;
  const [short, long] = sides;
  const isWide = pictureTurn === 'suited' ? view.isWide : pictureTurn === 'landscape';
  return isWide ? [long, short] : [short, long];
}

/**
 * Where the sheet that the settings ask for lies on the view of the page: in its middle, as large as possible.
 *
 * @returns the shares of the view's width and height that it takes; undefined for a picture of the page itself
 */
export function sheetOnView(settings: Settings, view: DrawnView): readonly [number, number] | undefined {
  const sheet = sheetOf(settings, view);
  if (!sheet) return undefined;
  const [width, height] = [view.width, view.height].map((size) => Math.max(size - 2 * SHEET_MARGIN, size / 2));
  const pixels = Math.min(width / sheet[0], height / sheet[1]);
  return [(pixels * sheet[0]) / view.width, (pixels * sheet[1]) / view.height];
}

/** The picture that the settings ask for: in the size of the page, in a multiple of it, or on a sheet of paper. */
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

/** Places the whole view of the page in the middle of a picture, as large as possible. The picture's size is in pixels. */
export function placeView({ width, height }: Size, view: Size): Omit<PrintPlan, 'dpi'> {
  return placeAt({ width, height }, view, Math.min(width / view.width, height / view.height));
}

/** Places the middle of the view in the middle of a picture. @param fit pixels of the picture per CSS pixel of the page */
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
 * The factor on the widths of strokes and lines in a picture. They grow with the drawing, but are never finer than on a screen of as
 * many pixels: there they are as fine as pixels can show, and finer ones would become moiré.
 *
 * @param fit pixels of the picture per CSS pixel of the page
 * @param shown the drawing in pixels of the picture
 */
export const strokeScale = (fit: number, shown: Size, view: Size): number =>
  Math.max(fit, strokeShare(shown.width, shown.height) / strokeShare(view.width, view.height));

/** A small version of a picture, in which the drawing is looked for. @param most pixels of its longer side */
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
 * A picture that is cut to the bounds of the drawing, which are in shares of its width and height. Graphics cards draw two by two
 * pixels together, counted from the lower left. These stay together; otherwise the strokes would change.
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

/** How many millimetres a CSS pixel of the page becomes in print. */
export function millimetresPerPixel(settings: Settings, view: DrawnView): number {
  const { scale, dpi } = planPrint(settings, view);
  return toMillimetres(scale, dpi);
}
