// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.
import { Color, type ColorRepresentation, ShaderMaterial, type Texture, Vector2 } from 'three';
import { checkNumber } from './checkNumber.js';
import { checkHatchingMap, type HatchingMap } from './checkTonalArtMap.js';
import { defaultOf } from './facts/defaultOf.js';
import {
  type DebugView,
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
  type InkBlend,
  type LevelRule,
  type LineField,
  type Medium,
  type ShadowStrokes,
  type StrokeAnchor,
  type StrokeLayers,
  type ToneModel,
  type ToneNormal,
} from './facts/hatchingProperties.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { Vector2Like } from './vectorValues.js';

/** What a HatchingMaterial can be told, beside everything three's own `Material` accepts. */
export interface HatchingMaterialOptions {
  /**
   * The hatch images: a map, which materials may share and which you dispose of yourself; or the name of a style, whose
   * map all materials share (`TonalArtMap.shared`), drawn with the first frame that needs it. Until a map is ready the
   * surface is blank paper, and with `null` it stays so. Default `'hatching'`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, with `medium` `'ink'` or `'dry'`.
   */
  tonalArtMap: HatchingMap;
  /** How strokes are laid on the surface. Default `'anchored'`. Another value builds another program. */
  technique: HatchingTechnique;
  /**
   * Size of the strokes: larger is finer. Tiles of the tonal art map per unit of object space in (0, ∞). Default `3`.
   * Only with `sizedOnScreen` other than `1`.
   */
  tilesPerUnit: number;
  /**
   * Direction of the strokes, clockwise about the normal, as seen from outside: 0 draws them tangent to the light, π/2
   * towards it (figure 14). For `engraved` it turns what cuts the lines, where a light does: at π/2 `lineField:
   * 'light'` is `'towards'`. Radians. Default `0`, for `'anchored'` `Math.PI / 2`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, `'engraved'`, with `medium` `'ink'` or `'dry'` or `'woodcut'`.
   */
  strokeRotation: number;
  /** Shift of the strokes along T and B. Tiles. Default `(0, 0)`. Only `'triangle'`, `'adjacency'`. */
  strokeOffset: Vector2Like;
  /** What the strokes of a mesh that deforms are fixed to. Default `'rest'`. Another value builds another program. */
  strokeAnchor: StrokeAnchor;
  /**
   * Blends the thresholds that ink is decided from instead of the greys of the strokes, so that strokes stay black and
   * white. Off is the way of the paper by Suarez et al. Default `false`. Only `'triangle'`, `'adjacency'`. Another
   * value builds another program.
   */
  crisp: boolean;
  /**
   * What the level of the map is chosen by. `anchored` always goes by depth. Default `'derivatives'`. Only
   * `'triangle'`, `'adjacency'`. Another value builds another program.
   */
  levelRule: LevelRule;
  /**
   * What strokes are sized on: 0 the object, by `tilesPerUnit`; 1 the screen, by `strokeWidth`, without popping. In
   * between, strokes grow less than the object does as it comes nearer. `anchored` has a program of its own for 0,
   * which is cheaper. Share in [0, 1]. Default `1`. Only `'anchored'`, `'engraved'`.
   */
  sizedOnScreen: number;
  /**
   * Width of a stroke on the screen, which is also where coarser levels of the map take over, unless blended greys
   * choose them by derivatives. `null` leaves it to the technique: for `triangle` and `adjacency` it is as wide as the
   * map draws strokes, `tonalArtMap.strokeTexels` pixels. CSS pixels in (0, ∞). Default `null`, for `'anchored'` `1.5`.
   * Only `'triangle'`, `'adjacency'`, `'anchored'`, with `crisp` `true`, or `levelRule` `'depth'`.
   */
  strokeWidth: number | null;
  /**
   * Width over which ink fades at the edge of a stroke, for `anchored` and `crisp`. 0 is hard. Dry media have
   * `softness` instead. Pixels of the drawing buffer in [0, ∞). Default `1`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, with `crisp` `true` and `medium` `'ink'` or `'stipple'`.
   */
  edgePixels: number;
  /**
   * Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter
   * strokes. Tiles in (0, ∞). Default `0.4`. Only `'anchored'`, with `medium` `'ink'` or `'dry'`.
   */
  anchorSpacing: number;
  /** What the lines are cut by. Default `'light'`. Only `'engraved'`. Another value builds another program. */
  lineField: LineField;
  /**
   * Distance between lines. Where that is less than `finestSpacing`, every other line is left out. As one comes nearer
   * new ones are born between them, thin at first. CSS pixels at a `sizedOnScreen` of 1, 256ths of a tile at 0 in (0,
   * ∞). Default `4.5`. Only `'engraved'`.
   */
  lineSpacing: number;
  /**
   * Least distance between lines, which is never less than two pixels of the drawing buffer. Where they would lie
   * closer every other one is left out; fewer than three pixels from one to the next flicker in motion. CSS pixels in
   * [2, ∞). Default `3`. Only `'engraved'`.
   */
  finestSpacing: number;
  /**
   * How many layers of strokes there are. Default `'single'`, for `'anchored'` `'tone'`. Only `'triangle'`,
   * `'adjacency'`, `'anchored'`. Another value builds another program.
   */
  strokeLayers: StrokeLayers | 'auto';
  /**
   * Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of `engraved`; at
   * 1 none do. Tone in [0, 1]. Default `0.52`, for `'anchored'` `0.6`. Only `'triangle'`, `'adjacency'`, `'anchored'`,
   * `'engraved'`, with `strokeLayers` `'tone'`.
   */
  crossFrom: number;
  /**
   * Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that
   * cut the first lines of `engraved` and those that cut the lines across them; lines that follow the form cross as
   * they were baked. 60° is a pen's, 90° an engraver's. Radians in (0, π/2]. Default `Math.PI / 3`. Only `'triangle'`,
   * `'adjacency'`, `'anchored'`, `'engraved'`, with `strokeLayers` `'tone'`.
   */
  crossAngle: number;
  /**
   * How unsteady the hand is: widths that differ, lines that stray, gaps in the lights. 0 is a ruling machine. Share in
   * [0, 1]. Default `0.4`. Only `'engraved'`.
   */
  handmade: number;
  /**
   * The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing
   * blends. The default is the rule of the paper by Suarez et al. Radians in [0, π]. Default `Math.PI / 2`. Only
   * `'adjacency'`.
   */
  blendAngle: number;
  /**
   * What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all. Default
   * `'tone'`. Another value builds another program.
   */
  shadowStrokes: ShadowStrokes;
  /**
   * What strokes are drawn with. The tone is the same with all. `'dry'` and `'stipple'` are for `anchored`, `'woodcut'`
   * is for `engraved`; a technique draws in ink with what is not for it. Default `'ink'`. Only `'anchored'`,
   * `'engraved'`. Another value builds another program.
   */
  medium: Medium;
  /**
   * How much the tooth of the paper counts against the stroke in where a dry medium lies: at 0 strokes are smooth, at 1
   * there is nothing but grain. Share in [0, 1]. Default `0.4`. Only `'anchored'`, with `medium` `'dry'`.
   */
  tooth: number;
  /** Size of the bumps of that tooth. CSS pixels in (0, ∞). Default `2.5`. Only `'anchored'`, with `medium` `'dry'`. */
  toothSize: number;
  /**
   * How gradually a dry medium covers: near 0 it covers or does not, as charcoal pressed hard; at 1 every tone is a
   * grey. Share in [0, 1]. Default `0.6`. Only `'anchored'`, with `medium` `'dry'`.
   */
  softness: number;
  /**
   * How much of a dry medium is rubbed into plain tone below the strokes. Share in [0, 1]. Default `0`. Only
   * `'anchored'`, with `medium` `'dry'`.
   */
  smudge: number;
  /** How light becomes tone. Default `'lambert'`. Another value builds another program. */
  toneModel: ToneModel;
  /** Number of bands of the tone model `'toon'`. Count in [2, ∞). Default `4`. Only with `toneModel` `'toon'`. */
  toneSteps: number;
  /**
   * Exponent of the highlight of the tone model `'phong'`. Exponent in [0, ∞). Default `30`. Only with `toneModel`
   * `'phong'`.
   */
  shininess: number;
  /**
   * The normal that tone is computed from. Reads as the one in use; `'auto'` leaves it to the technique again. Default
   * `'face'`, for `'anchored'` `'smooth'`, for `'engraved'` `'smooth'`. Another value builds another program.
   */
  toneNormal: ToneNormal | 'auto';
  /**
   * From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is
   * covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that
   * of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points
   * `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other
   * points need no other program. Default `'linear'`, for `'anchored'` `'printed'`, for `'engraved'` `'printed'`.
   */
  toneCurve: ToneCurve;
  /**
   * How much of each light the surroundings throw back: the side turned away is lit by so much from behind, so that
   * shade is darkest at the terminator, as engravers draw it. Share in [0, 1]. Default `0`, for `'anchored'` `0.35`,
   * for `'engraved'` `0.4`.
   */
  reflectedLight: number;
  /**
   * How much ambient occlusion counts that `bakeOcclusion` has baked: cavities, folds and contacts are darker under any
   * light. Without such a bake it does nothing. Share in [0, 1]. Default `1`.
   */
  occlusion: number;
  /**
   * Tone, after the tone curve, below which the paper stays blank: a highlight with an edge. Tone in [0, 1]. Default
   * `0`.
   */
  highlightTone: number;
  /**
   * How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightTone`. Share in [0, 1].
   * Default `0`. Only with `highlightTone` other than `0`.
   */
  highlightSoftness: number;
  /**
   * Normal map, as in three's own materials (`normalMapType` says of which space). Turns the smooth tone normal; face
   * normals stay those of the triangles. Default `null`. Only with `toneNormal` `'smooth'`.
   */
  normalMap: Texture | null;
  /**
   * How far the normal map turns the normal, along x and y. Factor. Default `(1, 1)`. Only with `toneNormal` `'smooth'`
   * and `normalMap` other than `null`.
   */
  normalScale: Vector2Like;
  /**
   * Heights that turn the smooth tone normal, where there is no normal map; face normals stay those of the triangles.
   * Default `null`. Only with `toneNormal` `'smooth'` and `normalMap` `null`.
   */
  bumpMap: Texture | null;
  /**
   * How far the bump map turns the normal. Factor. Default `1`. Only with `toneNormal` `'smooth'` and `normalMap`
   * `null` and `bumpMap` other than `null`.
   */
  bumpScale: number;
  /**
   * Makes the smooth tone normal that of the flat triangle, before a normal or bump map turns it. Default `false`. Only
   * with `toneNormal` `'smooth'`. Another value builds another program.
   */
  flatShading: boolean;
  /** Ambient occlusion (red channel): dims light without a direction, the environment and the light map. Default `null`. */
  aoMap: Texture | null;
  /** How much the ambient occlusion counts. Factor in [0, ∞). Default `1`. Only with `aoMap` other than `null`. */
  aoMapIntensity: number;
  /** Light baked into a map, added to that of the scene; coloured light counts by its luminance. Default `null`. */
  lightMap: Texture | null;
  /** How much the light map counts. Factor in [0, ∞). Default `1`. Only with `lightMap` other than `null`. */
  lightMapIntensity: number;
  /** Light that the surface gives off; its luminance lowers the tone. Default black. */
  emissive: ColorRepresentation;
  /** How strong that light is. Factor in [0, ∞). Default `1`. */
  emissiveIntensity: number;
  /** Map of that light, multiplied by `emissive`. Default `null`. */
  emissiveMap: Texture | null;
  /** Colour of the strokes. Default black. */
  ink: ColorRepresentation;
  /** Colour of the ground between strokes, multiplied by the surface colour. Default white. */
  paper: ColorRepresentation;
  /** Surface colour. Default white. */
  color: ColorRepresentation;
  /** What ink does to the colour below it. Default `'cover'`. Another value builds another program. */
  inkBlend: InkBlend;
  /**
   * Below 1 one sees through the paper; at 0 there are strokes and nothing else. Needs `transparent`, `alphaTest` or
   * `alphaHash`: a material that is drawn opaque keeps its paper. Share in [0, 1]. Default `1`.
   */
  paperOpacity: number;
  /** Surface colour map, multiplied by `color`. Default `null`. */
  map: Texture | null;
  /** Opacity map (green channel), as in three's own materials. Default `null`. */
  alphaMap: Texture | null;
  /**
   * Draws something else in the place of strokes, to see what goes into them. Default `'none'`. Another value builds
   * another program.
   */
  debugView: DebugView;
}

/** The properties of `HatchingMaterial` as fields. What setting a choice does is up to the material. */
export abstract class HatchingMaterialProperties extends ShaderMaterial {
  private hatchImages: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  private readonly numbers = {
    tilesPerUnit: HATCHING_DEFAULTS.tilesPerUnit as number,
    strokeRotation: undefined as number | undefined,
    sizedOnScreen: HATCHING_DEFAULTS.sizedOnScreen as number,
    strokeWidth: undefined as number | null | undefined,
    edgePixels: HATCHING_DEFAULTS.edgePixels as number,
    anchorSpacing: HATCHING_DEFAULTS.anchorSpacing as number,
    lineSpacing: HATCHING_DEFAULTS.lineSpacing as number,
    finestSpacing: HATCHING_DEFAULTS.finestSpacing as number,
    crossFrom: undefined as number | undefined,
    crossAngle: HATCHING_DEFAULTS.crossAngle as number,
    handmade: HATCHING_DEFAULTS.handmade as number,
    blendAngle: HATCHING_DEFAULTS.blendAngle as number,
    tooth: HATCHING_DEFAULTS.tooth as number,
    toothSize: HATCHING_DEFAULTS.toothSize as number,
    softness: HATCHING_DEFAULTS.softness as number,
    smudge: HATCHING_DEFAULTS.smudge as number,
    toneSteps: HATCHING_DEFAULTS.toneSteps as number,
    shininess: HATCHING_DEFAULTS.shininess as number,
    reflectedLight: undefined as number | undefined,
    occlusion: HATCHING_DEFAULTS.occlusion as number,
    highlightTone: HATCHING_DEFAULTS.highlightTone as number,
    highlightSoftness: HATCHING_DEFAULTS.highlightSoftness as number,
    bumpScale: HATCHING_DEFAULTS.bumpScale as number,
    aoMapIntensity: HATCHING_DEFAULTS.aoMapIntensity as number,
    lightMapIntensity: HATCHING_DEFAULTS.lightMapIntensity as number,
    emissiveIntensity: HATCHING_DEFAULTS.emissiveIntensity as number,
    paperOpacity: HATCHING_DEFAULTS.paperOpacity as number,
  };

  /**
   * The hatch images: a map, which materials may share and which you dispose of yourself; or the name of a style, whose
   * map all materials share (`TonalArtMap.shared`), drawn with the first frame that needs it. Until a map is ready the
   * surface is blank paper, and with `null` it stays so. Default `'hatching'`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, with `medium` `'ink'` or `'dry'`.
   */
  get tonalArtMap(): HatchingMap {
    return this.hatchImages;
  }

  set tonalArtMap(value: HatchingMap) {
    this.hatchImages = checkHatchingMap(value);
  }

  /** How strokes are laid on the surface. Default `'anchored'`. Another value builds another program. */
  get technique(): HatchingTechnique {
    return this.choice('technique') as HatchingTechnique;
  }

  set technique(value: HatchingTechnique) {
    this.choose('technique', value);
  }

  /**
   * Size of the strokes: larger is finer. Tiles of the tonal art map per unit of object space in (0, ∞). Default `3`.
   * Only with `sizedOnScreen` other than `1`.
   */
  get tilesPerUnit(): number {
    return this.numbers.tilesPerUnit;
  }

  set tilesPerUnit(value: number) {
    this.numbers.tilesPerUnit = checkNumber('tilesPerUnit', value, HATCHING_PROPERTIES.tilesPerUnit.range);
  }

  /**
   * Direction of the strokes, clockwise about the normal, as seen from outside: 0 draws them tangent to the light, π/2
   * towards it (figure 14). For `engraved` it turns what cuts the lines, where a light does: at π/2 `lineField:
   * 'light'` is `'towards'`. Radians. Default `0`, for `'anchored'` `Math.PI / 2`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, `'engraved'`, with `medium` `'ink'` or `'dry'` or `'woodcut'`.
   */
  get strokeRotation(): number {
    return this.numbers.strokeRotation ?? (defaultOf('strokeRotation', this.technique) as number);
  }

  set strokeRotation(value: number) {
    this.numbers.strokeRotation = checkNumber('strokeRotation', value);
  }

  /** Shift of the strokes along T and B. Tiles. Default `(0, 0)`. Only `'triangle'`, `'adjacency'`. */
  readonly strokeOffset: Vector2 = new Vector2(...HATCHING_DEFAULTS.strokeOffset);

  /** What the strokes of a mesh that deforms are fixed to. Default `'rest'`. Another value builds another program. */
  get strokeAnchor(): StrokeAnchor {
    return this.choice('strokeAnchor') as StrokeAnchor;
  }

  set strokeAnchor(value: StrokeAnchor) {
    this.choose('strokeAnchor', value);
  }

  /**
   * Blends the thresholds that ink is decided from instead of the greys of the strokes, so that strokes stay black and
   * white. Off is the way of the paper by Suarez et al. Default `false`. Only `'triangle'`, `'adjacency'`. Another
   * value builds another program.
   */
  get crisp(): boolean {
    return this.choice('crisp') as boolean;
  }

  set crisp(value: boolean) {
    this.choose('crisp', value);
  }

  /**
   * What the level of the map is chosen by. `anchored` always goes by depth. Default `'derivatives'`. Only
   * `'triangle'`, `'adjacency'`. Another value builds another program.
   */
  get levelRule(): LevelRule {
    return this.choice('levelRule') as LevelRule;
  }

  set levelRule(value: LevelRule) {
    this.choose('levelRule', value);
  }

  /**
   * What strokes are sized on: 0 the object, by `tilesPerUnit`; 1 the screen, by `strokeWidth`, without popping. In
   * between, strokes grow less than the object does as it comes nearer. `anchored` has a program of its own for 0,
   * which is cheaper. Share in [0, 1]. Default `1`. Only `'anchored'`, `'engraved'`.
   */
  get sizedOnScreen(): number {
    return this.numbers.sizedOnScreen;
  }

  set sizedOnScreen(value: number) {
    this.numbers.sizedOnScreen = checkNumber('sizedOnScreen', value, HATCHING_PROPERTIES.sizedOnScreen.range);
  }

  /**
   * Width of a stroke on the screen, which is also where coarser levels of the map take over, unless blended greys
   * choose them by derivatives. `null` leaves it to the technique: for `triangle` and `adjacency` it is as wide as the
   * map draws strokes, `tonalArtMap.strokeTexels` pixels. CSS pixels in (0, ∞). Default `null`, for `'anchored'` `1.5`.
   * Only `'triangle'`, `'adjacency'`, `'anchored'`, with `crisp` `true`, or `levelRule` `'depth'`.
   */
  get strokeWidth(): number | null {
    return this.numbers.strokeWidth ?? (defaultOf('strokeWidth', this.technique) as number | null);
  }

  set strokeWidth(value: number | null) {
    this.numbers.strokeWidth =
      value === null ? null : checkNumber('strokeWidth', value, HATCHING_PROPERTIES.strokeWidth.range);
  }

  /**
   * Width over which ink fades at the edge of a stroke, for `anchored` and `crisp`. 0 is hard. Dry media have
   * `softness` instead. Pixels of the drawing buffer in [0, ∞). Default `1`. Only `'triangle'`, `'adjacency'`,
   * `'anchored'`, with `crisp` `true` and `medium` `'ink'` or `'stipple'`.
   */
  get edgePixels(): number {
    return this.numbers.edgePixels;
  }

  set edgePixels(value: number) {
    this.numbers.edgePixels = checkNumber('edgePixels', value, HATCHING_PROPERTIES.edgePixels.range);
  }

  /**
   * Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter
   * strokes. Tiles in (0, ∞). Default `0.4`. Only `'anchored'`, with `medium` `'ink'` or `'dry'`.
   */
  get anchorSpacing(): number {
    return this.numbers.anchorSpacing;
  }

  set anchorSpacing(value: number) {
    this.numbers.anchorSpacing = checkNumber('anchorSpacing', value, HATCHING_PROPERTIES.anchorSpacing.range);
  }

  /** What the lines are cut by. Default `'light'`. Only `'engraved'`. Another value builds another program. */
  get lineField(): LineField {
    return this.choice('lineField') as LineField;
  }

  set lineField(value: LineField) {
    this.choose('lineField', value);
  }

  /**
   * Distance between lines. Where that is less than `finestSpacing`, every other line is left out. As one comes nearer
   * new ones are born between them, thin at first. CSS pixels at a `sizedOnScreen` of 1, 256ths of a tile at 0 in (0,
   * ∞). Default `4.5`. Only `'engraved'`.
   */
  get lineSpacing(): number {
    return this.numbers.lineSpacing;
  }

  set lineSpacing(value: number) {
    this.numbers.lineSpacing = checkNumber('lineSpacing', value, HATCHING_PROPERTIES.lineSpacing.range);
  }

  /**
   * Least distance between lines, which is never less than two pixels of the drawing buffer. Where they would lie
   * closer every other one is left out; fewer than three pixels from one to the next flicker in motion. CSS pixels in
   * [2, ∞). Default `3`. Only `'engraved'`.
   */
  get finestSpacing(): number {
    return this.numbers.finestSpacing;
  }

  set finestSpacing(value: number) {
    this.numbers.finestSpacing = checkNumber('finestSpacing', value, HATCHING_PROPERTIES.finestSpacing.range);
  }

  /**
   * How many layers of strokes there are. Default `'single'`, for `'anchored'` `'tone'`. Only `'triangle'`,
   * `'adjacency'`, `'anchored'`. Another value builds another program.
   */
  get strokeLayers(): StrokeLayers {
    return this.choice('strokeLayers') as StrokeLayers;
  }

  set strokeLayers(value: StrokeLayers | 'auto') {
    this.choose('strokeLayers', value);
  }

  /**
   * Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of `engraved`; at
   * 1 none do. Tone in [0, 1]. Default `0.52`, for `'anchored'` `0.6`. Only `'triangle'`, `'adjacency'`, `'anchored'`,
   * `'engraved'`, with `strokeLayers` `'tone'`.
   */
  get crossFrom(): number {
    return this.numbers.crossFrom ?? (defaultOf('crossFrom', this.technique) as number);
  }

  set crossFrom(value: number) {
    this.numbers.crossFrom = checkNumber('crossFrom', value, HATCHING_PROPERTIES.crossFrom.range);
  }

  /**
   * Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that
   * cut the first lines of `engraved` and those that cut the lines across them; lines that follow the form cross as
   * they were baked. 60° is a pen's, 90° an engraver's. Radians in (0, π/2]. Default `Math.PI / 3`. Only `'triangle'`,
   * `'adjacency'`, `'anchored'`, `'engraved'`, with `strokeLayers` `'tone'`.
   */
  get crossAngle(): number {
    return this.numbers.crossAngle;
  }

  set crossAngle(value: number) {
    this.numbers.crossAngle = checkNumber('crossAngle', value, HATCHING_PROPERTIES.crossAngle.range);
  }

  /**
   * How unsteady the hand is: widths that differ, lines that stray, gaps in the lights. 0 is a ruling machine. Share in
   * [0, 1]. Default `0.4`. Only `'engraved'`.
   */
  get handmade(): number {
    return this.numbers.handmade;
  }

  set handmade(value: number) {
    this.numbers.handmade = checkNumber('handmade', value, HATCHING_PROPERTIES.handmade.range);
  }

  /**
   * The angle between the normals of two triangles at which the blend of their strokes has faded out; at 0 nothing
   * blends. The default is the rule of the paper by Suarez et al. Radians in [0, π]. Default `Math.PI / 2`. Only
   * `'adjacency'`.
   */
  get blendAngle(): number {
    return this.numbers.blendAngle;
  }

  set blendAngle(value: number) {
    this.numbers.blendAngle = checkNumber('blendAngle', value, HATCHING_PROPERTIES.blendAngle.range);
  }

  /**
   * What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all. Default
   * `'tone'`. Another value builds another program.
   */
  get shadowStrokes(): ShadowStrokes {
    return this.choice('shadowStrokes') as ShadowStrokes;
  }

  set shadowStrokes(value: ShadowStrokes) {
    this.choose('shadowStrokes', value);
  }

  /**
   * What strokes are drawn with. The tone is the same with all. `'dry'` and `'stipple'` are for `anchored`, `'woodcut'`
   * is for `engraved`; a technique draws in ink with what is not for it. Default `'ink'`. Only `'anchored'`,
   * `'engraved'`. Another value builds another program.
   */
  get medium(): Medium {
    return this.choice('medium') as Medium;
  }

  set medium(value: Medium) {
    this.choose('medium', value);
  }

  /**
   * How much the tooth of the paper counts against the stroke in where a dry medium lies: at 0 strokes are smooth, at 1
   * there is nothing but grain. Share in [0, 1]. Default `0.4`. Only `'anchored'`, with `medium` `'dry'`.
   */
  get tooth(): number {
    return this.numbers.tooth;
  }

  set tooth(value: number) {
    this.numbers.tooth = checkNumber('tooth', value, HATCHING_PROPERTIES.tooth.range);
  }

  /** Size of the bumps of that tooth. CSS pixels in (0, ∞). Default `2.5`. Only `'anchored'`, with `medium` `'dry'`. */
  get toothSize(): number {
    return this.numbers.toothSize;
  }

  set toothSize(value: number) {
    this.numbers.toothSize = checkNumber('toothSize', value, HATCHING_PROPERTIES.toothSize.range);
  }

  /**
   * How gradually a dry medium covers: near 0 it covers or does not, as charcoal pressed hard; at 1 every tone is a
   * grey. Share in [0, 1]. Default `0.6`. Only `'anchored'`, with `medium` `'dry'`.
   */
  get softness(): number {
    return this.numbers.softness;
  }

  set softness(value: number) {
    this.numbers.softness = checkNumber('softness', value, HATCHING_PROPERTIES.softness.range);
  }

  /**
   * How much of a dry medium is rubbed into plain tone below the strokes. Share in [0, 1]. Default `0`. Only
   * `'anchored'`, with `medium` `'dry'`.
   */
  get smudge(): number {
    return this.numbers.smudge;
  }

  set smudge(value: number) {
    this.numbers.smudge = checkNumber('smudge', value, HATCHING_PROPERTIES.smudge.range);
  }

  /** How light becomes tone. Default `'lambert'`. Another value builds another program. */
  get toneModel(): ToneModel {
    return this.choice('toneModel') as ToneModel;
  }

  set toneModel(value: ToneModel) {
    this.choose('toneModel', value);
  }

  /** Number of bands of the tone model `'toon'`. Count in [2, ∞). Default `4`. Only with `toneModel` `'toon'`. */
  get toneSteps(): number {
    return this.numbers.toneSteps;
  }

  set toneSteps(value: number) {
    this.numbers.toneSteps = checkNumber('toneSteps', value, HATCHING_PROPERTIES.toneSteps.range);
  }

  /**
   * Exponent of the highlight of the tone model `'phong'`. Exponent in [0, ∞). Default `30`. Only with `toneModel`
   * `'phong'`.
   */
  get shininess(): number {
    return this.numbers.shininess;
  }

  set shininess(value: number) {
    this.numbers.shininess = checkNumber('shininess', value, HATCHING_PROPERTIES.shininess.range);
  }

  /**
   * The normal that tone is computed from. Reads as the one in use; `'auto'` leaves it to the technique again. Default
   * `'face'`, for `'anchored'` `'smooth'`, for `'engraved'` `'smooth'`. Another value builds another program.
   */
  get toneNormal(): ToneNormal {
    return this.choice('toneNormal') as ToneNormal;
  }

  set toneNormal(value: ToneNormal | 'auto') {
    this.choose('toneNormal', value);
  }

  /**
   * From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is
   * covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that
   * of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points
   * `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other
   * points need no other program. Default `'linear'`, for `'anchored'` `'printed'`, for `'engraved'` `'printed'`.
   */
  abstract toneCurve: ToneCurve;

  /**
   * How much of each light the surroundings throw back: the side turned away is lit by so much from behind, so that
   * shade is darkest at the terminator, as engravers draw it. Share in [0, 1]. Default `0`, for `'anchored'` `0.35`,
   * for `'engraved'` `0.4`.
   */
  get reflectedLight(): number {
    return this.numbers.reflectedLight ?? (defaultOf('reflectedLight', this.technique) as number);
  }

  set reflectedLight(value: number) {
    this.numbers.reflectedLight = checkNumber('reflectedLight', value, HATCHING_PROPERTIES.reflectedLight.range);
  }

  /**
   * How much ambient occlusion counts that `bakeOcclusion` has baked: cavities, folds and contacts are darker under any
   * light. Without such a bake it does nothing. Share in [0, 1]. Default `1`.
   */
  get occlusion(): number {
    return this.numbers.occlusion;
  }

  set occlusion(value: number) {
    this.numbers.occlusion = checkNumber('occlusion', value, HATCHING_PROPERTIES.occlusion.range);
  }

  /**
   * Tone, after the tone curve, below which the paper stays blank: a highlight with an edge. Tone in [0, 1]. Default
   * `0`.
   */
  get highlightTone(): number {
    return this.numbers.highlightTone;
  }

  set highlightTone(value: number) {
    this.numbers.highlightTone = checkNumber('highlightTone', value, HATCHING_PROPERTIES.highlightTone.range);
  }

  /**
   * How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightTone`. Share in [0, 1].
   * Default `0`. Only with `highlightTone` other than `0`.
   */
  get highlightSoftness(): number {
    return this.numbers.highlightSoftness;
  }

  set highlightSoftness(value: number) {
    this.numbers.highlightSoftness = checkNumber(
      'highlightSoftness',
      value,
      HATCHING_PROPERTIES.highlightSoftness.range,
    );
  }

  /**
   * Normal map, as in three's own materials (`normalMapType` says of which space). Turns the smooth tone normal; face
   * normals stay those of the triangles. Default `null`. Only with `toneNormal` `'smooth'`.
   */
  normalMap: Texture | null = HATCHING_DEFAULTS.normalMap;

  /**
   * How far the normal map turns the normal, along x and y. Factor. Default `(1, 1)`. Only with `toneNormal` `'smooth'`
   * and `normalMap` other than `null`.
   */
  readonly normalScale: Vector2 = new Vector2(...HATCHING_DEFAULTS.normalScale);

  /**
   * Heights that turn the smooth tone normal, where there is no normal map; face normals stay those of the triangles.
   * Default `null`. Only with `toneNormal` `'smooth'` and `normalMap` `null`.
   */
  bumpMap: Texture | null = HATCHING_DEFAULTS.bumpMap;

  /**
   * How far the bump map turns the normal. Factor. Default `1`. Only with `toneNormal` `'smooth'` and `normalMap`
   * `null` and `bumpMap` other than `null`.
   */
  get bumpScale(): number {
    return this.numbers.bumpScale;
  }

  set bumpScale(value: number) {
    this.numbers.bumpScale = checkNumber('bumpScale', value);
  }

  /**
   * Makes the smooth tone normal that of the flat triangle, before a normal or bump map turns it. Default `false`. Only
   * with `toneNormal` `'smooth'`. Another value builds another program.
   */
  get flatShading(): boolean {
    return this.choice('flatShading') as boolean;
  }

  set flatShading(value: boolean) {
    this.choose('flatShading', value);
  }

  /** Ambient occlusion (red channel): dims light without a direction, the environment and the light map. Default `null`. */
  aoMap: Texture | null = HATCHING_DEFAULTS.aoMap;

  /** How much the ambient occlusion counts. Factor in [0, ∞). Default `1`. Only with `aoMap` other than `null`. */
  get aoMapIntensity(): number {
    return this.numbers.aoMapIntensity;
  }

  set aoMapIntensity(value: number) {
    this.numbers.aoMapIntensity = checkNumber('aoMapIntensity', value, HATCHING_PROPERTIES.aoMapIntensity.range);
  }

  /** Light baked into a map, added to that of the scene; coloured light counts by its luminance. Default `null`. */
  lightMap: Texture | null = HATCHING_DEFAULTS.lightMap;

  /** How much the light map counts. Factor in [0, ∞). Default `1`. Only with `lightMap` other than `null`. */
  get lightMapIntensity(): number {
    return this.numbers.lightMapIntensity;
  }

  set lightMapIntensity(value: number) {
    this.numbers.lightMapIntensity = checkNumber(
      'lightMapIntensity',
      value,
      HATCHING_PROPERTIES.lightMapIntensity.range,
    );
  }

  /** Light that the surface gives off; its luminance lowers the tone. Default black. */
  readonly emissive: Color = new Color(HATCHING_DEFAULTS.emissive);

  /** How strong that light is. Factor in [0, ∞). Default `1`. */
  get emissiveIntensity(): number {
    return this.numbers.emissiveIntensity;
  }

  set emissiveIntensity(value: number) {
    this.numbers.emissiveIntensity = checkNumber(
      'emissiveIntensity',
      value,
      HATCHING_PROPERTIES.emissiveIntensity.range,
    );
  }

  /** Map of that light, multiplied by `emissive`. Default `null`. */
  emissiveMap: Texture | null = HATCHING_DEFAULTS.emissiveMap;

  /** Colour of the strokes. Default black. */
  readonly ink: Color = new Color(HATCHING_DEFAULTS.ink);

  /** Colour of the ground between strokes, multiplied by the surface colour. Default white. */
  readonly paper: Color = new Color(HATCHING_DEFAULTS.paper);

  /** Surface colour. Default white. */
  readonly color: Color = new Color(HATCHING_DEFAULTS.color);

  /** What ink does to the colour below it. Default `'cover'`. Another value builds another program. */
  get inkBlend(): InkBlend {
    return this.choice('inkBlend') as InkBlend;
  }

  set inkBlend(value: InkBlend) {
    this.choose('inkBlend', value);
  }

  /**
   * Below 1 one sees through the paper; at 0 there are strokes and nothing else. Needs `transparent`, `alphaTest` or
   * `alphaHash`: a material that is drawn opaque keeps its paper. Share in [0, 1]. Default `1`.
   */
  get paperOpacity(): number {
    return this.numbers.paperOpacity;
  }

  set paperOpacity(value: number) {
    this.numbers.paperOpacity = checkNumber('paperOpacity', value, HATCHING_PROPERTIES.paperOpacity.range);
  }

  /** Surface colour map, multiplied by `color`. Default `null`. */
  map: Texture | null = HATCHING_DEFAULTS.map;

  /** Opacity map (green channel), as in three's own materials. Default `null`. */
  alphaMap: Texture | null = HATCHING_DEFAULTS.alphaMap;

  /**
   * Draws something else in the place of strokes, to see what goes into them. Default `'none'`. Another value builds
   * another program.
   */
  get debugView(): DebugView {
    return this.choice('debugView') as DebugView;
  }

  set debugView(value: DebugView) {
    this.choose('debugView', value);
  }

  /** Numbers that were never set stay so, and follow the technique. */
  protected copyNumbers({ numbers }: HatchingMaterialProperties): void {
    Object.assign(this.numbers, numbers);
  }

  /** The choice in force. */
  protected abstract choice(name: HatchingPropertyName): string | boolean;

  /** @throws Error if `value` is none of the property's choices */
  protected abstract choose(name: HatchingPropertyName, value: string | boolean): void;
}
