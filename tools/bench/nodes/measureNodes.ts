import { Mesh, MeshPhongMaterial } from 'three';
import { type HatchingMaterialParameters, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { HatchingNodeMaterial } from 'three-hatching/webgpu';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { timeTurns } from '../timeTurns.js';
import { type Backend, NodeStage } from './NodeStage.js';

/** Times in milliseconds, one per turn, of everything that can draw the model. */
export interface NodeTimes {
  triangles: number;
  times: Record<string, number[]>;
}

export async function measureNodes(model: string, backend: Backend, turns: number, size: number): Promise<NodeTimes> {
  const plain = await loadModel(model);
  const geometry = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const hatched = async (parameters: HatchingMaterialParameters): Promise<Mesh> => {
    const material = new HatchingNodeMaterial(parameters);
    await material.ready;
    return new Mesh(geometry, material);
  };
  const meshes = {
    phong: new Mesh(plain, new MeshPhongMaterial()),
    hatching: await hatched(plainLook({ tonalArtMap, technique: 'hatching' })),
    engraving: await hatched(plainLook({ technique: 'engraving' })),
    'preset pencil': await hatched({ preset: 'pencil' }),
    'preset engraving': await hatched({ preset: 'engraving' }),
  };
  const times = await timeTurns(await NodeStage.open(backend, size), meshes, turns);
  return { triangles: plain.index!.count / 3, times };
}
