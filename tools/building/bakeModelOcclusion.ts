import { DEFAULT_CREASE_ANGLE } from '../../src/material/geometry/PrepareHatchingGeometryOptions.js';
import { bakePull } from '../../src/mesh/bake/bakePull.js';
import { addDirections } from '../../src/mesh/occlusion/addDirections.js';
import type { OcclusionScene } from '../../src/mesh/occlusion/OcclusionScene.js';
import { BACK, FRONT } from '../../src/mesh/occlusion/OcclusionScene.js';
import { occlusionOf } from '../../src/mesh/occlusion/occlusionSides.js';
import { startOcclusion } from '../../src/mesh/occlusion/startOcclusion.js';
import { isOpen } from '../../src/viewer/drawing/statistics.js';
import { type ModelFile, readModel } from '../../src/viewer/files/readModel.js';

/** The default number of rays of `bakeOcclusion`, counted in pairs. */
const PAIRS = 192;
/** The values of a vertex that sees nothing of the sky, in the component of `hatchNormal` and in the file. */
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
  // As `bakeMesh` of src/viewer/drawing has it.
  const sides = isOpen(baked) ? 'both' : 'front';
  const scene: OcclusionScene = ended(
    startOcclusion({
      meshes: [
        {
          positions: baked.positions,
          indices: Uint32Array.from(indices.keys()),
          normals: baked.normals,
          toWorld: IDENTITY,
          sides,
          occluding: new Uint8Array(indices.length / 3).fill(sides === 'both' ? FRONT + BACK : FRONT),
        },
      ],
    }),
  );
  const pairs = Array.from({ length: PAIRS }, (_, pair) => pair);
  const [occlusion] = ended(addDirections({ scene, pairs })).occlusions;
  return packed(occlusion, sides === 'both' ? 2 : 1, indices, positions.length / 3);
}

/** Encodes occlusion as `writeOcclusion` reads it. @param occlusion the component of `hatchNormal` of each corner */
function packed(occlusion: Int16Array, sides: number, indices: Uint32Array, vertices: number): Uint8Array {
  const bytesOf = (corner: number): number[] =>
    [false, true]
      .slice(0, sides)
      .map((isBack) => Math.round(FILE_ONE * occlusionOf(occlusion[corner] / BAKED_ONE, isBack)));
  const ofVertices: number[][] = new Array(vertices).fill(new Array(sides).fill(0));
  for (const [corner, vertex] of indices.entries()) ofVertices[vertex] = bytesOf(corner);
  const bytes = [sides, ...ofVertices.flat()];
  for (const [corner, vertex] of indices.entries()) {
    const own = bytesOf(corner);
    if (own.some((byte, side) => byte !== ofVertices[vertex][side]))
      bytes.push(corner & 0xff, (corner >> 8) & 0xff, corner >> 16, ...own);
  }
  return Uint8Array.from(bytes);
}

function ended<T>(work: Generator<number, T, void>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}
