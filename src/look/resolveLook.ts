import { defaultOf } from './defaultOf.js';
import type {
  HatchingPropertyName,
  LineField,
  Medium,
  ShadowStrokes,
  StrokeField,
  StrokeLayers,
} from './hatchingProperties.js';
import {
  formFieldOf,
  formOf,
  type HatchingLook,
  isUsedBy,
  propertyOf,
  runsAway,
  techniqueOf,
  valueIn,
} from './queries.js';

/** The choices that are drawn on a mesh; one that does not count for the technique is at its default. */
export interface ResolvedLook {
  readonly medium: Medium;
  readonly lineField: Exclude<LineField, 'auto'>;
  readonly strokeField: StrokeField;
  readonly shadowStrokes: ShadowStrokes;
  readonly strokeLayers: StrokeLayers;
  /** Whether the look shows shadows alone, in one layer of strokes that run away from the light. */
  readonly runsAway: boolean;
}

/** The settings of strokes of shadows that run away from the light; they override the look of the model's strokes. */
const AWAY: Partial<Record<HatchingPropertyName, string>> = {
  lineField: 'light',
  shadowStrokes: 'tone',
  strokeField: 'light',
  strokeLayers: 'single',
};

/** The direction of lines that would follow the form, by their medium, on meshes that were prepared without it. */
const withoutForm = (medium: unknown): LineField =>
  medium === 'pen' ? 'slant' : medium === 'woodcut' ? 'towards' : 'light';

/**
 * The value of a property that a look is drawn with: its own where it counts for the technique, or else the technique's default. Lines and
 * strokes follow the form only on meshes that were prepared with it. Allocates nothing.
 *
 * @param look a material, or parameters of one without a preset
 * @param hasForm whether the mesh was prepared with `form`
 */
export function drawnValue(look: HatchingLook, name: HatchingPropertyName, hasForm: boolean): unknown {
  const technique = techniqueOf(look);
  const counts = isUsedBy(technique, propertyOf(name));
  const value = (runsAway(look) && AWAY[name]) || (counts ? valueIn(look, name) : defaultOf(name, technique));
  if (name !== formFieldOf(look)) return value;
  const form = formOf(look);
  if (form === 'auto') return hasForm ? 'form' : withoutForm(drawnValue(look, 'medium', hasForm));
  return form && !hasForm ? 'light' : value;
}

/**
 * How a look is drawn on a mesh.
 *
 * @param look a material, or parameters of one without a preset
 * @param hasForm whether the mesh was prepared with `form`
 */
export function resolveLook(look: HatchingLook, hasForm: boolean): ResolvedLook {
  const drawn = <Choice>(name: HatchingPropertyName): Choice => drawnValue(look, name, hasForm) as Choice;
  return {
    medium: drawn('medium'),
    lineField: drawn('lineField'),
    strokeField: drawn('strokeField'),
    shadowStrokes: drawn('shadowStrokes'),
    strokeLayers: drawn('strokeLayers'),
    runsAway: runsAway(look),
  };
}
