import type { BufferGeometry, Object3D } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { meshesOf } from './meshesOf.js';

/** The attributes of lines that follow the form. */
const NAMES = ['formValue', 'formSlope', 'formCrossing'] as const;

/** What the geometries of a model are to have, beyond what every technique draws with. */
export interface Further {
  /** What lines that follow the form are drawn from: the angle at which lines cross, in radians, and whether it is only for shapes that have a form. */
  form?: { crossAngle: number; auto: boolean } | undefined;
  /** Triangle adjacency. */
  adjacency?: boolean;
}

/**
 * Bakes more into the geometries of a hatched model, one after the other: each is drawn with it as soon as it is ready. Lines run across
 * what is up in the world.
 *
 * @param onBaked called before a geometry is drawn in the place of the former one. Both are the same where it only gets other attributes
 * @param onExchanged called when it is what will be drawn, with all attributes
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
  // Damaged geometries could not be baked before either.
  const geometries = new Set(meshes.map(({ geometry }) => geometry).filter(isBaked));
  let done = 0;
  for (const geometry of geometries) {
    const sharing = meshes.filter((mesh) => mesh.geometry === geometry);
    const begun = done++;
    const onProgress = (progress: number): void => options.onProgress((begun + progress) / geometries.size);
    const { elements } = sharing[0].matrixWorld;
    const up = [elements[1], elements[5], elements[9]] as const;
    // A geometry without an index has adjacency, and gets no more than attributes.
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
    if (!addsAdjacency && lineFieldOf(geometry) === 'light' && lineFieldOf(baked) === 'light') continue;
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

/** What lines follow on a geometry. */
const lineFieldOf = (geometry: BufferGeometry): 'form' | 'light' => statisticsOf(geometry).lineField;

/** Copies the form of a geometry to one with the same vertices: each corner has one of its own. */
function copyForm(from: BufferGeometry, to: BufferGeometry): void {
  for (const name of NAMES) {
    if (from.hasAttribute(name)) to.setAttribute(name, from.getAttribute(name));
    else to.deleteAttribute(name);
  }
  statisticsOf(to).lineField = lineFieldOf(from);
}

/** Copies what `bakeOcclusion` has written to the vertices of a geometry. The corners of both are the same. */
function copyOcclusion(from: BufferGeometry, to: BufferGeometry): void {
  const [source, target] = [from, to].map(({ attributes }) => attributes.hatchNormal.array);
  const vertices = from.index!.array;
  const newVertices = to.index?.array;
  // Not by the methods of attributes, which would block the page for longer than a frame where there are millions of corners.
  for (let corner = 0; corner < vertices.length; corner++)
    target[4 * (newVertices ? newVertices[corner] : corner) + 3] = source[4 * vertices[corner] + 3];
}
