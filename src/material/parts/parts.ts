import { HATCHING_TECHNIQUES, type HatchingTechnique, type Medium } from '../../look/hatchingProperties.js';
import type { MaterialPart } from './MaterialPart.js';

/** Fetches each part. Strokes of ink that are anchored, the default, need none. */
const FETCH = {
  dry: () => import('./dry.js'),
  stipple: () => import('./stipple.js'),
  engraved: () => import('./engraved.js'),
  perTriangle: () => import('./perTriangle.js'),
  exposure: () => import('./exposure.js'),
};

export type PartName = keyof typeof FETCH;

const NAMES: Readonly<Record<PartName, string>> = {
  dry: 'the medium "dry"',
  stipple: 'the medium "stipple"',
  engraved: 'the technique "engraved"',
  perTriangle: 'the techniques "triangle" and "adjacency"',
  exposure: 'at the exposure "auto"',
};

const fetched = /* @__PURE__ */ new Map<PartName, MaterialPart>();
const fetching = /* @__PURE__ */ new Map<PartName, Promise<MaterialPart>>();

/** The part that a technique needs, and with `anchored` the medium; null if none. */
export function partNameOf(technique: HatchingTechnique, medium: Medium): PartName | null {
  if (HATCHING_TECHNIQUES[technique].vertexData === 'adjacency') return 'perTriangle';
  if (technique === 'engraved') return technique;
  return medium === 'dry' || medium === 'stipple' ? medium : null;
}

/** What the parts that a material needs follow from. */
export interface LookOfParts {
  readonly technique: HatchingTechnique;
  readonly medium: Medium;
  readonly exposure: number | 'auto';
}

/** All the parts that a look needs. */
const partNamesOf = ({ technique, medium, exposure }: LookOfParts): PartName[] =>
  [partNameOf(technique, medium), exposure === 'auto' ? ('exposure' as const) : null].filter((name) => name !== null);

/** A part that was fetched before; undefined if it was not. */
export const fetchedPart = (name: PartName): MaterialPart | undefined => fetched.get(name);

/** Whether nothing has to be fetched for a look. */
export const isFetched = (look: LookOfParts): boolean => partNamesOf(look).every((name) => fetched.has(name));

/**
 * Fetches a part, once. If that fails, as it does without a network, it says so, and the next call tries again.
 *
 * @throws Error that says what could not be fetched
 */
export function fetchPart(name: PartName): Promise<MaterialPart> {
  let promise = fetching.get(name);
  if (!promise) {
    promise = FETCH[name]().then(
      ({ part }) => {
        fetched.set(name, part);
        return part;
      },
      (cause: unknown) => {
        fetching.delete(name);
        throw failure(name, cause);
      },
    );
    // Whoever waits for the part gets the error too, but many materials wait for nothing.
    promise.catch(({ message }: Error) => console.error(message));
    fetching.set(name, promise);
  }
  return promise;
}

const failure = (name: PartName, cause: unknown): Error =>
  new Error(
    `HatchingMaterial: the code that draws ${NAMES[name]} could not be fetched (${cause instanceof Error ? cause.message : String(cause)}); surfaces stay as they are. Serve all files of the package; the next material, or "ready", tries again.`,
    { cause },
  );

/** Fetches the parts that a look needs, if any. */
export async function fetchPartsOf(look: LookOfParts): Promise<void> {
  await Promise.all(partNamesOf(look).map(fetchPart));
}

/** Fetches all parts. */
export async function fetchParts(): Promise<void> {
  await Promise.all((Object.keys(FETCH) as PartName[]).map(fetchPart));
}
