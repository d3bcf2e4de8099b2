import type { Settings } from '../settings/settings.js';
import type { FrameQuality } from './FrameQuality.js';
import type { Frames } from './Frames.js';
import { LostContextError } from './LostContextError.js';
import type { Layer } from './layers.js';
import type { Painter } from './Painter.js';
import type { Scenery } from './Scenery.js';

/** Pixels of the longer side of a picture that is larger than a screen. */
const LARGE = 2048;

/** A picture that is drawn in tiles: where it lies on the whole view of the page, in pixels of the picture. */
export interface TiledPicture {
  viewWidth: number;
  viewHeight: number;
  left: number;
  top: number;
  /** Pixels of the picture per CSS pixel of the page, by which strokes and lines are sized. */
  scale: number;
}

/** A part of a picture, in its pixels. */
interface Part {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** How a picture is drawn: on which background, and whether all of it. */
export interface PictureLook {
  ground: Settings['pictureGround'];
  /** The one layer that is drawn, on a transparent background. */
  layer?: Layer;
}

/** Draws pictures in tiles, or videos frame by frame, on the canvas of the page. The frames of the page are held meanwhile. */
export class PictureSession {
  private isOutdated = false;

  /** @param onRelease called when frames go on. The canvas still has the size of a tile then, and shows it */
  constructor(
    private readonly painter: Painter,
    private readonly scenery: Scenery,
    private readonly frames: Frames,
    private readonly quality: FrameQuality,
    private readonly onRelease: () => void,
  ) {}

  /** To be called when the view, the model or the look changes: further tiles would not fit those that were drawn before. */
  outdate(): void {
    this.isOutdated = true;
  }

  /**
   * Stops frames and animation, so that a picture can be drawn in tiles, until {@link release}.
   *
   * @param size pixels of the longer side of the picture
   */
  hold(size: number): void {
    this.quality.finishSketch();
    this.frames.isHeld = true;
    this.isOutdated = false;
    this.painter.setShadowQuality(size > LARGE ? 'fine' : 'usual', true);
  }

  /** Goes on with frames. One is drawn at once, so that the page never shows a tile. */
  release(): void {
    this.frames.isHeld = false;
    this.onRelease();
  }

  /** Shows what the picture is to hold, until {@link end}. Frames must be held. */
  begin({ ground, layer }: PictureLook): void {
    const { painter, scenery } = this;
    painter.pixelRatio = 1;
    if (ground !== 'paper' || layer) painter.renderer.setClearAlpha(0);
    if (layer) scenery.showLayer(layer);
    else if (ground === 'strokes') scenery.showPaper(false);
  }

  end(): void {
    this.scenery.showLayer(undefined);
    this.painter.renderer.setClearAlpha(1);
  }

  /**
   * Draws one tile of a picture that was begun into the canvas, which keeps it until the end of the task.
   *
   * @param tile its place in the picture, in pixels
   * @throws Error with a sentence for the user
   */
  drawPart({ viewWidth, viewHeight, left, top, scale }: TiledPicture, { x, y, width, height }: Part): void {
    if (this.isOutdated) throw new Error('The drawing was changed while it was being saved; save it again.');
    const { painter } = this;
    const { canvas, camera } = painter;
    // Setting the size gives the canvas new memory, even if it is the same.
    if (canvas.width !== width || canvas.height !== height) painter.renderer.setSize(width, height, false);
    camera.setViewOffset(viewWidth, viewHeight, left + x, top + y, width, height);
    painter.drawTile({ viewWidth, x: left + x, width, height }, scale);
    camera.clearViewOffset();
    this.throwIfLost();
  }

  /**
   * Draws one tile of a picture that was begun, and reads its pixels: RGBA multiplied with alpha, the lowest row first.
   *
   * @param tile its place in the picture, in pixels
   * @param pixels to be filled
   * @throws Error with a sentence for the user
   */
  readTile(picture: TiledPicture, tile: Part, pixels: Uint8Array): void {
    const { context } = this.painter;
    this.drawPart(picture, tile);
    context.readPixels(0, 0, tile.width, tile.height, context.RGBA, context.UNSIGNED_BYTE, pixels);
    this.throwIfLost();
  }

  private throwIfLost(): void {
    if (this.painter.isLost) throw new LostContextError();
  }
}
