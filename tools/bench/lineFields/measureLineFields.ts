import { Mesh } from 'three';
import { HatchingMaterial, type HatchingMaterialParameters, prepareHatchingGeometry } from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';

export interface LineFieldTimes {
  triangles: number;
  /** Milliseconds, one per turn, of everything that was drawn. */
  times: Record<string, number[]>;
  /** For each drawing, the name of the drawing that it is compared with. */
  against: Record<string, string>;
}

/** The ways in which lines are drawn: on the object, as dense on the screen as asked, and crossed in the darks. */
const WAYS: Readonly<Record<string, HatchingMaterialParameters>> = {
  'on the object': {},
  'on the screen': { screenSpaceShare: 1 },
  crossed: { screenSpaceShare: 1, shadowStrokes: 'cross' },
};

export async function measureLineFields(model: string, turns: number, size: number): Promise<LineFieldTimes> {
  const plain = await loadModel(model);
  const light = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const form = await prepareHatchingGeometry(plain, { layout: 'indexed', form: true });
  const objects: Record<string, Mesh> = {};
  const against: Record<string, string> = {};
  for (const [way, parameters] of Object.entries(WAYS)) {
    for (const direction of ['light', 'x', 'form', 'acrossForm'] as const) {
      const look = plainLook({ technique: 'engraving', ...parameters, direction });
      const geometry = direction === 'light' || direction === 'x' ? light : form;
      const name = `${direction}, ${way}`;
      objects[name] = new Mesh(geometry, new HatchingMaterial(look));
      against[name] = `light, ${way}`;
    }
  }
  const times = await timeTurns(new Stage(size), objects, turns);
  return { triangles: plain.index!.count / 3, times, against };
}
