// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.
import type { Vector2, Vector3 } from 'three';
import type { LevelRule, ShadowDirection } from '../../look/hatchingProperties.js';
import type { Vector2Like, Vector3Like } from '../propertyValues.js';

/** The parameters of a `HatchingComposition`. */
export interface HatchingCompositionOptions {
  /**
   * What the light is multiplied by before it becomes tone. `'fit'` fits it to the lights and surfaces of the scene in
   * the first frame, so that lights, half tones and darks are those of a sphere in a single light of intensity π, and
   * keeps it until `refit()`: a part that is hidden, added or coloured changes no other part. `'auto'` fits it again
   * whenever lights or surfaces change. For a material with a `toneCurve` of points that no preset has, both are 1.
   * Factor in (0, ∞), or `'fit'` or `'auto'`. Default `1`.
   */
  exposure: number | 'fit' | 'auto';
  /**
   * What the fitted exposure is multiplied by: above 1 for a lighter picture, below for a darker one. Factor in (0, ∞).
   * Default `1`. Only with `exposure` `'fit'` or `'auto'`.
   */
  exposureCompensation: number;
  /**
   * How far the colours that `colorHatching` draws get their darkness from a plan of values of the scene, made with the
   * fitted exposure: by rank, the lighter half of what is seen stays blank, and only the darkest is dark, so that light
   * and shade are still read; details of maps that are finer than four spacings of lines are left out. At 0 each colour
   * is as dark as it is measured. Share in [0, 1]. Default `1`. Only with `exposure` `'fit'` or `'auto'`.
   */
  plannedValues: number;
  /**
   * How much lines, strokes, outlines and colours fade towards the paper with their distance, as in air: those behind
   * are thinner and lighter, and outlines in front heavier than without. At 1 nothing is left at `depthFadeEnd`.
   * `'auto'`: 0.7 in scenes that `applyHatching` hatched, where what is seen is more than three times as deep as the
   * sheet's shorter side at its middle, such as streets and interiors; 0 elsewhere. Share in [0, 1]. Default `'auto'`.
   * For all but `'triangle'`, `'adjacency'`.
   */
  depthFade: number | 'auto';
  /**
   * Where fading begins: 0 is the nearest place of the scene that is seen, 1 the farthest. Depths of the scene. Default
   * `0`. For all but `'triangle'`, `'adjacency'`, with `depthFade` other than `0`.
   */
  depthFadeStart: number;
  /**
   * Where fading ends, in the same units. Depths of the scene. Default `1`. For all but `'triangle'`, `'adjacency'`,
   * with `depthFade` other than `0`.
   */
  depthFadeEnd: number;
  /**
   * Point of the scene around which all is drawn. Beyond `focusRadius` tone, lines and outlines fall off, with an
   * uneven edge, until only paper is left. `null`: all is drawn everywhere. Units of the world. Default `null`. For all
   * but `'triangle'`, `'adjacency'`.
   */
  focus: Vector3Like | null;
  /**
   * How far around `focus` all is drawn. At two and a half times this distance nothing is left. Units of the world in
   * (0, ∞). Default `1`. For all but `'triangle'`, `'adjacency'`, with `focus` other than `null`.
   */
  focusRadius: number;
  /**
   * How much the drawing falls off towards the rim of the sheet, in an oval: at 1 nothing is left at the middle of each
   * side. Share in [0, 1]. Default `0`. For all but `'triangle'`, `'adjacency'`.
   */
  vignette: number;
}

/** The properties of `HatchingComposition`. */
export interface HatchingCompositionProperties {
  /**
   * What the light is multiplied by before it becomes tone. `'fit'` fits it to the lights and surfaces of the scene in
   * the first frame, so that lights, half tones and darks are those of a sphere in a single light of intensity π, and
   * keeps it until `refit()`: a part that is hidden, added or coloured changes no other part. `'auto'` fits it again
   * whenever lights or surfaces change. For a material with a `toneCurve` of points that no preset has, both are 1.
   * Factor in (0, ∞), or `'fit'` or `'auto'`. Default `1`.
   */
  exposure: number | 'fit' | 'auto';
  /**
   * What the fitted exposure is multiplied by: above 1 for a lighter picture, below for a darker one. Factor in (0, ∞).
   * Default `1`. Only with `exposure` `'fit'` or `'auto'`.
   */
  exposureCompensation: number;
  /**
   * How far the colours that `colorHatching` draws get their darkness from a plan of values of the scene, made with the
   * fitted exposure: by rank, the lighter half of what is seen stays blank, and only the darkest is dark, so that light
   * and shade are still read; details of maps that are finer than four spacings of lines are left out. At 0 each colour
   * is as dark as it is measured. Share in [0, 1]. Default `1`. Only with `exposure` `'fit'` or `'auto'`.
   */
  plannedValues: number;
  /**
   * How much lines, strokes, outlines and colours fade towards the paper with their distance, as in air: those behind
   * are thinner and lighter, and outlines in front heavier than without. At 1 nothing is left at `depthFadeEnd`.
   * `'auto'`: 0.7 in scenes that `applyHatching` hatched, where what is seen is more than three times as deep as the
   * sheet's shorter side at its middle, such as streets and interiors; 0 elsewhere. Share in [0, 1]. Default `'auto'`.
   * For all but `'triangle'`, `'adjacency'`.
   */
  depthFade: number | 'auto';
  /**
   * Where fading begins: 0 is the nearest place of the scene that is seen, 1 the farthest. Depths of the scene. Default
   * `0`. For all but `'triangle'`, `'adjacency'`, with `depthFade` other than `0`.
   */
  depthFadeStart: number;
  /**
   * Where fading ends, in the same units. Depths of the scene. Default `1`. For all but `'triangle'`, `'adjacency'`,
   * with `depthFade` other than `0`.
   */
  depthFadeEnd: number;
  /**
   * Point of the scene around which all is drawn. Beyond `focusRadius` tone, lines and outlines fall off, with an
   * uneven edge, until only paper is left. `null`: all is drawn everywhere. Units of the world. Default `null`. For all
   * but `'triangle'`, `'adjacency'`.
   */
  get focus(): Vector3 | null;
  set focus(value: Vector3Like | null);
  /**
   * How far around `focus` all is drawn. At two and a half times this distance nothing is left. Units of the world in
   * (0, ∞). Default `1`. For all but `'triangle'`, `'adjacency'`, with `focus` other than `null`.
   */
  focusRadius: number;
  /**
   * How much the drawing falls off towards the rim of the sheet, in an oval: at 1 nothing is left at the middle of each
   * side. Share in [0, 1]. Default `0`. For all but `'triangle'`, `'adjacency'`.
   */
  vignette: number;
}

/** The parameters of `HatchingMaterial.perTriangle`. */
export interface PerTriangleOptions {
  /** Shift of the strokes along T and B. Tiles. Default `(0, 0)`. Only `'triangle'`, `'adjacency'`. */
  strokeOffset: Vector2Like;
  /**
   * Blends thresholds of ink instead of the greys of strokes, so that strokes stay black and white. `false` is the way
   * of the paper by Suarez et al. Default `false`. Only `'triangle'`, `'adjacency'`. Another value builds another
   * program.
   */
  sharpInk: boolean;
  /**
   * What chooses the level of the map. `hatching` and `dryMedia` always go by depth. Default `'derivatives'`. Only
   * `'triangle'`, `'adjacency'`. Another value builds another program.
   */
  levelRule: LevelRule;
  /**
   * The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing
   * blends. The default is the rule of the paper by Suarez et al. Radians in [0, π]. Default `Math.PI / 2`. Only
   * `'adjacency'`.
   */
  blendAngle: number;
}

/** The properties of `HatchingMaterial.perTriangle`. */
export interface PerTriangleProperties {
  /** Shift of the strokes along T and B. Tiles. Default `(0, 0)`. Only `'triangle'`, `'adjacency'`. */
  readonly strokeOffset: Vector2;
  /**
   * Blends thresholds of ink instead of the greys of strokes, so that strokes stay black and white. `false` is the way
   * of the paper by Suarez et al. Default `false`. Only `'triangle'`, `'adjacency'`. Another value builds another
   * program.
   */
  sharpInk: boolean;
  /**
   * What chooses the level of the map. `hatching` and `dryMedia` always go by depth. Default `'derivatives'`. Only
   * `'triangle'`, `'adjacency'`. Another value builds another program.
   */
  levelRule: LevelRule;
  /**
   * The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing
   * blends. The default is the rule of the paper by Suarez et al. Radians in [0, π]. Default `Math.PI / 2`. Only
   * `'adjacency'`.
   */
  blendAngle: number;
}

/** The parameters that a `HatchingShadowMaterial` has beside those of a `HatchingMaterial`. */
export interface HatchingShadowOptions {
  /**
   * How dark a full shadow is printed where it touches what casts it, as a factor on the tone after the tone curve. At
   * one half a shadow on the ground is lighter than the darks of the body. Tone in [0, 1]. Default `1`, for all but
   * `'triangle'`, `'adjacency'` `0.5`.
   */
  shadowTone: number;
  /**
   * How fast a shadow dissolves with the distance, along the light, from what casts it: the share of its tone that it
   * loses over the width that the light's shadow camera sees. 0: it does not dissolve; 1: nothing is left at a distance
   * of one width; 2: at half of one. Factor in [0, ∞). Default `0`, for all but `'triangle'`, `'adjacency'` `0.65`.
   */
  shadowFade: number;
  /**
   * How wide the edges of shadows are, as a share of the distance to what casts them: the width of a round lamp as a
   * share of its own distance. At 0 all edges are as wide as the light's `shadow.radius` says. Factor in [0, ∞).
   * Default `0`, for all but `'triangle'`, `'adjacency'` `0.12`.
   */
  shadowSoftness: number;
  /**
   * Which way the strokes of shadows on a ground run. `'auto'` leaves it to the technique again. Default `'strokes'`,
   * for all but `'triangle'`, `'adjacency'` `'away'`. Another value builds another program.
   */
  shadowDirection: ShadowDirection | 'auto';
  /**
   * How many times as far apart as `lineSpacing` the lines of shadows are, so that a shadow on the ground is calmer
   * than the body. Factor in (0, ∞). Default `1.4`. Only `'engraving'`, `'pen'`, `'woodcut'`.
   */
  shadowSpacing: number;
}

/** The properties that `HatchingShadowMaterial` has beside those of `HatchingMaterial`. */
export interface HatchingShadowProperties {
  /**
   * How dark a full shadow is printed where it touches what casts it, as a factor on the tone after the tone curve. At
   * one half a shadow on the ground is lighter than the darks of the body. Tone in [0, 1]. Default `1`, for all but
   * `'triangle'`, `'adjacency'` `0.5`.
   */
  shadowTone: number;
  /**
   * How fast a shadow dissolves with the distance, along the light, from what casts it: the share of its tone that it
   * loses over the width that the light's shadow camera sees. 0: it does not dissolve; 1: nothing is left at a distance
   * of one width; 2: at half of one. Factor in [0, ∞). Default `0`, for all but `'triangle'`, `'adjacency'` `0.65`.
   */
  shadowFade: number;
  /**
   * How wide the edges of shadows are, as a share of the distance to what casts them: the width of a round lamp as a
   * share of its own distance. At 0 all edges are as wide as the light's `shadow.radius` says. Factor in [0, ∞).
   * Default `0`, for all but `'triangle'`, `'adjacency'` `0.12`.
   */
  shadowSoftness: number;
  /**
   * Which way the strokes of shadows on a ground run. `'auto'` leaves it to the technique again. Default `'strokes'`,
   * for all but `'triangle'`, `'adjacency'` `'away'`. Another value builds another program.
   */
  get shadowDirection(): ShadowDirection;
  set shadowDirection(value: ShadowDirection | 'auto');
  /**
   * How many times as far apart as `lineSpacing` the lines of shadows are, so that a shadow on the ground is calmer
   * than the body. Factor in (0, ∞). Default `1.4`. Only `'engraving'`, `'pen'`, `'woodcut'`.
   */
  shadowSpacing: number;
}
