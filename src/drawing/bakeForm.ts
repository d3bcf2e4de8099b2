import type { BufferGeometry, Object3D } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { meshesOf } from './meshesOf.js';

/** The attributes of lines that follow the form. */
const NAMES = ['formValue', 'formSlope', 'formCrossing'] as const;

/**
 * Bakes what lines that follow the form are drawn from into the geometries of a hatched model, one after the other: each is drawn with
 * it as soon as it is ready. Lines run across what is up in the world.
 *
 * @param form.crossAngle between lines and those that cross them, in radians
 * @param form.auto whether only shapes that have a form are drawn with it
 * @param onBaked called before a geometry is drawn in the place of the former one. Both are the same where it only gets other attributes
 * @param onExchanged called when it is what will be drawn, with all attributes
 */
export async function bakeForm(
  root: Object3D,
  form: { crossAngle: number; auto: boolean },
  { signal, ...options }: { signal: AbortSignal; onProgress: (progress: number) => void },
  onBaked: (former: BufferGeometry, made: BufferGeometry) => void,
  onExchanged: () => void = () => {},
): Promise<void> {
  root.updateMatrixWorld();
  const meshes = meshesOf(root);
  const geometries = new Set(meshes.map(({ geometry }) => geometry));
  let done = 0;
  for (const geometry of geometries) {
    const sharing = meshes.filter((mesh) => mesh.geometry === geometry);
    const onProgress = (progress: number): void => options.onProgress((done + progress) / geometries.size);
    const { elements } = sharing[0].matrixWorld;
    const up = [elements[1], elements[5], elements[9]] as const;
    const outlines = geometry.index !== null;
    const baked = await prepareHatchingGeometry(geometry, {
      signal,
      onProgress,
      layout: 'indexed',
      outlines,
      form: { ...form, up },
    });
    done++;
    if (lineFieldOf(geometry) === 'light' && lineFieldOf(baked) === 'light') continue;
    if (geometry.index === null) {
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
  const [vertices, newVertices] = [from, to].map(({ index }) => index!.array);
  // Not by the methods of attributes, which would block the page for longer than a frame where there are millions of corners.
  for (let corner = 0; corner < vertices.length; corner++)
    target[4 * newVertices[corner] + 3] = source[4 * vertices[corner] + 3];
}
