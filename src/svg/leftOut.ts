import type { Material, Mesh, Object3D } from 'three';
import { checkGeometry } from '../geometry/checkGeometry.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { describeObject } from '../mistakes/describeObject.js';

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

/** What is wrong with the geometry of a mesh, so that it cannot be read; undefined if nothing is. */
export function faultOf({ geometry }: Mesh): string | undefined {
  try {
    checkGeometry(geometry, 'drawSVG');
    return undefined;
  } catch (error) {
    return `is left out: ${(error as Error).message.replace(/^drawSVG: /, '').replace(/\.$/, '')}`;
  }
}

/** Why nothing of a mesh can be drawn; undefined if it can. */
export function whyNothing(mesh: Mesh): string | undefined {
  const { geometry } = mesh;
  if ('isBatchedMesh' in mesh) return 'is left out: batches cannot leave as lines yet';
  if ('isInstancedMesh' in mesh) return 'is left out: instances cannot leave as lines yet';
  if ('isSkinnedMesh' in mesh) return 'is left out: skins cannot leave as lines yet';
  if (mesh.morphTargetInfluences?.some((influence) => influence !== 0))
    return 'is left out: morph targets cannot leave as lines yet';
  const layout: unknown = geometry.userData.hatching?.layout;
  if (layout === 'pull')
    return "is left out: its geometry has the layout 'pull', so prepare it without adjacency and layout";
  if (!geometry.attributes.position) return 'is left out: its geometry has no positions';
  return undefined;
}

/** Why the surface of a mesh has no lines, though its outlines may be drawn and it hides what is behind it; undefined if it has. */
export function whyNoLines(mesh: Mesh, material: Material): string | undefined {
  if (!('isHatchingMaterial' in material)) return 'has no lines: its material is no HatchingMaterial';
  const { technique } = material as HatchingMaterial;
  if (technique !== 'engraved' && !isStippled(material as HatchingMaterial))
    return `has no lines: strokes of the technique '${technique}' are drawn from images`;
  if (!mesh.geometry.attributes.normal) return 'has no lines: its geometry has no normals';
  return undefined;
}

/** Whether a surface is drawn in dots. */
export const isStippled = ({ technique, medium }: HatchingMaterial): boolean =>
  technique === 'anchored' && medium === 'stipple';

const MAPS = ['map', 'alphaMap', 'normalMap', 'bumpMap', 'aoMap', 'lightMap', 'emissiveMap'] as const;

/** What a surface with lines is drawn without. */
export function drawnWithout(material: HatchingMaterial): string[] {
  const found: string[] = [];
  const maps = MAPS.filter((name) => material[name]);
  if (maps.length > 0) found.push(`is drawn without ${maps.join(', ')}: textures cannot leave as lines yet`);
  if (material.vertexColors && material.localTone > 0) found.push('is drawn without the colours of its vertices');
  if (material.toneNormal === 'face' || material.flatShading)
    found.push('is drawn with smooth tones, not those of flat faces');
  const isInLines = !isStippled(material);
  if (!isInLines && material.strokeLayers !== 'single') found.push('is drawn in one layer of dots');
  if (material.opacity < 1 || material.alphaTest > 0 || material.alphaHash) found.push('is drawn as if it were opaque');
  if (material.clippingPlanes && material.clippingPlanes.length > 0) found.push('is drawn without its clipping planes');
  return found;
}
