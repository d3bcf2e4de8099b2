import type { BufferAttribute, BufferGeometry, Mesh, SkinnedMesh } from 'three';

/** What three's renderer of nodes rewrites in place when it uploads it, so that WebGLRenderer cannot draw it any more. */
const NARROW = [Int8Array, Uint8Array, Int16Array, Uint16Array] as const;

const isRewritten = ({ array, normalized }: Pick<BufferAttribute, 'array' | 'normalized'>): boolean =>
  !normalized && NARROW.some((type) => array instanceof type);

const isPacked = ({ attributes }: BufferGeometry): boolean => Object.values(attributes).some(isRewritten);

/** What of a model nodes do not draw on a page that goes back to WebGL, in words; undefined if they draw all of it. */
export function lackOfMeshes(meshes: readonly Mesh[]): string | undefined {
  // The indices of bones are narrow too, in almost every file: this says it in better words.
  if (meshes.some((mesh) => (mesh as Partial<SkinnedMesh>).isSkinnedMesh)) return 'models with bones';
  return meshes.some(({ geometry }) => isPacked(geometry)) ? 'models with packed vertices' : undefined;
}
