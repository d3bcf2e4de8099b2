import { Mesh } from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';

const WARM_UP_TURNS = 2;

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
    new Mesh(geometry, new HatchingMaterial({ screenConstancy: 1, ...parameters }));
  const meshes = {
    ink: sized({ technique: 'anchored', tonalArtMap }),
    dry: sized({ technique: 'anchored', tonalArtMap, medium: 'dry' }),
    stipple: sized({ technique: 'anchored', medium: 'stipple', strokeWidth: 3.2 }),
    engraved: sized({ technique: 'engraved' }),
    carved: sized({ technique: 'engraved', carved: true, crossFrom: 1 }),
  };

  const stage = new Stage(size);
  const order = Object.keys(meshes) as (keyof typeof meshes)[];
  const times = Object.fromEntries(order.map((name) => [name, [] as number[]]));
  for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
    // Every other turn backwards: what is drawn before may make a difference.
    for (const name of turn % 2 === 0 ? order : order.toReversed()) {
      const time = await stage.timeFrame(meshes[name]);
      if (turn >= 0) times[name].push(time);
    }
  }
  return { triangles: plain.index!.count / 3, times };
}
