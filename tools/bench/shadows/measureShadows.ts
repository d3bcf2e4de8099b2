import { Group, Mesh, type Object3D, PlaneGeometry } from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  HatchingShadowMaterial,
  type HatchingShadowMaterialParameters,
  type HatchingTechnique,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { plainLook, plainShadow } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';

const TECHNIQUES: readonly HatchingTechnique[] = ['adjacency', 'hatching', 'engraving'];

/** A shadow on a ground as `'hatching'` and `'engraving'` have it, in edges and tone. */
const SOFT = { shadowTone: 0.5, shadowFade: 0.65, shadowSoftness: 0.12 } as const;

export interface ShadowTimes {
  triangles: number;
  /** Milliseconds, one per turn, of everything that was drawn. */
  times: Record<string, number[]>;
  /** For each drawing, the name of the drawing that it is compared with. */
  against: Record<string, string>;
}

export async function measureShadows(model: string, turns: number, size: number): Promise<ShadowTimes> {
  const plain = await loadModel(model);
  const corner = await prepareHatchingGeometry(plain, { layout: 'corner' });
  const indexed = await prepareHatchingGeometry(plain, { layout: 'indexed' });
  const tonalArtMap = await TonalArtMap.generate();
  const hatched = (technique: HatchingTechnique, parameters: HatchingMaterialParameters): Mesh => {
    const geometry = technique === 'adjacency' ? corner : indexed;
    const mesh = new Mesh(geometry, new HatchingMaterial(plainLook({ tonalArtMap, technique, ...parameters })));
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    return mesh;
  };
  const objects: Record<string, Object3D> = {};
  const against: Record<string, string> = {};
  for (const technique of TECHNIQUES) {
    for (const shadowStrokes of ['tone', 'cross', 'reorient'] as const) {
      const name = `${technique} ${shadowStrokes}`;
      objects[name] = hatched(technique, { shadowStrokes });
      against[name] = `${technique} tone`;
    }
    const plane = await prepareHatchingGeometry(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2), { layout: 'corner' });
    const grounded = (parameters: HatchingShadowMaterialParameters): Group => {
      const look = plainShadow({ tonalArtMap, technique, ...parameters });
      const ground = new Mesh(plane, new HatchingShadowMaterial(look));
      ground.position.y = -0.7;
      ground.receiveShadow = true;
      return new Group().add(hatched(technique, {}), ground);
    };
    const [hard, soft] = [`${technique} tone, ground`, `${technique} tone, soft ground`];
    objects[hard] = grounded({});
    against[hard] = `${technique} tone`;
    objects[soft] = grounded(SOFT);
    against[soft] = hard;
  }

  const stage = new Stage(size, true);
  const times = await timeTurns(stage, objects, turns);
  return { triangles: plain.index!.count / 3, times, against };
}
