import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute, Mesh } from 'three';
import { warn } from '../material/diagnostics/warn.js';
import { isFormExpected } from '../material/geometry/formGeometry.js';
import { formLayout, hatchNormal } from '../mesh/bake/attributeLayouts.js';
import type { DetailRequest } from '../mesh/detail/simplifyHatched.js';
import { runSliced } from '../mesh/runSliced.js';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import type { MeshLook } from './geometryPlans.js';
import { LeveledGeometry, LeveledMesh } from './LeveledMesh.js';
import { isBatched } from './surfaceMeshes.js';

/** Draws large meshes with no more triangles than can be seen. This module is fetched if the option `detail` is set. */

/** Options for drawing large meshes with no more triangles than can be seen. */
export interface DetailOptions {
  /**
   * The address of meshoptimizer's simplifier, which is not part of this library: install `meshoptimizer`, and let your bundler provide
   * the address of its file. With Vite:
   *
   *     import simplifier from 'meshoptimizer/simplifier?url';
   *
   * In a page without a bundler `import.meta.resolve('meshoptimizer/simplifier')` is the address that the import map gives.
   */
  simplifier: string | URL;
}

/** @throws TypeError that names the remedy */
function checkDetail(detail: DetailOptions): void {
  const { simplifier } = Object(detail) as Partial<DetailOptions>;
  if (simplifier instanceof URL || (typeof simplifier === 'string' && simplifier !== '')) return;
  throw new TypeError(
    'applyHatching: detail must be an object whose simplifier is the address of meshoptimizer/simplifier, or left out.',
  );
}

/** The number of triangles below which meshes are drawn whole: a GPU would not be faster with fewer. */
const FEWEST_TRIANGLES = 200_000;

/** Whether levels can be made of the baked geometry of a mesh. */
function canHaveLevels({ geometry, mesh, material }: MeshLook): boolean {
  const { index, attributes, morphAttributes } = geometry;
  if (isBatched(mesh) || 'isInstancedMesh' in mesh || 'isSkinnedMesh' in mesh || Array.isArray(material)) return false;
  if (!index || index.count < 3 * FEWEST_TRIANGLES || Object.keys(morphAttributes).length > 0) return false;
  // The geometry will soon be replaced.
  if (isFormExpected(geometry)) return false;
  const { position, uv, color } = attributes;
  return [position, uv, color].every((attribute) => attribute === undefined || isPlain(attribute));
}

const isPlain = (attribute: BufferAttribute | InterleavedBufferAttribute): boolean =>
  attribute.array instanceof Float32Array && !('isInterleavedBufferAttribute' in attribute);

/** Copies the data of a geometry for the worker. It yields after each array, since they are large. */
function* requestOf(geometry: BufferGeometry, simplifier: string): Generator<number, DetailRequest, void> {
  const { position, uv, color, [hatchNormal.name]: normal, [formLayout.value.name]: form } = geometry.attributes;
  const positions = new Float32Array(position.array);
  yield 0;
  const hatchNormals = new Int16Array(normal.array);
  yield 0;
  const indices = new Uint32Array(geometry.index!.array);
  yield 0;
  const uvs = uv ? new Float32Array(uv.array) : null;
  const colors = color ? new Float32Array(color.array) : null;
  const forms = form ? new Float32Array(form.array) : null;
  return { positions, hatchNormals, uvs, colors, forms, indices, radius: geometry.boundingSphere!.radius, simplifier };
}

/** Ends the drawing of levels of one mesh, or of all. */
export type HideDetail = (only?: Mesh) => void;

/** Makes levels of looks, and reports its progress in [0, 1]. The returned function starts to draw them. */
export type MakeLevels = (
  looks: readonly MeshLook[],
  onProgress?: (progress: number) => void,
) => Promise<() => HideDetail>;

/**
 * Returns a function that makes levels of all large meshes that can have them, one after the other. If the simplifier cannot be loaded,
 * it warns, and the meshes are drawn whole.
 *
 * @throws TypeError for a wrong option
 */
export function levelMaker(detail: DetailOptions, { signal, createWorker }: TaskOptions): MakeLevels {
  checkDetail(detail);
  return (looks, onProgress) => drawLevels(looks, detail, { signal, createWorker, onProgress });
}

async function drawLevels(
  looks: readonly MeshLook[],
  { simplifier }: DetailOptions,
  options: TaskOptions,
): Promise<() => HideDetail> {
  const leveled = new Map<BufferGeometry, LeveledGeometry>();
  const address = absolute(simplifier);
  const geometries = [...new Set(looks.filter(canHaveLevels).map(({ geometry }) => geometry))];
  try {
    for (const [i, geometry] of geometries.entries()) {
      const onProgress = (progress: number): void => options.onProgress?.((i + progress) / geometries.length);
      const request = await runSliced(requestOf(geometry, address), { signal: options.signal });
      const levels = await runTask('simplifyHatched', request, { ...options, onProgress });
      leveled.set(geometry, new LeveledGeometry(geometry, levels));
    }
  } catch (error) {
    options.signal?.throwIfAborted();
    warn(`applyHatching: meshes are drawn without levels of detail. ${(error as Error).message}`);
  }
  options.onProgress?.(1);
  return () => {
    const meshes = new Map<Mesh, LeveledMesh>();
    for (const { mesh, geometry } of looks) {
      const levels = leveled.get(geometry);
      if (levels) meshes.set(mesh, new LeveledMesh(mesh, levels));
    }
    return (only) => {
      for (const [mesh, one] of meshes) {
        if (only && only !== mesh) continue;
        one.remove();
        meshes.delete(mesh);
      }
    };
  };
}

/** The absolute address: the worker has another base address than the page. */
const absolute = (address: string | URL): string =>
  typeof document === 'undefined' ? String(address) : new URL(address, document.baseURI).href;
