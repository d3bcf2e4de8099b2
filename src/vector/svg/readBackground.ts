import { type Camera, Vector3, Vector4 } from 'three';
import { type SeenBox, seenBox } from '../../material/fading/seenDepths.js';
import type { HatchingBackground } from '../../material/HatchingBackground.js';
import { writeSheet } from '../../material/pictureOffset.js';
import type { DrawnBackground } from '../DrawnScene.js';
import { meanLightAt } from '../shading/meanLight.js';
import type { SceneLights } from './readLights.js';

/** Reads the field of lines behind a subject; undefined if the subject is not visible. */
export function readBackground(
  background: HatchingBackground,
  camera: Camera,
  { lamps, around }: SceneLights,
): DrawnBackground | undefined {
  const { subject, tone, contrast, spacing, direction, extent, ink } = background;
  const seen: SeenBox = { front: 0, back: 1, left: -1, right: 1, bottom: -1, top: 1 };
  if (!subject || !seenBox(subject.box, subject.frame.matrixWorld, camera, seen)) return undefined;
  const centre = subject.box.getCenter(new Vector3()).applyMatrix4(subject.frame.matrixWorld);
  const light = new Vector3(...meanLightAt(centre.toArray(), lamps, around.skies));
  light.transformDirection(camera.matrixWorldInverse);
  const sheet = new Vector4();
  // The picture is one wide and one high.
  writeSheet(sheet, camera, new Vector4(0, 0, 1, 1));
  return {
    ...{ tone, contrast, spacing, angle: direction, extent },
    seen: { left: seen.left, right: seen.right, bottom: seen.bottom, top: seen.top },
    lit: [light.x, light.y],
    sheet: [sheet.x, sheet.y, sheet.z, sheet.w],
    ink: `#${ink.getHexString()}`,
  };
}
