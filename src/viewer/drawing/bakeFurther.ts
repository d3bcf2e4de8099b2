import type { BufferGeometry, Object3D } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { meshesOf } from './meshes.js';

/** The attributes of form lines. */
const NAMES = ['formValue', 'formSlope', 'formCrossing'] as const;

/** Data to bake beyond the attributes that every technique uses. */
export interface Further {
  /** For form lines: the crossing angle in radians, and whether shapes without a clear form are left out. */
  form?: { crossAngle: number; auto: boolean } | undefined;
  /** Triangle adjacency. */
  adjacency?: boolean;
}

/**
 * Bakes more data into the geometries of a hatched model, one at a time; each is drawn as soon as it is ready. Form lines run across the
 * world's up direction.
 *
 * @param onBaked called before a new geometry replaces the former one. Both arguments are the same where attributes were added in place
 * @param onExchanged called when the new geometry is in place with all its attributes
 */
export async function bakeFurther(
  root: Object3D,
  { form, adjacency = false }: Further,
  { signal, ...options }: { signal: AbortSignal; onProgress: (progress: number) => void },
  onBaked: (former: BufferGeometry, made: BufferGeometry) => void,
  onExchanged: () => void = () => {},
): Promise<void> {
  root.updateMatrixWorld();
  const meshes = meshesOf(root);
  // Damaged geometries cannot be baked.
  const geometries = new Set(meshes.map(({ geometry }) => geometry).filter(isBaked));
  let done = 0;
  for (const geometry of geometries) {
    const sharing = meshes.filter((mesh) => mesh.geometry === geometry);
    const begun = done++;
    const onProgress = (progress: number): void => options.onProgress((begun + progress) / geometries.size);
    const { elements } = sharing[0].matrixWorld;
    const up = [elements[1], elements[5], elements[9]] as const;
    // A geometry without an index has adjacency already, and only gets attributes.
    const isIndexed = geometry.index !== null;
    const addsAdjacency = adjacency && isIndexed;
    if (!form && !addsAdjacency) continue;
    const baked = await prepareHatchingGeometry(geometry, {
      signal,
      onProgress,
      layout: addsAdjacency ? 'auto' : 'indexed',
      adjacency: addsAdjacency,
      outlines: isIndexed,
      form: form && { ...form, up },
    });
    if (!addsAdjacency && directionOf(geometry) === 'light' && directionOf(baked) === 'light') continue;
    if (!isIndexed) {
      onBaked(geometry, geometry);
      copyForm(baked, geometry);
    } else {
      onBaked(geometry, baked);
      copyOcclusion(geometry, baked);
      for (const mesh of sharing) mesh.geometry = baked;
    }
    onExchanged();
  }
}

const statisticsOf = ({ userData }: BufferGeometry): HatchingStatistics => userData.hatching;

const isBaked = (geometry: BufferGeometry): boolean => statisticsOf(geometry) !== undefined;

/** Which field the lines of a geometry follow. */
const directionOf = (geometry: BufferGeometry): 'form' | 'light' => statisticsOf(geometry).direction;

/** Copies the form attributes to a geometry with one vertex per corner. */
function copyForm(from: BufferGeometry, to: BufferGeometry): void {
  for (const name of NAMES) {
    if (from.hasAttribute(name)) to.setAttribute(name, from.getAttribute(name));
    else to.deleteAttribute(name);
  }
  statisticsOf(to).direction = directionOf(from);
}

/** Copies the attributes of `bakeOcclusion` between geometries with the same corners. */
function copyOcclusion(from: BufferGeometry, to: BufferGeometry): void {
  const [source, target] = [from, to].map(({ attributes }) => attributes.hatchNormal.array);
  const vertices = from.index!.array;
  const newVertices = to.index?.array;
  // Reads the array directly: attribute getters would block the page for longer than a frame with millions of corners.
  for (let corner = 0; corner < vertices.length; corner++)
    target[4 * (newVertices ? newVertices[corner] : corner) + 3] = source[4 * vertices[corner] + 3];
}
