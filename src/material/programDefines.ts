import type { Texture } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName, type PropertyNameOf } from '../look/hatchingProperties.js';
import { isMirror } from '../look/mirrors.js';
import { familyOf } from '../look/presetParameters.js';
import { drawnValue, type HatchingLook, hasOwner, needsAdjacency } from '../look/queries.js';
import { VERTEX_LAYOUTS, type VertexLayout } from './deformation/canDeform.js';
import { fadesAround } from './fading/fading.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { CHANNEL_VARYINGS, channelDefine, SHADOWS_ALONE, TONE_CURVES } from './shaders/defineNames.js';

const propertyNames = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];

/**
 * The facts, beside the properties of its material, that decide a program. These are all the states that a program can be in:
 *
 * | fact | while meshes are announced | after the first frame |
 * | --- | --- | --- |
 * | `hasEnvironment` | whether one of them is in an environment that has loaded | that of the scene drawn last |
 * | `vertexLayout` | that of the mesh announced last | that of the mesh drawn last |
 * | `hasForm` | that of the mesh announced last | that of the mesh drawn last |
 */
export interface ProgramFacts {
  hasEnvironment: boolean;
  /** The layout in which the mesh stores its adjacency. */
  vertexLayout: VertexLayout;
  /** Whether the mesh has the attributes that lines and strokes along the form are drawn from. */
  hasForm: boolean;
}

/** The shader's name for the kind of a curve. */
const curveKind = (curve: ToneCurve): (typeof TONE_CURVES)[number] =>
  curve === 'linear' || curve === 'perceptual' ? curve : 'points';

/**
 * The defines of a material's program, derived from its properties; undefined ones are not defined. A choice that the technique does
 * not use is at its default, so that it compiles no other program.
 */
export function programDefines(
  material: HatchingMaterialProperties,
  { hasEnvironment, vertexLayout, hasForm }: ProgramFacts,
): Record<string, number | string | undefined> {
  const { technique, toneCurve, screenSpaceShare } = material;
  const defines: Record<string, number | string | undefined> = {};
  let usesFirstChannel = false;
  for (const name of propertyNames) {
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    if (property.kind === 'texture') {
      const texture = material[name as PropertyNameOf<undefined>] as Texture | null;
      defines[channelDefine(property)] = texture ? CHANNEL_VARYINGS[texture.channel] : undefined;
      usesFirstChannel ||= texture?.channel === 0;
    }
    if (!('define' in property) || !hasOwner(material, property)) continue;
    const value = drawnValue(material, name, hasForm);
    if (property.kind === 'choice') defines[property.define] = property.choices.indexOf(value as string);
    else defines[property.define] = value ? '' : undefined;
  }
  if ((material as HatchingLook).isHatchingShadowMaterial) defines.TONE_MODEL = SHADOWS_ALONE;
  defines.ENVIRONMENT = hasEnvironment ? '' : undefined;
  defines.VERTEX_LAYOUT = VERTEX_LAYOUTS.indexOf(needsAdjacency(material) ? vertexLayout : 'corner');
  defines.TONE_CURVE = TONE_CURVES.indexOf(curveKind(toneCurve));
  // three.js itself defines USE_UV1 to USE_UV3.
  defines.USE_UV0 = usesFirstChannel ? '' : undefined;
  // Strokes that are sized on the object alone need one lattice and no code for a second.
  defines.SCREEN_SPACE_SHARE = familyOf(technique) === 'strokes' && screenSpaceShare > 0 ? '' : undefined;
  defines.FADES_AROUND = fadesAround(material) ? '' : undefined;
  return defines;
}

/**
 * Updates the defines of a material.
 *
 * @param wanted defines by name; undefined ones are removed
 * @returns whether any has changed
 */
export function writeDefines(
  defines: Record<string, unknown>,
  wanted: Readonly<Record<string, number | string | undefined>>,
): boolean {
  let hasChanged = false;
  for (const [define, value] of Object.entries(wanted)) {
    if (defines[define] === value) continue;
    hasChanged = true;
    if (value === undefined) delete defines[define];
    else defines[define] = value;
  }
  return hasChanged;
}

/**
 * The properties that three.js reads for a program only after `needsUpdate` is set, packed into one number: the textures and their
 * channels, whether strokes are sized on the screen, metal mirrors and ink fades around a focus or towards the rim, sides, vertex colours
 * and the like. If the number changes, the program must be rebuilt. Allocates nothing.
 */
export function programSwitches(material: HatchingMaterialProperties & { normalMapType: number }): number {
  let switches: number = material.normalMapType;
  for (const name in HATCHING_PROPERTIES) {
    if (HATCHING_PROPERTIES[name as HatchingPropertyName].kind !== 'texture') continue;
    switches = switches * 16 + textureSwitches(material[name as PropertyNameOf<undefined>] as Texture | null);
  }
  switches = 32 * switches + 8 * material.side + material.blending;
  for (let i = 0; i < FLAGS.length; i++) switches = 2 * switches + Number(material[FLAGS[i]]);
  switches = 4 * switches + 2 * Number(isMirror(material)) + Number(material.screenSpaceShare > 0);
  return 2 * switches + Number(fadesAround(material));
}

/** Properties of three's `Material` that decide the program. */
const FLAGS = [
  ...(['transparent', 'alphaHash', 'alphaToCoverage', 'dithering', 'premultipliedAlpha', 'vertexColors'] as const),
] as const;

/** The switches of one texture, in [0, 16). */
function textureSwitches(texture: Texture | null): number {
  if (texture === null) return 0;
  return 1 + 2 * texture.channel + 8 * Number('isVideoTexture' in texture);
}
