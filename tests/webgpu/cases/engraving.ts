import { type Color, HemisphereLight, PCFShadowMap, SpotLight } from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { knot, shadowed } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const LINES = {
  technique: 'engraving',
  direction: 'light',
  shadowStrokes: 'tone',
  composition: { exposure: 1 },
} as const;

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters = {}) =>
  knot(await kit.hatching({ ...LINES, ...parameters }));

export const cases: readonly SceneCase[] = [
  { name: 'the direction of the light', show: (kit) => drawn(kit) },
  {
    name: 'a shadow',
    shadows: PCFShadowMap,
    show: async (kit) => shadowed(await drawn(kit)),
  },
  { name: 'the direction towardsLight', show: (kit) => drawn(kit, { direction: 'towardsLight' }) },
  { name: 'the direction x', show: (kit) => drawn(kit, { direction: 'x' }) },
  { name: 'the direction y', show: (kit) => drawn(kit, { direction: 'y' }) },
  { name: 'the direction z', show: (kit) => drawn(kit, { direction: 'z' }) },
  { name: 'the direction slant', show: (kit) => drawn(kit, { direction: 'slant' }) },
  {
    name: 'several lights',
    async show(kit): Promise<Stage> {
      const stage = await drawn(kit);
      const lamp = new SpotLight(0xffe0c0, 30, 0, 0.5, 0.4);
      lamp.position.set(-2, 1, 3);
      stage.scene.add(lamp, lamp.target, new HemisphereLight(0xffffff, 0x404040, 0.8));
      return stage;
    },
  },
  {
    name: 'values that are changed',
    async show(kit): Promise<Stage> {
      const stage = await drawn(kit);
      const material = stage.mesh.material as unknown as HatchingMaterialParameters & { ink: Color };
      return {
        ...stage,
        change() {
          material.ink.set(0x2040a0);
          Object.assign(material, { crossFrom: 0.3, irregularity: 0.8, lineSpacing: 9, toneModel: 'halfLambert' });
        },
      };
    },
  },
];
