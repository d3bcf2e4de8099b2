import type { Camera, Vector4 } from 'three';
import type { ViewedCamera } from '../pictureOffset.js';

/**
 * Writes where the sheet lies: its lower left corner from that of what is drawn to, and its size, in pixels. Of a picture that is drawn in
 * tiles it is the whole picture. Allocates nothing.
 *
 * @param viewport of what is drawn, pixels
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
