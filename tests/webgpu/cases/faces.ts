import { DoubleSide, HemisphereLight, IcosahedronGeometry, PCFShadowMap, PointLight, TorusKnotGeometry } from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { type KnotStage, knot, shadowed } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = { technique: 'engraving', direction: 'slant', composition: { exposure: 1 } } as const;

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters = {}): Promise<KnotStage> =>
  knot(await kit.hatching({ ...LINES, ...parameters }));

/** A knot of few faces, under a lamp and a sky too. */
async function ofFaces(kit: Kit, parameters: HatchingMaterialParameters): Promise<KnotStage> {
  const stage = await drawn(kit, { toneNormal: 'face', ...parameters });
  stage.mesh.geometry = new TorusKnotGeometry(0.62, 0.24, 40, 7);
  const lamp = new PointLight(0xffddbb, 1.5, 0, 0);
  lamp.position.set(-1.5, 1, 1.5);
  stage.scene.add(lamp, new HemisphereLight(0xffffff, 0x202020, 0.7));
  stage.sun.intensity = 1;
  return stage;
}

/** Tone that is taken from faces. */
export const cases: readonly SceneCase[] = [
  { name: 'the tone of faces', show: (kit) => ofFaces(kit, {}) },
  { name: 'the gloss of faces', show: (kit) => ofFaces(kit, { toneModel: 'phong', shininess: 8 }) },
  {
    name: 'the tone of faces, anchored, from both sides',
    async show(kit) {
      const stage = await ofFaces(kit, { technique: 'hatching', edgePixels: 0, side: DoubleSide });
      stage.mesh.geometry = new IcosahedronGeometry(0.95, 1);
      return stage;
    },
  },
  {
    name: 'lines on faces that turn in a shadow',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = shadowed(await drawn(kit, { toneNormal: 'face', direction: 'light', shadowStrokes: 'reorient' }));
      stage.mesh.geometry = new TorusKnotGeometry(0.62, 0.24, 40, 7);
      return stage;
    },
  },
];
