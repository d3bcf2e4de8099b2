import type { Camera, Vector2, Vector4 } from 'three';

/** What three's cameras have beside the fields of `Camera`. */
export type ViewedCamera = Camera & {
  view?: {
    enabled: boolean;
    fullWidth: number;
    fullHeight: number;
    offsetX: number;
    offsetY: number;
    width: number;
    height: number;
  } | null;
};

/**
 * Where the picture that a camera draws lies within the whole one: the tiles of a large picture are drawn one by one, by
 * `setViewOffset`. In pixels from the lower left. Allocates nothing.
 *
 * @param viewport of the picture, pixels
 */
export function writePictureOffset(target: Vector2, camera: Camera, viewport: Vector4): void {
  const { view } = camera as ViewedCamera;
  if (!view?.enabled) {
    target.set(0, 0);
    return;
  }
  const { fullHeight, offsetX, offsetY, width, height } = view;
  // View offsets count from the upper left, in units of the full view.
  const fromBelow = fullHeight - offsetY - height;
  target.set((offsetX * viewport.z) / width - viewport.x, (fromBelow * viewport.w) / height - viewport.y);
}
