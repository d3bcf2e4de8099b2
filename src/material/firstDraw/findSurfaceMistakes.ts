import { NoToneMapping } from 'three';
import { cornerLayout } from '../../mesh/bake/cornerLayout.js';
import { hatchNormal } from '../../mesh/bake/hatchNormal.js';
import { isFormExpected, isFormed } from '../geometry/formGeometry.js';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import { isStale } from '../geometry/staleGeometry.js';
import { deforms, hasFloatTargets, morphsEachInstance } from '../deformation/canDeform.js';
import { formFieldOf, formOf, needsAdjacency, needsMap } from '../../look/lookFacts.js';
import type { FirstDraw } from './FirstDraw.js';
import type { NoteMistake } from './NoteMistake.js';
import { printsNothing } from './printsNothing.js';
import type { Mistake } from './sentences.js';

/** Finds what is wrong with the material and the geometry of a mesh. */
export function findSurfaceMistakes(draw: FirstDraw, note: NoteMistake): void {
  const { material, geometry, renderer, isOnScreen } = draw;
  if (material.tonalArtMap === null && needsMap(material) && !printsNothing(material)) note('noMap', draw, material);
  const mistake = needsAdjacency(material) ? adjacencyMistake(draw) : undefined;
  if (mistake) note(mistake, draw, geometry);
  else if (!geometry.attributes.normal && !geometry.attributes[hatchNormal.name]) note('noNormals', draw, geometry);
  const hasNoForm = formOf(material) === true && !isFormed(geometry) && !isFormExpected(geometry);
  if (hasNoForm) note('noForm', draw, geometry, formFieldOf(material)!);
  if (isStale(geometry))
    note(geometry.userData.hatching.layout === 'indexed' ? 'movedIndexed' : 'moved', draw, geometry);
  if (isOnScreen && material.toneMapped && renderer.toneMapping !== NoToneMapping) note('toneMapped', draw, renderer);
}

/** What keeps a geometry from being hatched by the strokes of its triangles and their neighbours, in its present pose. */
function adjacencyMistake({ geometry, mesh, renderer }: FirstDraw): Mistake | undefined {
  const { attributes, userData } = geometry;
  if (!pulledVerticesOf(geometry)) {
    if (attributes[cornerLayout[0].name]) return deforms(geometry, mesh) ? 'cornerAtRest' : undefined;
    if (!attributes[hatchNormal.name]) return 'noAdjacency';
    return userData.hatching?.layout === 'indexed' ? 'noneAsked' : 'lostAdjacency';
  }
  if (!deforms(geometry, mesh)) return undefined;
  if (!hasFloatTargets(renderer)) return 'deviceAtRest';
  return morphsEachInstance(mesh) ? 'instancesAtRest' : undefined;
}
