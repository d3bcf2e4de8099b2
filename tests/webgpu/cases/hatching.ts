import { HemisphereLight, SpotLight } from 'three';
import { type HatchingMaterialParameters, prepareHatchingGeometry } from 'three-hatching';
import { knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const STROKES = {
  technique: 'hatching',
  strokeLayers: 'single',
  screenSpaceShare: 0,
  composition: { exposure: 1 },
} as const;

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters = {}) =>
  knot(await kit.hatching({ ...STROKES, ...parameters }));

/** Edges of strokes are as wide as screen-space derivatives, which WebGPU takes from other pixels: only mean tones are compared there. */
export const cases: readonly SceneCase[] = [
  { name: 'strokes on the object', onWebGPU: 'tone', show: (kit) => drawn(kit) },
  { name: 'strokes sized on the screen', onWebGPU: 'tone', show: (kit) => drawn(kit, { screenSpaceShare: 1 }) },
  { name: 'strokes sized half on the screen', onWebGPU: 'tone', show: (kit) => drawn(kit, { screenSpaceShare: 0.5 }) },
  { name: 'three layers', onWebGPU: 'tone', show: (kit) => drawn(kit, { strokeLayers: 'tone', crossFrom: 0.3 }) },
  {
    name: 'strokes on the sheet',
    onWebGPU: 'tone',

    show: (kit) => drawn(kit, { direction: 'sheet', strokeAngle: 0.3 }),
  },
  { name: 'hard edges', show: (kit) => drawn(kit, { edgePixels: 1e-6 }) },
  {
    name: 'strokes along the form, three layers',
    onWebGPU: 'tone',
    async show(kit) {
      const stage = await drawn(kit, { direction: 'form', strokeLayers: 'tone', screenSpaceShare: 1 });
      stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
      return stage;
    },
  },
  {
    name: 'strokes across the form',
    onWebGPU: 'tone',
    async show(kit) {
      const stage = await drawn(kit, { direction: 'acrossForm', screenSpaceShare: 1 });
      stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
      return stage;
    },
  },
  {
    name: 'layers by several lights',
    onWebGPU: 'tone',

    async show(kit): Promise<Stage> {
      const stage = await drawn(kit, { strokeLayers: 'lights' });
      const lamp = new SpotLight(0xffe0c0, 30, 0, 0.5, 0.4);
      lamp.position.set(-2, 1, 3);
      stage.scene.add(lamp, lamp.target, new HemisphereLight(0xffffff, 0x404040, 0.8));
      return stage;
    },
  },
];
