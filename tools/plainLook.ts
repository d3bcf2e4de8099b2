import type { HatchingMaterialParameters, HatchingShadowMaterialParameters, TonalArtMap } from 'three-hatching';
import { drawsLines, needsAdjacency } from 'three-hatching/facts';

/** A plain look for every technique: the tone of the light, in one layer, tangent to the light. */
const PLAIN: HatchingMaterialParameters = {
  toneCurve: 'linear',
  reflectedLight: 0,
  hollowStrength: 0,
  crossFrom: 0.52,
};

/**
 * A look without the choices of a hand that the material has where nothing is set: what a test or a benchmark measures is then what
 * it names. Strokes lie on the object, a texel of their map to a pixel at most.
 *
 * @param look all that is not plain; the technique `adjacency`, unless it names another
 */
export function plainLook(look: HatchingMaterialParameters = {}): HatchingMaterialParameters {
  const { technique = 'adjacency', tonalArtMap = null } = look;
  const plain = { ...PLAIN, technique, tonalArtMap };
  if (drawsLines(technique)) return { ...plain, screenSpaceShare: 0, lineSpacing: 5, ...look };
  if (needsAdjacency({ technique })) return { ...plain, ...look };
  return {
    ...plain,
    screenSpaceShare: 0,
    ...(technique !== 'stipple' && { latticeSpacing: 0.45, strokeAngle: 0 }),
    strokeLayers: 'single',
    strokeWidth: (tonalArtMap as TonalArtMap | null)?.strokeTexels ?? 1,
    ...look,
  };
}

/** A plain look for a ground that shows shadows alone: full shadows, with hard edges, in strokes as those of any surface. */
export const plainShadow = (look: HatchingShadowMaterialParameters = {}): HatchingShadowMaterialParameters => ({
  ...{ shadowTone: 1, shadowFade: 0, shadowSoftness: 0, shadowDirection: 'strokes', shadowSpacing: 1 },
  ...plainLook(look),
});
