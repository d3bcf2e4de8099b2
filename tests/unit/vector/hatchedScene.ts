import {
  type BufferGeometry,
  type Camera,
  DirectionalLight,
  Mesh,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
} from 'three';
import type { HatchingMaterialParameters } from '../../../src/material/checkValues.js';
import { prepareHatchingGeometry } from '../../../src/material/geometry/prepareHatchingGeometry.js';
import type { HatchingShadowMaterialParameters } from '../../../src/material/groups/shadows.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingShadowMaterial } from '../../../src/material/HatchingShadowMaterial.js';
import type { HatchingOutlineParameters } from '../../../src/material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../../src/material/outlines/HatchingOutlines.js';

/** Scenes for vector drawings. */

export interface HatchedLook {
  material?: HatchingMaterialParameters;
  outlines?: HatchingOutlineParameters | false;
}

/** An engraved mesh, with outlines unless `outlines` is null. */
export async function hatchedMesh(source: BufferGeometry, { material = {}, outlines = {} }: HatchedLook = {}) {
  const geometry = await prepareHatchingGeometry(source, { technique: 'engraving', outlines: outlines !== false });
  const mesh = new Mesh(geometry, new HatchingMaterial({ technique: 'engraving', ...material }));
  if (outlines !== false) mesh.add(new HatchingOutlines(mesh, outlines));
  return mesh;
}

/** An engraved mesh that shows shadows alone, without outlines. */
export async function shadowMesh(source: BufferGeometry, material: HatchingShadowMaterialParameters) {
  const geometry = await prepareHatchingGeometry(source, { technique: 'engraving' });
  return new Mesh(geometry, new HatchingShadowMaterial({ technique: 'engraving', ...material }));
}

/** A scene in the light of one sun of intensity π. */
export function sceneOf(...meshes: Mesh[]): Scene {
  const scene = new Scene();
  const sun = new DirectionalLight('white', Math.PI);
  sun.position.set(-0.55, 0.75, 0.6);
  scene.add(sun, ...meshes);
  return scene;
}

/** A camera that looks at the origin, with a picture of just over radius 1. */
export function cameraAt(x: number, y: number, z: number, isOrthographic = false): Camera {
  const camera = isOrthographic
    ? new OrthographicCamera(-1.05, 1.05, 1.05, -1.05, 0.1, 50)
    : new PerspectiveCamera(28, 1, 0.1, 50);
  camera.position
    .set(x, y, z)
    .normalize()
    .multiplyScalar(1 / Math.sin((14 * Math.PI) / 180) / 0.94);
  camera.lookAt(0, 0, 0);
  return camera;
}

/** A plane that faces the camera and prints one tone, without variation by hand. */
export const planeOfTone = (tone: number, material: HatchingMaterialParameters = {}) =>
  hatchedMesh(new PlaneGeometry(3, 3, 8, 8), {
    outlines: false,
    material: {
      direction: 'slant',
      irregularity: 0,
      crossFrom: 1,
      reflectedLight: 0,
      toneCurve: [
        [0, tone],
        [1, tone],
      ],
      ...material,
    },
  });
