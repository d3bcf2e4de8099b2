import { MeshStandardMaterial } from 'three';
import type {
  ApplyHatchingOptions,
  HatchedScene,
  HatchingMaterialParameters,
  HatchingOutlineParameters,
  HatchingPropertyName,
} from 'three-hatching';
import {
  defaultOf,
  followsForm,
  formOf,
  HATCHING_DEFAULTS,
  HATCHING_OUTLINE_DEFAULTS,
  needsAdjacency,
} from 'three-hatching/facts';
import { namesOf, sameValue } from './sameValue.js';

type Values = Readonly<Record<string, unknown>>;

/** The outline options that take effect only when the geometry is prepared: those that decide which edges are creases. */
const BAKED_OUTLINE_OPTIONS: readonly string[] = ['featureAngle', 'creaseLength'];

/**
 * Sets new values of the materials and outlines of a hatched scene, if nothing else has changed in the options. The map is left to the
 * caller.
 *
 * @returns whether that was sufficient; if not, the scene is unchanged
 */
export function restyle(hatched: HatchedScene, from: ApplyHatchingOptions, to: ApplyHatchingOptions): boolean {
  const { material: fromMaterial = {}, outlines: fromLines = false, tonalArtMap: _fromMap, ...fromRest } = from;
  const { material: toMaterial = {}, outlines: toLines = false, tonalArtMap: _toMap, ...toRest } = to;
  if (!sameValue(fromRest, toRest) || typeof fromMaterial !== typeof toMaterial) return false;
  if (typeof fromLines === 'boolean' || typeof toLines === 'boolean') {
    if (fromLines !== toLines) return false;
  }
  const ofMaterial = typeof toMaterial === 'function' ? {} : materialChanges(fromMaterial, toMaterial);
  const ofLines = lineChanges(fromLines, toLines);
  if (!ofMaterial || !ofLines) return false;
  for (const material of hatched.materials) material.setValues({ ...ofMaterial });
  for (const material of new Set(hatched.outlines.map((outlines) => outlines.material)))
    material.setValues({ ...ofLines });
  return true;
}

function materialChanges(from: object, to: object): HatchingMaterialParameters | null {
  const { technique = HATCHING_DEFAULTS.technique } = to as HatchingMaterialParameters;
  const changes = changed(from as Values, to as Values, (name) =>
    name in HATCHING_DEFAULTS ? defaultOf(name as HatchingPropertyName, technique) : undefined,
  );
  if (!changes || 'tilesPerObjectUnit' in changes) return null;
  // Lines and strokes that follow the form need a geometry that was prepared with a form field.
  if (followsForm(to) && (formOf(from) !== formOf(to) || 'technique' in changes)) return null;
  if (!('technique' in changes)) return changes;
  // Techniques with adjacency need a geometry that was prepared with it.
  return [from, to].some(needsAdjacency) ? null : changes;
}

/** The options of outlines with all weights, since new weights are set over present ones. */
const withWeights = (outlines: boolean | { weights?: object | undefined }): Values => {
  const given = Object(outlines) as HatchingOutlineParameters;
  return { ...given, weights: { ...HATCHING_OUTLINE_DEFAULTS.weights, ...given.weights } };
};

function lineChanges(from: boolean | object, to: boolean | object): Values | null {
  const changes = changed(withWeights(from), withWeights(to), (name) => (HATCHING_OUTLINE_DEFAULTS as Values)[name]);
  return changes && Object.keys(changes).some((name) => BAKED_OUTLINE_OPTIONS.includes(name)) ? null : changes;
}

/**
 * The values to set for a change from `from` to `to`. A value that `to` no longer has gets its default. Returns `null` if that is
 * unknown, because the property was copied from the scene's own material.
 */
function changed(from: Values, to: Values, defaultFor: (name: string) => unknown): Values | null {
  const changes: Record<string, unknown> = {};
  for (const name of namesOf(from, to)) {
    if (sameValue(from[name], to[name])) continue;
    if (to[name] !== undefined) changes[name] = to[name];
    else {
      const fallback = name in takenOver() ? undefined : defaultFor(name);
      if (fallback === undefined) return null;
      changes[name] = fallback;
    }
  }
  return changes;
}

let standard: MeshStandardMaterial | undefined;

/** A material with every property that may be copied from the material of a scene. */
function takenOver(): MeshStandardMaterial {
  standard ??= new MeshStandardMaterial();
  return standard;
}
