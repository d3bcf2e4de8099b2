import { DEFAULT_CREASE_ANGLE } from '../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import { bakePull } from '../../src/mesh/bake/bakePull.js';
import { addDirections } from '../../src/mesh/occlusion/addDirections.js';
import type { OcclusionScene } from '../../src/mesh/occlusion/OcclusionScene.js';
import { startOcclusion } from '../../src/mesh/occlusion/startOcclusion.js';
import { type ModelFile, readModel } from '../../src/viewer/files/readModel.js';

/** The default number of rays of `bakeOcclusion`, counted in pairs. */
const PAIRS = 192;
/** The value of a vertex that sees nothing of the sky, in the bake and in the file. */
const [BAKED_ONE, FILE_ONE] = [0x7fff, 0xff];
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/**
 * Reads a model as the page does and bakes its ambient occlusion.
 *
 * @returns what `writeOcclusion` of src/viewer/drawing writes to the geometry that is made of what was read
 */
export async function bakeModelOcclusion(file: ModelFile): Promise<Uint8Array> {
  const read = await readModel([file], () => {});
  if (read.kind !== 'mesh' || !read.mesh.indices) throw new Error(`${file.name} is not a mesh with an index.`);
  const { positions, indices } = read.mesh as {
    positions: Float32Array<ArrayBuffer>;
    indices: Uint32Array<ArrayBuffer>;
  };
  const mesh = { positions, indices };
  const baked = ended(
    bakePull({ label: file.name, mesh, creaseAngle: DEFAULT_CREASE_ANGLE, wantsNormals: true, attributes: [] }),
  );
  const scene: OcclusionScene = ended(
    startOcclusion({
      meshes: [
        {
          positions: baked.positions,
          indices: Uint32Array.from(indices.keys()),
          normals: baked.normals,
          toWorld: IDENTITY,
          isInsideOut: false,
          occludes: true,
        },
      ],
    }),
  );
  const pairs = Array.from({ length: PAIRS }, (_, pair) => pair);
  const [occlusion] = ended(addDirections({ scene, pairs })).occlusions;
  return packed(occlusion, indices, positions.length / 3);
}

/** Encodes occlusion as `writeOcclusion` reads it. @param occlusion of each corner */
function packed(occlusion: Int16Array, indices: Uint32Array, vertices: number): Uint8Array {
  const ofCorners = Array.from(occlusion, (one) => Math.round((FILE_ONE * one) / BAKED_ONE));
  const bytes = new Array<number>(vertices).fill(0);
  for (const [corner, vertex] of indices.entries()) bytes[vertex] = ofCorners[corner];
  for (const [corner, vertex] of indices.entries())
    if (ofCorners[corner] !== bytes[vertex])
      bytes.push(corner & 0xff, (corner >> 8) & 0xff, corner >> 16, ofCorners[corner]);
  return Uint8Array.from(bytes);
}

function ended<T>(work: Generator<number, T, void>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}
