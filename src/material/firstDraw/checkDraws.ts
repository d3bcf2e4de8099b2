import { NoToneMapping } from 'three';
import { formOf, needsAdjacency, needsMap } from '../../look/queries.js';
import { cornerLayout, hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { deforms, hasFloatTargets, morphsEachInstance } from '../deformation/canDeform.js';
import { describeObject } from '../diagnostics/describeObject.js';
import { warn } from '../diagnostics/warn.js';
import { isFormExpected, isFormed } from '../geometry/formGeometry.js';
import { identityOf } from '../geometry/identityOf.js';
import { pulledVerticesOf } from '../geometry/pulledVerticesOf.js';
import { isStale } from '../geometry/staleGeometry.js';
import type { DrawnMaterial, FirstDraw, NoteMistake } from './FirstDraw.js';
import { findLightMistake, findStrokeMistakes } from './findMistakes.js';
import { type Mistake, SENTENCES, type Sentence } from './sentences.js';

/** Whether a material is blank paper on purpose: its tone curve is 0 everywhere, as on a surface that only hides lines behind it. */
const printsNothing = ({ toneCurve }: DrawnMaterial): boolean =>
  Array.isArray(toneCurve) && toneCurve.every(([, ink]: readonly number[]) => ink === 0);

/** The time, in milliseconds after everything has loaded, in which a page should have drawn a second frame. */
const SECOND_FRAME_MS = 3000;

/** Whether a renderer has drawn nothing since a mesh whose map or code was missing, although that has loaded since. */
async function isOnlyFrame({ material, renderer, frame }: FirstDraw): Promise<boolean> {
  await material.ready;
  await new Promise((resolve) => setTimeout(resolve, SECOND_FRAME_MS));
  // A background page draws when it is shown again, and requests that frame before this one.
  await new Promise((resolve) => requestAnimationFrame(resolve));
  return renderer.info.render.frame === frame && !renderer.getContext().isContextLost();
}

export { isStale } from '../geometry/staleGeometry.js';
export { warnOfChunk } from '../three/warnOfChunk.js';

/** The mistakes that were reported of each material, geometry, scene or renderer. */
const told = new WeakMap<object, Set<Mistake>>();

/** Reports mistakes in meshes that were drawn for the first time: one message per mistake, which names the first mesh. */
export function checkDraws(given: readonly FirstDraw[]): void {
  const draws = given.filter(isStillThere);
  const found = new Map<Mistake, { mesh: FirstDraw['mesh']; details: readonly string[]; others: number }>();
  const note: NoteMistake = (mistake, { mesh }, culprit, ...details) => {
    if (!isNews(mistake, culprit)) return;
    const before = found.get(mistake);
    if (before) before.others++;
    else found.set(mistake, { mesh, details, others: 0 });
  };
  for (const draw of draws) findSurfaceMistakes(draw, note);
  const inked = draws.filter(({ material }) => !printsNothing(material));
  for (const ofScene of groupBy(inked, ({ scene }) => scene)) {
    findStrokeMistakes(ofScene, note);
    findLightMistake(ofScene, note);
  }
  for (const [mistake, { mesh, details, others }] of found) {
    const sentence: Sentence = SENTENCES[mistake];
    const name = `the ${describeObject(mesh)}${others > 0 ? ` and ${others} more` : ''}`;
    warn(`HatchingMaterial: ${sentence(name, ...details)}`, mistake === 'noAdjacency' ? 'error' : 'warn');
  }
  const early = draws.find(({ isWhole }) => !isWhole);
  // Failures to load are reported where they occur.
  if (early) awaitSecondFrame(early).catch(() => {});
}

/** Warns if no frame is drawn after the missing map or code of a mesh has loaded. */
async function awaitSecondFrame(draw: FirstDraw): Promise<void> {
  const isMissing = await isOnlyFrame(draw);
  if (isMissing && isStillThere(draw) && isNews('onlyFrame', draw.renderer))
    warn(`HatchingMaterial: ${SENTENCES.onlyFrame(`the ${describeObject(draw.mesh)}`)}`);
}

/** Whether a mesh is still in its scene: while the checks were loaded, the scene may have been taken apart. */
function isStillThere({ mesh, scene }: FirstDraw): boolean {
  let root: FirstDraw['mesh'] | null = mesh;
  // One of the two may be a proxy of the other.
  while (root && root.id !== scene.id) root = root.parent;
  return root !== null;
}

function isNews(mistake: Mistake, culprit: object): boolean {
  const identity = identityOf(culprit);
  const mistakes = told.get(identity) ?? new Set();
  told.set(identity, mistakes);
  const isNew = !mistakes.has(mistake);
  mistakes.add(mistake);
  return isNew;
}

function groupBy<Item>(items: readonly Item[], keyOf: (item: Item) => unknown): Iterable<readonly Item[]> {
  const groups = new Map<unknown, Item[]>();
  for (const item of items) {
    const key = keyOf(item);
    const group = groups.get(key);
    if (group) group.push(item);
    else groups.set(key, [item]);
  }
  return groups.values();
}

/** Finds mistakes in the material and the geometry of a mesh. */
function findSurfaceMistakes(draw: FirstDraw, note: NoteMistake): void {
  const { material, geometry, renderer, isOnScreen } = draw;
  if (material.tonalArtMap === null && needsMap(material) && !printsNothing(material)) note('noMap', draw, material);
  const mistake = needsAdjacency(material) ? adjacencyMistake(draw) : undefined;
  if (mistake) note(mistake, draw, geometry);
  else if (!geometry.attributes.normal && !geometry.attributes[hatchNormal.name]) note('noNormals', draw, geometry);
  const hasNoForm = formOf(material) === true && !isFormed(geometry) && !isFormExpected(geometry);
  if (hasNoForm) note('noForm', draw, geometry);
  if (isStale(geometry))
    note(geometry.userData.hatching.layout === 'indexed' ? 'movedIndexed' : 'moved', draw, geometry);
  if (isOnScreen && material.toneMapped && renderer.toneMapping !== NoToneMapping) note('toneMapped', draw, renderer);
}

/**
 * The mistake that keeps a mesh from being hatched by the strokes of its triangles and their neighbours in its present pose, if any.
 */
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
