import type { BufferGeometry, Object3D } from 'three';
import { prepareHatchingGeometry } from 'three-hatching';
import { meshesOf } from './meshesOf.js';

/** The attributes of lines that follow the form. */
const NAMES = ['formValue', 'formSlope', 'formCrossing'] as const;

/**
 * Bakes what lines that follow the form are drawn from into the geometries of a hatched model, one after the other: each is drawn with
 * it as soon as it is ready. Lines run across what is up in the world.
 *
 * @param crossAngle between lines and those that cross them, in radians
 * @returns the geometries that were made for it, and now are the meshes'
 */
export async function bakeForm(
  root: Object3D,
  { crossAngle, ...options }: { crossAngle: number; signal: AbortSignal; onProgress: (progress: number) => void },
  onBaked: () => void,
): Promise<BufferGeometry[]> {
  const made: BufferGeometry[] = [];
  root.updateMatrixWorld();
  const meshes = meshesOf(root);
  const geometries = new Set(meshes.map(({ geometry }) => geometry));
  let done = 0;
  for (const geometry of geometries) {
    const sharing = meshes.filter((mesh) => mesh.geometry === geometry);
    const onProgress = (progress: number): void => options.onProgress((done + progress) / geometries.size);
    const { elements } = sharing[0].matrixWorld;
    const up = [elements[1], elements[5], elements[9]] as const;
    const { signal } = options;
    const form = { crossAngle, up };
    const outlines = geometry.index !== null;
    const baked = await prepareHatchingGeometry(geometry, { signal, onProgress, layout: 'indexed', outlines, form });
    done++;
    if (geometry.index === null) {
      // Each corner has a vertex of its own, so that none was copied.
      for (const name of NAMES) geometry.setAttribute(name, baked.getAttribute(name));
    } else {
      copyOcclusion(geometry, baked);
      for (const mesh of sharing) mesh.geometry = baked;
      made.push(baked);
    }
    onBaked();
  }
  return made;
}

/** Copies what `bakeOcclusion` has written to the vertices of a geometry. The corners of both are the same. */
function copyOcclusion(from: BufferGeometry, to: BufferGeometry): void {
  const [source, target] = [from, to].map(({ attributes }) => attributes.hatchNormal);
  for (let corner = 0; corner < from.index!.count; corner++)
    target.setW(to.index!.getX(corner), source.getW(from.index!.getX(corner)));
}
