import { identityOf } from '../geometry/identityOf.js';
import { describeObject } from '../diagnostics/describeObject.js';
import { tell } from '../diagnostics/tell.js';
import type { FirstDraw } from './FirstDraw.js';
import { findLightMistake } from './findLightMistake.js';
import { findStrokeMistakes } from './findStrokeMistakes.js';
import { findSurfaceMistakes } from './findSurfaceMistakes.js';
import { isOnlyFrame } from './isOnlyFrame.js';
import type { NoteMistake } from './NoteMistake.js';
import { printsNothing } from './printsNothing.js';
import { type Mistake, SENTENCES, type Sentence } from './sentences.js';

export { isStale } from '../geometry/staleGeometry.js';

/** What was said of each thing: a material, a geometry, a scene or a renderer. */
const told = new WeakMap<object, Set<Mistake>>();

/** Says what is wrong with meshes that were drawn for the first time, each mistake in one sentence that names the first of them. */
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
    tell(`HatchingMaterial: ${sentence(name, ...details)}`, mistake === 'noAdjacency' ? 'error' : 'warn');
  }
  const early = draws.find(({ isWhole }) => !isWhole);
  // What cannot be fetched or drawn is told of where that fails.
  if (early) awaitSecondFrame(early).catch(() => {});
}

/** Says that nothing is drawn after what a mesh lacked when it was drawn has come. */
async function awaitSecondFrame(draw: FirstDraw): Promise<void> {
  const isMissing = await isOnlyFrame(draw);
  if (isMissing && isStillThere(draw) && isNews('onlyFrame', draw.renderer))
    tell(`HatchingMaterial: ${SENTENCES.onlyFrame(`the ${describeObject(draw.mesh)}`)}`);
}

/** While the checks were loaded a scene may have been taken apart, and then lacks more than it did. */
function isStillThere({ mesh, scene }: FirstDraw): boolean {
  let root: FirstDraw['mesh'] | null = mesh;
  // One of them may be a proxy of the other.
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
