import { BasicShadowMap, PCFShadowMap, VSMShadowMap } from 'three';
import { type HatchingMaterialParameters, prepareHatchingGeometry } from 'three-hatching';
import { type Casting, lamp, onGround, spot } from '../ground.js';
import type { KnotStage } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = { technique: 'engraving', composition: { exposure: 1 }, lineSpacing: 6 } as const;
const STROKES = { technique: 'hatching', composition: { exposure: 1 }, edgePixels: 0 } as const;

/** A knot on a ground, under the sun and another light, which casts a shadow of its own. */
async function underTwo(kit: Kit, parameters: HatchingMaterialParameters, light: Casting): Promise<KnotStage> {
  const stage = await onGround(kit, parameters);
  stage.sun.intensity = 1.2;
  stage.scene.add(light);
  return stage;
}

/** Effects of shadows on strokes. */
export const cases: readonly SceneCase[] = [
  {
    name: 'lines that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...LINES, shadowStrokes: 'cross' }),
  },
  {
    name: 'strokes of a pen that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) =>
      onGround(kit, { ...LINES, shadowStrokes: 'cross', technique: 'pen', colorHatching: 0.5, color: 0x888888 }),
  },
  {
    name: 'anchored strokes that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...STROKES, shadowStrokes: 'cross' }),
  },
  {
    name: 'lines that turn in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...LINES, shadowStrokes: 'reorient', direction: 'light' }),
  },
  {
    name: 'lines that turn in the shadows of two lights',
    shadows: PCFShadowMap,
    show: (kit) => underTwo(kit, { ...LINES, shadowStrokes: 'reorient', direction: 'light' }, lamp()),
  },
  {
    name: 'anchored strokes that turn in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...STROKES, shadowStrokes: 'reorient' }),
  },
  {
    name: 'anchored strokes that turn in the shadows of two lights',
    shadows: PCFShadowMap,
    show: (kit) => underTwo(kit, { ...STROKES, shadowStrokes: 'reorient' }, spot()),
  },
  {
    name: 'lines along the form that turn in a shadow',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = await onGround(kit, { ...LINES, shadowStrokes: 'reorient', direction: 'form' });
      stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
      return stage;
    },
  },
  {
    name: 'blended shadows',
    shadows: BasicShadowMap,
    show: (kit) => underTwo(kit, LINES, lamp()),
  },
  {
    name: 'soft maps of shadows',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = await underTwo(kit, LINES, lamp());
      stage.sun.shadow.radius = 3;
      stage.sun.shadow.intensity = 0.7;
      return stage;
    },
  },
  {
    name: 'shadows of variances',
    shadows: VSMShadowMap,
    show: (kit) => underTwo(kit, { ...LINES, shadowStrokes: 'cross' }, spot()),
  },
];
