import { type PerspectiveCamera, Vector3 } from 'three';
import type { Settings } from '../../viewer/settings/settings.js';
import { hasEffect } from '../../viewer/settings/settingValues.js';
import { BlobWriter } from '../export/zip.js';
import type { PictureLook, PictureSession } from '../viewport/PictureSession.js';
import { PngWriter } from './PngWriter.js';
import { type Bounds, coarsePlan, cutPlan, type PrintPlan, sheetSides, toMillimetres } from './printPlan.js';

export { ZipWriter } from '../export/zip.js';
/** The functions for drawing pictures, fetched when the first picture is saved. */
export { type PrintPlan, planPrint, sheetOnView } from './printPlan.js';

/** Describes the size of a picture. */
export function describePrint({ width, height, dpi }: PrintPlan): string {
  const [wide, high] = [width, height].map((pixels) => Math.round(toMillimetres(pixels, dpi)));
  return `${width.toLocaleString('en')} × ${height.toLocaleString('en')} px, ${wide} × ${high} mm, ${dpi.toLocaleString('en')} dpi`;
}

/**
 * Pixels per radius of the model at its nearest point.
 *
 * @param camera of the whole view, which looks at a model of radius 1 around the origin
 */
export function nearestRadius(camera: PerspectiveCamera, { viewHeight }: Pick<PrintPlan, 'viewHeight'>): number {
  const scale = 0.5 * viewHeight * camera.projectionMatrix.elements[5];
  if ('isOrthographicCamera' in camera) return scale;
  const depth = -camera.position.dot(camera.getWorldDirection(new Vector3()));
  return scale / Math.max(depth - 1, camera.near);
}

/** Tile size in pixels, below the limits of graphics cards. Even, because cards shade blocks of two by two pixels, from the lower left. */
const TILE_SIZE = 2048;
/** Bytes of the band of rows that is held in memory. */
const BAND_BYTES = 32 << 20;
/** The longer side of the small picture in which the bounds of the drawing are found, in pixels. */
const COARSE = 640;
/** The margin around the drawing, in pixels of the small picture, for strokes that are too fine for it. */
const MARGIN = 2;

interface DrawOptions {
  signal: AbortSignal;
  onProgress: (progress: number) => void;
}

/**
 * Draws the view as PNG, in tiles. Rows are compressed as they come, so that a picture of any size takes a few dozen megabytes. The session
 * must hold the page's frames meanwhile.
 *
 * @throws Error with a sentence for the user
 */
export async function drawPicture(
  session: PictureSession,
  plan: PrintPlan,
  look: PictureLook,
  options: DrawOptions,
): Promise<Blob> {
  const { width, height, dpi } = plan;
  const channels = look.ground === 'paper' && look.layer === undefined ? 3 : 4;
  const blob = new BlobWriter();
  const png = new PngWriter({ width, height, channels, dpi }, blob.write);
  try {
    await drawBands(session, plan, look, options, (band) => png.rows(channels === 4 ? band : withoutAlpha(band)));
    await png.end();
  } catch (error) {
    await png.abort();
    throw error;
  }
  return blob.end('image/png');
}

/**
 * Crops a picture to the drawing, whose bounds are found in a small version of it.
 *
 * @throws Error with a sentence for the user, if nothing is drawn
 */
export async function cutToDrawing(session: PictureSession, plan: PrintPlan, signal: AbortSignal): Promise<PrintPlan> {
  const coarse = coarsePlan(plan, COARSE);
  const { width, height } = coarse;
  const bounds: Bounds = { left: width, top: height, right: 0, bottom: 0 };
  let y = 0;
  await drawBands(session, coarse, { ground: 'transparent' }, { signal, onProgress: () => {} }, async (band) => {
    for (let i = 3; i < band.length; i += 4) {
      if (band[i] === 0) continue;
      const pixel = (i - 3) / 4;
      const [x, row] = [pixel % width, y + Math.floor(pixel / width)];
      bounds.left = Math.min(bounds.left, x);
      bounds.right = Math.max(bounds.right, x + 1);
      bounds.top = Math.min(bounds.top, row);
      bounds.bottom = Math.max(bounds.bottom, row + 1);
    }
    y += band.length / (4 * width);
  });
  if (bounds.right <= bounds.left) throw new Error('There is nothing on the sheet to cut it to.');
  return cutPlan(plan, {
    left: (bounds.left - MARGIN) / width,
    top: (bounds.top - MARGIN) / height,
    right: (bounds.right + MARGIN) / width,
    bottom: (bounds.bottom + MARGIN) / height,
  });
}

/** Draws tile by tile, and outputs bands of whole rows from the top, as RGBA with straight alpha. */
async function drawBands(
  session: PictureSession,
  plan: PrintPlan,
  look: PictureLook,
  { signal, onProgress }: DrawOptions,
  take: (band: Uint8Array) => Promise<void>,
): Promise<void> {
  const { width, height } = plan;
  const most = 2 * Math.max(1, Math.floor(BAND_BYTES / (8 * width)));
  const bandHeight = Math.min(height, TILE_SIZE, most);
  const tileWidth = Math.min(width, TILE_SIZE);
  const band = new Uint8Array(4 * width * bandHeight);
  const pixels = new Uint8Array(4 * tileWidth * bandHeight);
  session.begin(look);
  try {
    for (let y = 0, rows = 0; y < height; y += rows) {
      // The number of rows below the band is even, too.
      rows = Math.min(bandHeight - ((height - y - bandHeight) % 2), height - y);
      for (let x = 0; x < width; x += tileWidth) {
        // Lets the page handle events between two tiles, Cancel among them.
        await new Promise((resolve) => setTimeout(resolve));
        signal.throwIfAborted();
        const columns = Math.min(tileWidth, width - x);
        session.readTile(plan, { x, y, width: columns, height: rows }, pixels);
        copyTile(pixels, columns, rows, band, x, width);
        onProgress((y + (rows * (x + columns)) / width) / height);
      }
      await take(band.subarray(0, 4 * width * rows));
      signal.throwIfAborted();
    }
  } finally {
    session.end();
  }
}

/** Copies a tile, whose rows come from the bottom with premultiplied alpha, to its place in a band. */
function copyTile(tile: Uint8Array, columns: number, rows: number, band: Uint8Array, x: number, width: number): void {
  for (let row = 0; row < rows; row++) {
    const from = 4 * columns * (rows - 1 - row);
    const start = 4 * (row * width + x);
    const end = start + 4 * columns;
    band.set(tile.subarray(from, from + 4 * columns), start);
    for (let at = start; at < end; at += 4) {
      const alpha = band[at + 3];
      if (alpha === 255) continue;
      for (let i = at; i < at + 3; i++) band[i] = alpha === 0 ? 0 : Math.min(255, Math.round((band[i] * 255) / alpha));
    }
  }
}

function withoutAlpha(band: Uint8Array): Uint8Array {
  const colours = new Uint8Array((band.length / 4) * 3);
  for (let from = 0, to = 0; from < band.length; from += 4) {
    colours[to++] = band[from];
    colours[to++] = band[from + 1];
    colours[to++] = band[from + 2];
  }
  return colours;
}

/** CSS pixels per inch, for drawings in page size. */
const CSS_DPI = 96;
const MILLIMETRES_PER_INCH = 25.4;
/** The maximum number of pixels of a raster picture in a vector file: an A2 sheet at 300 dpi. Programs hold the whole file in memory. */
const MOST_PIXELS = 36_000_000;

/** The layout of a vector drawing on its sheet. Lengths are in millimetres. */
interface SvgPlan {
  sheet: readonly [width: number, height: number];
  margin: number;
  /** The picture within the margins. Its dots per inch are those of the sheet. */
  within: PrintPlan;
}

/**
 * Lays a picture out on the sheet of a vector file. It is shrunk, strokes included, to fit within the margins; if their proportions differ
 * from the sheet's, it shows a little more of the view.
 *
 * @throws Error with a sentence for the user, if the margins leave no room
 */
export function planSvg(settings: Settings, plan: PrintPlan): SvgPlan {
  const isSheet = hasEffect('pictureMargin', settings);
  const dpi = Number.isFinite(Number(settings.pictureSize)) ? CSS_DPI : plan.dpi;
  // A picture has a whole number of pixels, so it differs from its sheet by up to half a pixel.
  const exact = [plan.width, plan.height].map((pixels) => toMillimetres(pixels, dpi));
  const sides = isSheet ? sheetSides(settings) : undefined;
  const [width, height] = exact.map((side) => (sides ? nearest(sides, side) : Math.round(10 * side) / 10));
  const margin = isSheet ? settings.pictureMargin : 0;
  const room = isSheet ? [width - 2 * margin, height - 2 * margin] : exact;
  if (Math.min(...room) < 1) {
    const size = [width, height].map(Math.round).join(' × ');
    throw new Error(`margins of ${margin} mm leave no room on a sheet of ${size} mm. Make them smaller.`);
  }
  const perMillimetre = Math.max(plan.width / room[0], plan.height / room[1]);
  const [left, top] = [plan.width, plan.height].map((pixels, i) => Math.round((room[i] * perMillimetre - pixels) / 2));
  const within = {
    ...plan,
    width: plan.width + 2 * left,
    height: plan.height + 2 * top,
    left: plan.left - left,
    top: plan.top - top,
    dpi: perMillimetre * MILLIMETRES_PER_INCH,
  };
  return { sheet: [width, height], margin, within };
}

const nearest = ([one, other]: readonly [number, number], side: number): number =>
  Math.abs(one - side) <= Math.abs(other - side) ? one : other;

/** The same picture at another resolution: `dpi`, or the finest that a file can hold. */
export function printablePlan(plan: PrintPlan, dpi: number): PrintPlan {
  const factor = Math.min(dpi / plan.dpi, Math.sqrt(MOST_PIXELS / (plan.width * plan.height)));
  const [width, height] = [plan.width, plan.height].map((pixels) => Math.round(pixels * factor));
  // Whole pixels keep the picture's edges in place.
  const [wide, high] = [width / plan.width, height / plan.height];
  return {
    ...{ width, height },
    viewWidth: plan.viewWidth * wide,
    viewHeight: plan.viewHeight * high,
    left: plan.left * wide,
    top: plan.top * high,
    scale: plan.scale * wide,
    dpi: plan.dpi * wide,
  };
}
