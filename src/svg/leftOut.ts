import { type Material, type Mesh, type Object3D, ObjectSpaceNormalMap } from 'three';
import { importanceOf } from '../material/emphasis/importanceOf.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { describeObject } from '../mistakes/describeObject.js';
import { isBlended } from './PaintReader.js';

/** Something that a drawing does not show as the canvas does. */
export interface LeftOut {
  object: Object3D;
  /** What is missing and why: a sentence that names the object. */
  reason: string;
}

/** What may not leave as lines, in words. */
export const sentence = (object: Object3D, what: string): LeftOut => ({
  object,
  reason: `The ${describeObject(object)} ${what}.`,
});

/** Why nothing of a mesh can be drawn; undefined if it can. */
export function whyNothing(mesh: Mesh): string | undefined {
  const { geometry } = mesh;
  if (!geometry.attributes.position) return 'is left out: its geometry has no positions';
  return undefined;
}

/** Why the surface of a mesh has no lines, though its outlines may be drawn and it hides what is behind it; undefined if it has. */
export function whyNoLines(mesh: Mesh, material: Material): string | undefined {
  if (!('isHatchingMaterial' in material)) return 'has no lines: its material is no HatchingMaterial';
  const { technique, toneModel } = material as HatchingMaterial;
  if (technique !== 'engraved') return `has no lines: strokes of the technique '${technique}' are drawn from images`;
  if (toneModel === 'shadow') return 'has no lines: shadows alone, on a ground, cannot leave as lines yet';
  if (!mesh.geometry.attributes.normal) return 'has no lines: its geometry has no normals';
  return undefined;
}

/** What a surface with lines is drawn without. */
export function drawnWithout(mesh: Mesh, material: HatchingMaterial): string[] {
  const found: string[] = [];
  if (material.bumpMap) found.push('is drawn without bumpMap: heights cannot leave as lines yet');
  if (material.normalMap && material.normalMapType === ObjectSpaceNormalMap)
    found.push('is drawn without normalMap: normals in object space cannot leave as lines yet');
  if (material.medium === 'pen' || material.medium === 'woodcut')
    found.push(`is drawn in unbroken lines: strokes of the medium '${material.medium}' cannot leave as lines yet`);
  if (material.shadowStrokes === 'reorient') found.push('is drawn with lines that do not turn in shadows');
  if (isBlended(material)) found.push('is drawn opaque where it is more than half there, and left out elsewhere');
  else if (material.opacity < 1 || (material.alphaHash && material.alphaTest === 0))
    found.push('is drawn as if it were opaque');
  if (fades(mesh, material))
    found.push('is drawn with its full weight: what fades by depth, focus or vignette does not do so yet');
  return found;
}

const fades = (mesh: Mesh, { depthFade, focus, vignette }: HatchingMaterial): boolean =>
  (typeof depthFade === 'number' && depthFade > 0) || focus !== null || vignette > 0 || importanceOf(mesh) < 1;
