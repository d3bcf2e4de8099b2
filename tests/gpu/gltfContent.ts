import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** glTF files for the tests of meshes that deform, in one piece each: text, or base64 of a binary file. */

const folder = join(import.meta.dirname, '../../../shared/models');

/** A model of the shared folder, its buffer put inside; null where the folder is missing. */
export function sharedModel(name: string): string | null {
  const path = join(folder, name);
  if (!existsSync(path)) return null;
  if (name.endsWith('.glb')) return readFileSync(path, 'base64');
  const gltf: { buffers: { uri: string }[]; images?: unknown; textures?: unknown } = JSON.parse(
    readFileSync(path, 'utf8'),
  );
  for (const buffer of gltf.buffers) {
    if (!buffer.uri.startsWith('data:')) buffer.uri = dataUri(readFileSync(join(folder, buffer.uri)));
  }
  return JSON.stringify(gltf);
}

const dataUri = (bytes: Uint8Array) => `data:application/octet-stream;base64,${Buffer.from(bytes).toString('base64')}`;

/** A strip of two squares whose two morph targets are sparse: the one lifts two vertices, the other turns a normal. */
export function sparseMorphModel(): string {
  const positions = [0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0];
  const normals = [0, 1, 2, 3, 4, 5].flatMap(() => [0, 0, 1]);
  const indices = [0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4];
  const chunks = [
    Buffer.from(new Float32Array(positions).buffer),
    Buffer.from(new Float32Array(normals).buffer),
    Buffer.from(new Uint16Array(indices).buffer),
    Buffer.from(new Uint16Array([1, 4]).buffer),
    Buffer.from(new Float32Array([0, 0, 1, 0, 0.2, 0.8]).buffer),
    Buffer.from(new Uint16Array([5, 0]).buffer),
    Buffer.from(new Float32Array([0.3, 0, -0.2]).buffer),
  ];
  let byteOffset = 0;
  const bufferViews = chunks.map(({ byteLength }) => {
    const view = { buffer: 0, byteOffset, byteLength };
    byteOffset += byteLength;
    return view;
  });
  const sparse = (count: number, indexView: number) => ({
    count,
    indices: { bufferView: indexView, componentType: 5123 },
    values: { bufferView: indexView + 1 },
  });
  const vectors = { componentType: 5126, count: 6, type: 'VEC3' };
  const accessors = [
    { ...vectors, bufferView: 0, min: [0, 0, 0], max: [2, 1, 0] },
    { ...vectors, bufferView: 1 },
    { componentType: 5123, count: 12, type: 'SCALAR', bufferView: 2 },
    { ...vectors, sparse: sparse(2, 3), min: [0, 0, 0], max: [0, 0.2, 1] },
    { ...vectors, sparse: sparse(1, 5) },
    { ...vectors, sparse: sparse(1, 5), min: [0, 0, -0.2], max: [0.3, 0, 0] },
  ];
  const primitive = {
    attributes: { POSITION: 0, NORMAL: 1 },
    indices: 2,
    targets: [
      { POSITION: 3, NORMAL: 4 },
      { POSITION: 5, NORMAL: 4 },
    ],
  };
  return JSON.stringify({
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [primitive], weights: [0.5, 0.25] }],
    buffers: [{ byteLength: byteOffset, uri: dataUri(Buffer.concat(chunks)) }],
    bufferViews,
    accessors,
  });
}
