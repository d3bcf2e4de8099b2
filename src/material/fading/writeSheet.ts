import type { Camera, Vector4 } from 'three';
import type { ViewedCamera } from '../pictureOffset.js';

/**
 * Writes the place of the sheet: its lower left corner relative to that of the render target, and its size, in pixels. If a picture is
 * drawn in tiles, the sheet is the whole picture. Allocates nothing.
 *
 * @param viewport the viewport that is drawn to, in pixels
 */
export function writeSheet(sheet: Vector4, camera: Camera, viewport: Vector4): void {
  sheet.copy(viewport);
  const { view } = camera as ViewedCamera;
  if (!view?.enabled) return;
  const { fullWidth, fullHeight, offsetX, offsetY, width, height } = view;
  sheet.z *= fullWidth / width;
  sheet.w *= fullHeight / height;
  // View offsets count from the upper left.
  sheet.x -= (offsetX * viewport.z) / width;
  sheet.y -= ((fullHeight - offsetY - height) * viewport.w) / height;
}
