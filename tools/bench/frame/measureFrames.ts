import { type BufferGeometry, Mesh, MeshPhongMaterial } from 'three';
import { HatchingMaterial, type HatchingTechnique, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';

/** Times in milliseconds, one per turn, of everything that can draw the model. */
export interface FrameTimes {
  triangles: number;
  times: Record<string, number[]>;
}

export async function measureFrames(model: string, turns: number, size: number): Promise<FrameTimes> {
  const plain = await loadModel(model);
  const corner = await prepareHatchingGeometry(plain, { layout: 'corner' });
  const pull = await prepareHatchingGeometry(plain, { layout: 'pull' });
  const indexed = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const hatched = (technique: HatchingTechnique, geometry: BufferGeometry): Mesh =>
    new Mesh(geometry, new HatchingMaterial(plainLook({ tonalArtMap, technique })));
  const meshes: Record<string, Mesh> = {
    'phong corner': new Mesh(corner, new MeshPhongMaterial()),
    'phong indexed': new Mesh(plain, new MeshPhongMaterial()),
    'triangle corner': hatched('triangle', corner),
    'triangle pull': hatched('triangle', pull),
    'adjacency corner': hatched('adjacency', corner),
    'adjacency pull': hatched('adjacency', pull),
    'hatching corner': hatched('hatching', corner),
    'hatching pull': hatched('hatching', pull),
    'hatching indexed': hatched('hatching', indexed),
    'engraving indexed': hatched('engraving', indexed),
  };

  const stage = new Stage(size);
  const times = await timeTurns(stage, meshes, turns);
  return { triangles: plain.index!.count / 3, times };
}
