import type { BufferAttribute, Color, Object3D } from 'three';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { isFitted } from '../exposure/isFitted.js';
import { identityOf } from '../geometry/identityOf.js';
import type { FirstDraw, NoteMistake } from './FirstDraw.js';
import { lightOn, luminance } from './lightOn.js';
import { rounded } from './sentences.js';
import { worldSphere } from './worldSphere.js';

/** Sums of intensities below and above which nearly everything is black or blank. A single light of intensity 1 is too dark. */
const TOO_DARK = Math.PI / 3;
const TOO_BRIGHT = 4 * Math.PI;

/** The identities of scenes whose lights were checked. Meshes that come into view later may stand far from their lights on purpose. */
const checkedScenes = new WeakSet<object>();

/** Finds a mistake in the lights of a scene, from its meshes that are drawn first. */
export function findLightMistake(draws: readonly FirstDraw[], note: NoteMistake): void {
  const lit = draws.filter(({ material }) => material.lights);
  if (lit.length === 0) return;
  const [first] = lit;
  const { scene, camera } = first;
  if (checkedScenes.has(identityOf(scene))) return;
  checkedScenes.add(identityOf(scene));
  const sphere = worldSphere(lit.map(({ mesh }): Object3D => mesh));
  const { least, most, hasForm } = lightOn(sphere, scene, camera);
  // An exposure that is fitted to the scene suits any light.
  const isExposed = lit.every(({ material }) => isFitted(material));
  if (least > TOO_BRIGHT && !isExposed) note('tooBright', first, scene, rounded(least));
  else if ((most >= TOO_DARK || (most > 0 && isExposed)) && hasForm) return;
  else if (lit.some(hasOwnForm)) return;
  else if (most === 0) note('noLight', first, scene);
  else if (!hasForm) note('ambientOnly', first, scene);
  else note('tooDark', first, scene, rounded(most));
}

/** Whether a mesh shows its form under any light: by light maps, emission or baked occlusion. */
function hasOwnForm({ material, geometry }: FirstDraw): boolean {
  const { lightMap, aoMap, emissive, emissiveIntensity, occlusion } = material;
  if (lightMap || aoMap || luminance(emissive as Color) * (emissiveIntensity as number) > 0) return true;
  const normals = geometry.attributes[hatchNormal.name] as BufferAttribute | undefined;
  if (occlusion === 0 || !normals?.array) return false;
  for (let i = 0; i < normals.count; i++) if (normals.getW(i) !== 0) return true;
  return false;
}
