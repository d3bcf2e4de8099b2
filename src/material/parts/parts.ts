import type { Camera, IUniform, Scene, WebGLRenderer } from 'three';
import type { HatchingTechnique } from '../../look/hatchingProperties.js';
import { familyOf } from '../../look/presetParameters.js';
import { isFitted, writeFit } from '../exposure/ToneFit.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import type { MaterialPart } from './MaterialPart.js';

/** The import of each part. The technique `hatching`, the default, needs none. */
const FETCH = {
  dryMedia: () => import('./dryMedia.js'),
  stipple: () => import('./stipple.js'),
  lines: () => import('./lines.js'),
  perTriangle: () => import('./perTriangle.js'),
  exposure: () => import('./exposure.js'),
};

export type PartName = keyof typeof FETCH;

const NAMES: Readonly<Record<PartName, string>> = {
  dryMedia: 'the technique "dryMedia"',
  stipple: 'the technique "stipple"',
  lines: 'the techniques "engraving", "pen" and "woodcut"',
  perTriangle: 'the techniques "triangle" and "adjacency"',
  exposure: 'at the exposure "auto"',
};

const fetched = /* @__PURE__ */ new Map<PartName, MaterialPart>();
const fetching = /* @__PURE__ */ new Map<PartName, Promise<MaterialPart>>();

/** The part that a technique needs; null if none. */
export function partNameOf(technique: HatchingTechnique): PartName | null {
  if (technique === 'dryMedia' || technique === 'stipple') return technique;
  const family = familyOf(technique);
  return family === 'strokes' ? null : family;
}

/** The properties that decide which parts a material needs. */
export interface LookOfParts {
  readonly technique: HatchingTechnique;
  readonly exposure: number | 'auto';
}

/** All parts that a look needs. */
const partNamesOf = ({ technique, exposure }: LookOfParts): PartName[] =>
  [partNameOf(technique), exposure === 'auto' ? ('exposure' as const) : null].filter((name) => name !== null);

/** A part that has loaded; undefined if it has not. */
export const fetchedPart = (name: PartName): MaterialPart | undefined => fetched.get(name);

/** Whether all parts of a look have loaded. */
export const isFetched = (look: LookOfParts): boolean => partNamesOf(look).every((name) => fetched.has(name));

/**
 * Fetches a part, once. A failure, such as a missing network, is reported, and the next call tries again.
 *
 * @throws Error that names the part that could not be fetched
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
    // Callers that await the part get the error too, but many materials do not await it.
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

/** The part that the program of one material uses. */
export class PartInUse {
  /** The part; null if the program needs none. */
  part: MaterialPart | null = null;
  private awaited: PartName | null = null;

  /** @param onFetched called when a missing part has loaded */
  constructor(private readonly onFetched: () => void) {}

  /**
   * Uses the part that a look needs, or fetches it.
   *
   * @returns whether it has loaded; if not, the previous part stays in use
   */
  take({ technique }: { technique: HatchingTechnique }): boolean {
    const name = partNameOf(technique);
    const part = name && fetchedPart(name);
    if (part !== undefined) this.part = part;
    else if (this.awaited !== name) this.await(name!);
    return part !== undefined;
  }

  private await(name: PartName): void {
    this.awaited = name;
    const end = (): void => {
      if (this.awaited === name) this.awaited = null;
    };
    fetchPart(name).then(() => {
      end();
      this.onFetched();
    }, end);
  }
}

/** The exposure of one material, if it is fitted to the scene. */
export class ExposureInUse {
  private isAwaited = false;

  /** Fetches the code that fits an exposure, if a material needs it. */
  fetch({ exposure }: HatchingMaterialProperties): void {
    if (exposure !== 'auto' || this.isAwaited) return;
    this.isAwaited = true;
    // Failures are reported where they occur.
    fetchPart('exposure').catch(() => {});
  }

  /** Writes the exposure that suits the scene being drawn, once the code has loaded. */
  write(
    material: HatchingMaterialProperties,
    renderer: WebGLRenderer,
    scene: Scene,
    camera: Camera,
    uniforms: Readonly<Record<string, IUniform>>,
  ): void {
    this.fetch(material);
    if (!isFitted(material)) return;
    const fit = fetchedPart('exposure')?.sceneExposure?.(renderer, scene, camera);
    if (fit) writeFit(fit, material, uniforms);
  }
}
