import type { Texture } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, HATCHING_TECHNIQUES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import { needsAdjacency } from '../look/queries.js';
import { drawnValue } from '../look/resolveLook.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import {
  CHANNEL_VARYINGS,
  channelDefine,
  TONE_CURVES,
  VERTEX_LAYOUTS,
  type VertexLayout,
} from './shaders/shaderConventions.js';

const propertyNames = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];

/** The facts, beside the properties of its material, that decide a program: those of the scene and of the mesh that were drawn last. */
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
  const { technique, toneCurve, sizedOnScreen } = material;
  const defines: Record<string, number | string | undefined> = {};
  let usesFirstChannel = false;
  for (const name of propertyNames) {
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    if (property.kind === 'texture') {
      const texture = material[name] as Texture | null;
      defines[channelDefine(property)] = texture ? CHANNEL_VARYINGS[texture.channel] : undefined;
      usesFirstChannel ||= texture?.channel === 0;
    }
    if (!('define' in property) || property.define === undefined) continue;
    const value = drawnValue(material, name, hasForm);
    if (property.kind === 'choice') defines[property.define] = property.choices.indexOf(value as string);
    else defines[property.define] = value ? '' : undefined;
  }
  defines.ENVIRONMENT = hasEnvironment ? '' : undefined;
  defines.VERTEX_LAYOUT = VERTEX_LAYOUTS.indexOf(needsAdjacency(material) ? vertexLayout : 'corner');
  defines.TONE_CURVE = TONE_CURVES.indexOf(curveKind(toneCurve));
  // three.js itself defines USE_UV1 to USE_UV3.
  defines.USE_UV0 = usesFirstChannel ? '' : undefined;
  // Strokes that are sized on the object alone need one lattice and no code for a second.
  const { hasProgramForObject } = HATCHING_TECHNIQUES[technique];
  defines.SIZED_ON_SCREEN = hasProgramForObject && sizedOnScreen > 0 ? '' : undefined;
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
