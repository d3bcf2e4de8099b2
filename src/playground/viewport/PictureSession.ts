import type { BufferGeometry } from 'three';
import { meshesOf } from '../../viewer/drawing/meshes.js';
import type { Layer } from '../../viewer/sceneSetup/Ground.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { LostContextError } from './ContextLoss.js';
import { MARGIN } from './Painter.js';
import type { Viewport } from './Viewport.js';

/** The longer side, in pixels, from which a picture counts as larger than a screen. */
const LARGE = 2048;

/** A picture that is drawn in tiles: its place on the whole view of the page, in pixels of the picture. */
export interface TiledPicture {
  viewWidth: number;
  viewHeight: number;
  left: number;
  top: number;
  /** Pixels of the picture per CSS pixel of the page, which scale strokes and outlines. */
  scale: number;
}

/** A part of a picture, in its pixels. */
interface Part {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The content of a picture: its background, and all or one of its layers. */
export interface PictureLook {
  ground: Settings['pictureGround'];
  /** The only layer that is drawn, on a transparent background. */
  layer?: Layer;
  /** Whether it lies below the lines of a vector file: elements that are saved as lines are left out, and so is a comparison. */
  isUnderLines?: boolean;
}

/** Draws pictures in tiles, or videos frame by frame, on the canvas of the page. The page's frames are held meanwhile. */
export class PictureSession {
  /** The viewport's change count when frames were held: after a further change, new tiles would not fit the earlier ones. */
  private changes = 0;
  /** Whether a comparison is left out. */
  private isUndivided = false;
  /** Restores the model's usual geometry. */
  private leaveFiner: () => void = () => {};

  constructor(private readonly viewport: Viewport) {}

  /**
   * Stops frames and animation, so that a picture can be drawn in tiles, until {@link release}.
   *
   * @param size pixels of the longer side of the picture
   */
  hold(size: number): void {
    const { quality, frames, painter, scenery } = this.viewport;
    quality.finishSketch();
    frames.isHeld = true;
    scenery.takeBack();
    this.showFiner();
    this.changes = this.viewport.changes;
    painter.setShadowQuality(size > LARGE ? 'fine' : 'usual', true);
  }

  /** Resumes frames. One is drawn at once, so that the page never shows a tile. */
  release(): void {
    this.leaveFiner();
    this.viewport.frames.isHeld = false;
    this.viewport.resize();
  }

  /** Sets the scene up for the picture, until {@link end}. Frames must be held. */
  begin({ ground, layer, isUnderLines = false }: PictureLook): void {
    const { painter, scenery } = this.viewport;
    // Tiles are measured in device pixels.
    painter.pixelRatio = 1;
    if (ground !== 'paper' || layer) painter.renderer.setClearAlpha(0);
    scenery.show(layer ?? (ground === 'strokes' ? 'ink' : 'whole'), !isUnderLines);
    this.isUndivided = isUnderLines;
  }

  end(): void {
    const { painter, scenery } = this.viewport;
    scenery.showWhole();
    painter.renderer.setClearAlpha(1);
  }

  /** Restores the sizes, shadows and technique of the page after tiles and small pictures, for readers of the scene. */
  restoreScene(): void {
    const { painter, scenery } = this.viewport;
    painter.setWidths();
    painter.setShadowQuality('usual', true);
    scenery.shown.model?.useMaterials('drawn');
  }

  /**
   * Draws one tile of the present picture into the canvas, which keeps it until the end of the task.
   *
   * @param tile its place in the picture, in pixels
   * @throws Error with a sentence for the user
   */
  drawPart({ viewWidth, viewHeight, left, top, scale }: TiledPicture, { x, y, width, height }: Part): void {
    if (this.viewport.changes !== this.changes)
      throw new Error('The drawing was changed while it was being saved; save it again.');
    const { painter } = this.viewport;
    const { canvas, camera } = painter;
    // Setting the size reallocates the canvas, even if it is the same.
    if (canvas.width !== width || canvas.height !== height) painter.renderer.setSize(width, height, false);
    camera.setViewOffset(viewWidth, viewHeight, left + x, top + y, width, height);
    painter.drawTile({ viewWidth, x: left + x, width, height, isUndivided: this.isUndivided }, scale);
    camera.clearViewOffset();
    this.throwIfLost();
  }

  /**
   * Draws one tile of the present picture, and reads its pixels: RGBA with premultiplied alpha, the lowest row first.
   *
   * @param tile its place in the picture, in pixels
   * @param pixels to be filled
   * @throws Error with a sentence for the user
   */
  readTile(picture: TiledPicture, tile: Part, pixels: Uint8Array): void {
    const { context } = this.viewport;
    const [x, columns] = widened(tile.x, tile.width, picture.left, picture.viewWidth);
    const [y, rows] = widened(tile.y, tile.height, picture.top, picture.viewHeight);
    this.drawPart(picture, { x, y, width: columns, height: rows });
    const below = y + rows - tile.y - tile.height;
    context.readPixels(tile.x - x, below, tile.width, tile.height, context.RGBA, context.UNSIGNED_BYTE, pixels);
    this.throwIfLost();
  }

  private showFiner(): void {
    const { finer, model } = this.viewport;
    if (!finer || !model) return;
    const [mesh] = meshesOf(model.root);
    const { geometry } = mesh;
    const exchange = (other: BufferGeometry): void => {
      mesh.geometry = other;
      this.viewport.outdateShadows();
    };
    exchange(finer);
    this.leaveFiner = () => exchange(geometry);
  }

  private throwIfLost(): void {
    if (this.viewport.isLost) throw new LostContextError();
  }
}

/**
 * Start and length of a part with a margin on both sides, clipped to the view. Margins are even: pixels are shaded in pairs, which must
 * stay the same.
 *
 * @param origin of starts, in the view
 */
function widened(start: number, length: number, origin: number, viewLength: number): [number, number] {
  const margin = (room: number): number => 2 * Math.floor(Math.min(MARGIN, Math.max(0, room)) / 2);
  const before = margin(origin + start);
  return [start - before, before + length + margin(viewLength - origin - start - length)];
}
