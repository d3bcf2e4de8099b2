import { type Camera, type Material, type Mesh, type Object3D, Vector3, Vector4 } from 'three';
import { type FadingLook, importanceOf, takesWeight, writeDepthFading } from '../../material/fading/fading.js';
import { type SeenBox, seenBox } from '../../material/fading/seenDepths.js';
import { writeSheet } from '../../material/pictureOffset.js';
import type { ObjectFading } from '../shading/fading.js';

/** The fading of an object; null where everything has its full weight. */
export function readFading(object: Object3D, look: FadingLook | null, camera: Camera): ObjectFading | null {
  if (!takesWeight(look)) return null;
  const { focus, focusRadius, vignette } = look;
  const depthFading = new Vector3();
  const isMeasured = look.depthFade !== 0 && look.extent !== null;
  writeDepthFading(look, isMeasured ? seenOf(look.extent, camera) : null, camera, depthFading);
  const importance = importanceOf(object);
  if (depthFading.z === 0 && focus === null && vignette === 0 && importance === 1) return null;
  const sheet = new Vector4();
  // The picture is one wide and one high.
  writeSheet(sheet, camera, new Vector4(0, 0, 1, 1));
  return {
    depthFading: [depthFading.x, depthFading.y, depthFading.z],
    focus: focus && { at: [focus.x, focus.y, focus.z], radius: focusRadius },
    vignette,
    sheet: [sheet.x, sheet.y, sheet.z, sheet.w],
    importance,
  };
}

/** The fading of the outlines of a mesh, which is that of its first hatching material. */
export function readOutlineFading(mesh: Mesh, camera: Camera): ObjectFading | null {
  const materials: Material[] = Array.isArray(mesh.material) ? mesh.material : [mesh.material];
  const found = materials.find((material) => 'isHatchingMaterial' in material);
  return readFading(mesh, (found ?? null) as (Material & FadingLook) | null, camera);
}

function seenOf({ box, frame }: NonNullable<FadingLook['extent']>, camera: Camera): SeenBox | null {
  const seen: SeenBox = { front: 0, back: 1, left: -1, right: 1, bottom: -1, top: 1 };
  return seenBox(box, frame.matrixWorld, camera, seen) ? seen : null;
}
