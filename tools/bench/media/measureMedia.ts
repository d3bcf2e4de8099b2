import { Mesh } from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';

/** Times in milliseconds, one per turn, of every medium. */
export interface MediumTimes {
  triangles: number;
  times: Record<string, number[]>;
}

export async function measureMedia(model: string, turns: number, size: number): Promise<MediumTimes> {
  const plain = await loadModel(model);
  const geometry = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const sized = (parameters: HatchingMaterialParameters): Mesh =>
    new Mesh(geometry, new HatchingMaterial(plainLook({ screenSpaceShare: 1, ...parameters })));
  const meshes = {
    hatching: sized({ technique: 'hatching', tonalArtMap }),
    dryMedia: sized({ technique: 'dryMedia', tonalArtMap }),
    stipple: sized({ technique: 'stipple', strokeWidth: 3.2 }),
    engraving: sized({ technique: 'engraving' }),
    woodcut: sized({ technique: 'woodcut', crossFrom: 1 }),
  };

  const stage = new Stage(size);
  const times = await timeTurns(stage, meshes, turns);
  return { triangles: plain.index!.count / 3, times };
}
