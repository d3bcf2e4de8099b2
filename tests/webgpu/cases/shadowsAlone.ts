import { BasicShadowMap, PCFShadowMap, VSMShadowMap } from 'three';
import type { HatchingShadowMaterialParameters } from 'three-hatching';
import { type Casting, lamp, onGround, spot } from '../ground.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const LINES = { technique: 'engraving', composition: { exposure: 1 }, lineSpacing: 6 } as const;
const STROKES = { technique: 'hatching', composition: { exposure: 1 }, edgePixels: 0 } as const;

/** A ground that shows only shadows. @param light replaces the sun */
async function alone(
  kit: Kit,
  parameters: HatchingShadowMaterialParameters,
  light: Casting | null = null,
): Promise<Stage> {
  const stage = await onGround(kit, LINES, await kit.shadows(parameters));
  if (light) stage.scene.remove(stage.sun).add(light);
  return stage;
}

/** Grounds that show only shadows. */
export const cases: readonly SceneCase[] = [
  { name: 'shadows alone', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES) },
  { name: 'shadows alone, anchored', shadows: PCFShadowMap, show: (kit) => alone(kit, STROKES) },
  {
    name: 'shadows alone, carved, as dark as black and as wide as their maps say',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, technique: 'woodcut', shadowTone: 1, shadowFade: 0, shadowSoftness: 0 }),
  },
  {
    name: 'shadows alone, of strokes that cross',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, shadowDirection: 'strokes', shadowStrokes: 'cross' }),
  },
  {
    name: 'shadows alone, that dissolve soon',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, shadowFade: 3 }),
  },
  {
    name: 'shadows alone, that dissolve soon, with a pen',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, technique: 'pen', shadowFade: 3 }),
  },
  { name: 'shadows alone, of a cone', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES, spot()) },
  { name: 'shadows alone, of a lamp', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES, lamp()) },
  { name: 'shadows alone, blended', shadows: BasicShadowMap, show: (kit) => alone(kit, LINES) },
  { name: 'shadows alone, of variances', shadows: VSMShadowMap, show: (kit) => alone(kit, LINES) },
];
