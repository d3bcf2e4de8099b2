import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { isMirror } from '../../look/mirrors.js';
import { familyOf } from '../../look/presetParameters.js';
import { drawsHand } from '../../look/queries.js';
import type { PaintedLook } from './laterPlans.js';
import type { MaterialPart } from './MaterialPart.js';

/** At least one of them has the surface and the files. */
type Imports = readonly Promise<{ part: Partial<MaterialPart> }>[];

/** The imports of each part. All start at once, so that none waits for another. */
const FETCH = {
  strokes: (): Imports => [import('./strokes.js')],
  dryMedia: (): Imports => [import('./strokes.js'), import('./dryMedia.js')],
  stipple: (): Imports => [import('./strokes.js'), import('./stipple.js')],
  lines: (): Imports => [import('./lines.js')],
  handStrokes: (): Imports => [import('./lines.js'), import('./handStrokes.js'), import('./handRows.js')],
  woodcut: (): Imports => [import('./lines.js'), import('./woodcut.js')],
  perTriangle: (): Imports => [import('./strokes.js'), import('./perTriangle.js')],
};

type TechniquePart = keyof typeof FETCH;

/** The name of a part: that of a technique, for any surface or for metal that mirrors. */
export type PartName = TechniquePart | `${TechniquePart} of metal`;

const fetched = /* @__PURE__ */ new Map<PartName, MaterialPart>();
const fetching = /* @__PURE__ */ new Map<PartName, Promise<MaterialPart>>();

/** The part that a technique needs, with or without a hand. */
function techniquePart(look: LookOfParts): TechniquePart {
  if (drawsHand(look)) return 'handStrokes';
  const { technique } = look;
  return (technique in FETCH ? technique : familyOf(technique)) as TechniquePart;
}

/** The part that a look needs. */
export const partNameOf = (look: LookOfParts): PartName =>
  isMirror(look) ? `${techniquePart(look)} of metal` : techniquePart(look);

/** The properties that decide which part a material needs. */
export interface LookOfParts {
  readonly technique: HatchingTechnique;
  readonly hand?: unknown;
  readonly metalness?: unknown;
  readonly roughness?: unknown;
}

/** A part that has loaded; undefined if it has not. */
export const fetchedPart = (name: PartName): MaterialPart | undefined => fetched.get(name);

/** Whether the part of a look has loaded. */
export const isFetched = (look: LookOfParts): boolean => fetched.has(partNameOf(look));

/** Several parts as one. */
const joined = (parts: readonly Partial<MaterialPart>[]): MaterialPart =>
  Object.assign({}, ...parts, { files: Object.assign({}, ...parts.map(({ files }) => files)) });

/**
 * Fetches a part, once. A failure, such as a missing network, is reported, and the next call tries again.
 *
 * @throws Error that names the part that could not be fetched
 */
export function fetchPart(name: PartName): Promise<MaterialPart> {
  let promise = fetching.get(name);
  if (!promise) {
    const [technique, metal] = name.split(' of ') as [TechniquePart, string?];
    const imports = FETCH[technique]();
    promise = Promise.all(metal ? [...imports, import('./metal.js')] : imports).then(
      (imported) => {
        const part = joined(imported.map((one) => one.part));
        fetched.set(name, part);
        return part;
      },
      (cause: unknown) => {
        fetching.delete(name);
        throw failure(name, cause);
      },
    );
    // Callers that await the part get the error too, but many materials do not await it.
    promise.catch(({ message }: Error) => console.error(message));
    fetching.set(name, promise);
  }
  return promise;
}

const failure = (name: PartName, cause: unknown): Error =>
  new Error(
    `HatchingMaterial: the code that draws "${name}" could not be fetched (${cause instanceof Error ? cause.message : String(cause)}). Serve all files of the package; the next material, or "ready", tries again.`,
    { cause },
  );

/** Fetches the part that a look needs, and what its colours need. */
export async function fetchPartsOf(look: LookOfParts & PaintedLook): Promise<void> {
  const { surface } = await fetchPart(partNameOf(look));
  await surface.fetchPlansOf(look);
}

/** Fetches all parts. */
export async function fetchParts(): Promise<void> {
  const names = (Object.keys(FETCH) as TechniquePart[]).flatMap((name) => [name, `${name} of metal`] as const);
  const [{ surface }] = await Promise.all(names.map(fetchPart));
  await surface.fetchPlans();
}

/** The part that the program of one material uses. */
export class PartInUse {
  /** The part; null before the first has loaded. */
  part: MaterialPart | null = null;
  private awaited: PartName | null = null;

  /** @param onFetched called when a missing part has loaded */
  constructor(private readonly onFetched: () => void) {}

  /**
   * Uses the part that a look needs, or fetches it.
   *
   * @returns the part, if it has loaded; if not, the previous part stays in use
   */
  take(look: LookOfParts): MaterialPart | undefined {
    const name = partNameOf(look);
    const part = fetchedPart(name);
    if (part) {
      this.part = part;
      this.awaited = null;
    } else if (this.awaited !== name) this.await(name);
    return part;
  }

  private await(name: PartName): void {
    this.awaited = name;
    const end = (): void => {
      if (this.awaited === name) this.awaited = null;
    };
    // Of properties that are set one after the other, the last decides what is fetched.
    queueMicrotask(() => {
      if (this.awaited !== name) return;
      fetchPart(name).then(() => {
        end();
        this.onFetched();
      }, end);
    });
  }
}
