import { LessDepth, LessEqualDepth, type Material, type Mesh, type Object3D } from 'three';
import { drawsLines } from '../../look/queries.js';
import { describeObject } from '../../material/diagnostics/describeObject.js';
import { checkGeometry } from '../../material/geometry/checkGeometry.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { isBlended } from './PaintReader.js';

/** Something that a drawing does not show as the canvas does. */
export interface LeftOut {
  object: Object3D;
  /** What is missing and why: a sentence that names the object. */
  reason: string;
}

/** A reason, as a sentence about an object. */
export const sentence = (object: Object3D, what: string): LeftOut => ({
  object,
  reason: `The ${describeObject(object)} ${what}.`,
});

/** The fault of a mesh's geometry because of which it cannot be read; undefined for none. */
export function faultOf({ geometry }: Mesh): string | undefined {
  try {
    checkGeometry(geometry, 'drawSVG');
    return undefined;
  } catch (error) {
    return `is left out: ${(error as Error).message.replace(/^drawSVG: /, '').replace(/\.$/, '')}`;
  }
}

/** Why the surface of a mesh has no lines, though its outlines may be drawn and it hides what is behind it; undefined if it has lines. */
export function whyNoLines(mesh: Mesh, material: Material): string | undefined {
  if (!('isHatchingMaterial' in material)) return 'has no lines: its material is no HatchingMaterial';
  const { technique } = material as HatchingMaterial;
  if (!drawsLines(technique) && technique !== 'stipple')
    return `has no lines: strokes of the technique '${technique}' are drawn from images`;
  if (!mesh.geometry.attributes.normal) return 'has no lines: its geometry has no normals';
  return undefined;
}

/** The per-pixel test of a material that lines cannot follow; undefined for none. */
export function untestedBy({ depthTest, depthFunc, stencilWrite }: Material): string | undefined {
  if (stencilWrite) return 'is drawn as if its material had no stencil: lines are not tested pixel by pixel';
  if (!depthTest || (depthFunc !== LessEqualDepth && depthFunc !== LessDepth))
    return 'is drawn where nothing lies before it: its material draws by another depth test';
  return undefined;
}

/** Whether a surface is drawn in dots. */
export const isStippled = ({ technique }: HatchingMaterial): boolean => technique === 'stipple';

/** What a surface with lines is drawn without. lights: number of lights with a direction. */
export function drawnWithout(material: HatchingMaterial, lights: number): string[] {
  const found: string[] = [];
  if (isStippled(material) && material.strokeLayers === 'lights' && lights > 1)
    found.push('is drawn in one layer of dots: where several lights disagree the canvas has two');
  if (isBlended(material)) found.push('is drawn opaque where it is more than half there, and left out elsewhere');
  return found;
}
