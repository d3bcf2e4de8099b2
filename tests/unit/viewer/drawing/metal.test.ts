import type { Mesh } from 'three';
import { expect, test } from 'vitest';
import { mirroredShare } from '../../../../src/look/mirrors.js';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { addTrack, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';

/** A tetrahedron of metal, which swings if it is to be drawn in its parts. */
function metalFile(isMoving: boolean): Blob {
  const builder = tetrahedron();
  const { json } = builder;
  json.materials = [{ pbrMetallicRoughness: { metallicFactor: 1, roughnessFactor: 0.1 } }];
  json.meshes[0].primitives[0].material = 0;
  if (isMoving) {
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 0, 0, 1e-3), 'VEC3'));
  }
  return new Blob([builder.glb() as Uint8Array<ArrayBuffer>]);
}

test.each([false, true])(
  'metal of a glTF file mirrors, unless its colours are not drawn (moving: %s)',
  async (isMoving) => {
    const read = await readModel([{ name: 'metal.glb', content: metalFile(isMoving) }], () => {});
    const { model } = await buildModel(read, () => {}, new AbortController().signal);
    const [material] = meshesOf(model.root).flatMap(({ material }: Mesh) => [material].flat() as HatchingMaterial[]);
    const shareWith = (surfaceColors: 'shown' | 'paper'): number => {
      model.apply(lookOf({ ...defaultSettings(), surfaceColors }));
      return mirroredShare(material);
    };
    expect(shareWith('shown')).toBe(1);
    expect(shareWith('paper')).toBe(0);
    expect(shareWith('shown')).toBe(1);
    model.dispose();
  },
);
