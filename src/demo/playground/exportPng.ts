import type { Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';

/** Larger pictures are drawn in tiles of this size, because graphics cards limit the size of a canvas. */
const TILE = 2048;

export interface PictureOptions {
  /** Size of the page in CSS pixels. */
  width: number;
  height: number;
  /** Pixels of the picture per CSS pixel of the page. */
  scale: number;
  ground: Settings['pictureGround'];
}

/** Draws the view at the size of the picture, tile by tile, and encodes it as PNG. */
export async function exportPng(scene: HatchingScene, options: PictureOptions): Promise<Blob> {
  const { renderer, camera } = scene;
  if (scene.isLost)
    throw new Error('There is nothing to save before the graphics card has taken up the drawing again.');
  const width = Math.round(options.width * options.scale);
  const height = Math.round(options.height * options.scale);
  const picture = document.createElement('canvas');
  picture.width = width;
  picture.height = height;
  const context = picture.getContext('2d');
  if (!context) throw new Error('The browser has no room for a picture of this size; choose a smaller one.');

  const pixelRatio = renderer.getPixelRatio();
  const clearAlpha = renderer.getClearAlpha();
  try {
    renderer.setPixelRatio(1);
    if (options.ground !== 'paper') renderer.setClearAlpha(0);
    if (options.ground === 'strokes') scene.showPaper(false);
    for (let y = 0; y < height; y += TILE) {
      for (let x = 0; x < width; x += TILE) {
        const tileWidth = Math.min(TILE, width - x);
        const tileHeight = Math.min(TILE, height - y);
        renderer.setSize(tileWidth, tileHeight, false);
        camera.setViewOffset(width, height, x, y, tileWidth, tileHeight);
        scene.drawTile({ viewWidth: width, x, width: tileWidth, height: tileHeight }, options.scale);
        // In the same task as the rendering, because the canvas does not keep its content for longer.
        context.drawImage(renderer.domElement, x, y);
        if (scene.isLost) throw new Error('The graphics card gave up at a picture of this size; choose a smaller one.');
      }
    }
  } finally {
    // Restored before the next frame, so that the page never shows a tile.
    camera.clearViewOffset();
    scene.showPaper(true);
    renderer.setClearAlpha(clearAlpha);
    renderer.setPixelRatio(pixelRatio);
    renderer.setSize(options.width, options.height, false);
    scene.draw();
  }
  return new Promise((resolve, reject) => {
    picture.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error('The browser could not pack a picture of this size; choose a smaller one.'));
    }, 'image/png');
  });
}
