// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.
import type { Color, ColorRepresentation, ShaderMaterial, Texture, Vector2 } from 'three';
import type {
  DebugView,
  HatchingTechnique,
  InkBlend,
  ShadowStrokes,
  StrokeAnchor,
  StrokeDirection,
  StrokeLayers,
  ToneModel,
  ToneNormal,
} from '../look/hatchingProperties.js';
import type { Hand } from '../strokes/hand/Hand.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { HatchingComposition } from './groups/HatchingComposition.js';
import type { HatchingCompositionOptions, PerTriangleOptions } from './groups/ownedProperties.js';
import type { PerTriangle } from './groups/PerTriangle.js';
import type { HatchingMap, Vector2Like } from './propertyValues.js';

/** The parameters of a HatchingMaterial, besides those of three's own `Material`. */
export interface HatchingMaterialOptions {
  /**
   * The hatch images: a map, which materials may share and which you dispose of yourself; or the name of a style, whose
   * map all materials share (`TonalArtMap.shared`), drawn with the first frame that needs it. Until a map is ready the
   * surface is blank paper, and with `null` it stays so. Default `'hatching'`. Only `'triangle'`, `'adjacency'`,
   * `'hatching'`, `'dryMedia'`.
   */
  tonalArtMap: HatchingMap;
  /** What a surface is drawn with, and how. Default `'hatching'`. Another value builds another program. */
  technique: HatchingTechnique;
  /**
   * Size of the strokes: larger is finer. Tiles of the tonal art map per unit of object space in (0, ∞). Default `3`.
   * Only with `screenSpaceShare` other than `1`.
   */
  tilesPerObjectUnit: number;
  /**
   * How far strokes are turned, counterclockwise, as seen from outside. Where they follow the light, 0 draws them
   * tangent to it, π/2 towards it (figure 14); with `direction: 'sheet'` it is their angle to the horizontal of the
   * sheet. Of lines it turns what cuts them, where a light does: at π/2 `direction: 'light'` is `'towardsLight'`. Half
   * a turn more is the same direction. Radians. Default `0`, for `'hatching'`, `'dryMedia'`, `'stipple'` `Math.PI / 2`.
   * For all but `'stipple'`, with `direction` `'auto'` or `'light'` or `'towardsLight'` or `'sheet'`.
   */
  strokeAngle: number;
  /** What the strokes of a mesh that deforms are fixed to. Default `'rest'`. Another value builds another program. */
  strokeAnchor: StrokeAnchor;
  /**
   * What strokes are sized on: 0 the object, by `tilesPerObjectUnit`; 1 the screen, by `strokeWidth`, without popping.
   * In between, strokes grow less than the object does as the camera comes nearer. Strokes and dots have a program of
   * their own for 0, which is cheaper. Share in [0, 1]. Default `1`. For all but `'triangle'`, `'adjacency'`.
   */
  screenSpaceShare: number;
  /**
   * Width of a stroke on the screen, which is also where coarser levels of the map take over, unless blended greys
   * choose them by derivatives; of a `pen`, the width of the strokes of its `hand`. `null` leaves it to the technique:
   * for `triangle` and `adjacency` it is as wide as the map draws strokes, `tonalArtMap.strokeTexels` pixels. CSS
   * pixels in (0, ∞). Default `null`, for `'hatching'`, `'dryMedia'`, `'stipple'` `1.5`. For all but `'engraving'`,
   * `'woodcut'`, with `sharpInk` `true` and `hand` other than `null`, or `levelRule` `'depth'` and `hand` other than
   * `null`.
   */
  strokeWidth: number | null;
  /**
   * Width over which ink fades at the edge of a stroke or a dot. 0 is hard. Dry media have `softness` instead. Pixels
   * of the drawing buffer in [0, ∞). Default `1`. Only `'triangle'`, `'adjacency'`, `'hatching'`, `'stipple'`, with
   * `sharpInk` `true`.
   */
  edgePixels: number;
  /**
   * Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter
   * strokes. Tiles in (0, ∞). Default `0.4`. Only `'hatching'`, `'dryMedia'`.
   */
  latticeSpacing: number;
  /**
   * What strokes and lines take their direction from. Strokes of `hatching` and `dryMedia` know `'light'`, `'form'`,
   * `'acrossForm'` and `'sheet'`; lines of `engraving`, `pen` and `woodcut` know all but `'sheet'`. Another counts as
   * the default. Default `'light'`. Only `'hatching'`, `'dryMedia'`, `'engraving'`, `'pen'`, `'woodcut'`. Another value
   * builds another program.
   */
  direction: StrokeDirection;
  /**
   * A hand from `learnHand`, whose whole strokes are drawn: at `strokeWidth`, or with `null` a millimetre of the sheet
   * six pixels long. Their lengths, distances and crossings are the hand's, in place of `lineSpacing`, `strokeLength`,
   * `crossFrom`, `crossAngle` and `irregularity`. Another hand builds no other program; `null` draws the pen's own
   * strokes. Default `null`. Only `'pen'`.
   */
  hand: Hand | null;
  /**
   * Distance between lines. Where that is less than `minLineSpacing`, every other line is left out. As the camera comes
   * nearer new lines appear between them, thin at first. CSS pixels at a `screenSpaceShare` of 1, 256ths of a tile at 0
   * in (0, ∞). Default `4.5`. Only `'engraving'`, `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  lineSpacing: number;
  /**
   * Least distance between lines; never less than two pixels of the drawing buffer. Where lines would lie closer, every
   * other one is left out. Below three pixels lines flicker in motion. CSS pixels in [2, ∞). Default `3`. Only
   * `'engraving'`, `'pen'`, `'woodcut'`.
   */
  minLineSpacing: number;
  /**
   * Length of a stroke of `pen`, and of a wedge of `woodcut`: from 0.7 to 1.4 times as much, since strokes give way to
   * others half as long as the camera comes nearer. CSS pixels at a `screenSpaceShare` of 1, 256ths of a tile at 0 in
   * (0, ∞). Default `72`. Only `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  strokeLength: number;
  /**
   * How many layers of strokes there are. Default `'single'`, for `'hatching'`, `'dryMedia'`, `'stipple'` `'tone'`.
   * Only `'triangle'`, `'adjacency'`, `'hatching'`, `'dryMedia'`, `'stipple'`. Another value builds another program.
   */
  strokeLayers: StrokeLayers | 'auto';
  /**
   * Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of an engraving, a
   * pen or a woodcut; at 1 none do. Tone in [0, 1]. Default `0.52`, for `'hatching'`, `'dryMedia'`, `'stipple'` `0.6`.
   * Only with `strokeLayers` `'tone'` and `hand` `null`.
   */
  crossFrom: number;
  /**
   * Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that
   * cut the first lines and those that cut the lines across them; lines that follow the form cross as they were baked.
   * 60° is a pen's, 90° an engraver's. Radians in (0, π/2]. Default `Math.PI / 3`. Only with `strokeLayers` `'tone'`
   * and `hand` `null`.
   */
  crossAngle: number;
  /**
   * How unsteady the hand is: lines differ in width, stray, and have gaps in the lights. 0 is a ruling machine. Share
   * in [0, 1]. Default `0.4`. Only `'engraving'`, `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  irregularity: number;
  /**
   * What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all. Default
   * `'tone'`. Another value builds another program.
   */
  shadowStrokes: ShadowStrokes;
  /**
   * How strongly the grain of the paper breaks up strokes: at 0 strokes are smooth, at 1 only grain is left. Share in
   * [0, 1]. Default `0.4`. Only `'dryMedia'`.
   */
  paperGrain: number;
  /** Size of the bumps of the paper. CSS pixels in (0, ∞). Default `2.5`. Only `'dryMedia'`. */
  paperGrainSize: number;
  /**
   * How gradually strokes cover: near 0 it is black or white, as charcoal pressed hard; at 1 every tone is a grey.
   * Share in [0, 1]. Default `0.6`. Only `'dryMedia'`.
   */
  softness: number;
  /** How much of the strokes is rubbed into plain tone below them. Share in [0, 1]. Default `0`. Only `'dryMedia'`. */
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
   * The normal that tone is computed from. The value in use is read back; `'auto'` leaves it to the technique again.
   * Default `'face'`, for all but `'triangle'`, `'adjacency'` `'smooth'`. Another value builds another program.
   */
  toneNormal: ToneNormal | 'auto';
  /**
   * From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is
   * covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that
   * of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points
   * `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other
   * points need no other program. Default `'linear'`, for all but `'triangle'`, `'adjacency'` `'printed'`.
   */
  toneCurve: ToneCurve;
  /**
   * Share of each light that the surroundings throw back from behind: shade is darkest at the terminator, as engravers
   * draw it. Planes in shade get more of it on one side of the light, so that two walls at one angle to the light
   * differ. Share in [0, 1]. Default `0`, for `'hatching'`, `'dryMedia'`, `'stipple'` `0.35`, for `'engraving'`,
   * `'pen'`, `'woodcut'` `0.4`.
   */
  reflectedLight: number;
  /**
   * How metallic the surface is, as in three's own materials. Smooth metal is drawn as draughtsmen draw chrome, by the
   * room it mirrors: light above, dark below a horizon with a hard edge, and a floor that is light again. What does not
   * mirror is shaded as any surface. Above 0 on smooth metal it compiles another program. Share in [0, 1]. Default `0`.
   */
  metalness: number;
  /**
   * How rough metal is, as in three's own materials: up to 0.4 it mirrors, from there on less, and from 0.7 on nothing.
   * Share in [0, 1]. Default `1`. Only with `metalness` other than `0`.
   */
  roughness: number;
  /**
   * Strength of the ambient occlusion that `bakeOcclusion` has baked: cavities, folds and contacts are darker under any
   * light. Without such a bake it does nothing. Share in [0, 1]. Default `1`.
   */
  occlusion: number;
  /**
   * How far hollows that `occlusion` knows of are brought to the darkest tone, under any light: sockets, nostrils, the
   * parting of lips, undercuts and contacts. At 0 they only lose light. Share in [0, 1]. Default `0`, for all but
   * `'triangle'`, `'adjacency'` `1`. Only with `occlusion` other than `0`.
   */
  hollowStrength: number;
  /**
   * How much of the darkness of the surface's own colour (`color`, `map` and vertices) is hatched: at 1 a colour that
   * looks half as light as white (CIE lightness) brings the tone half way to the darkest. White is left as it is.
   * Presets draw colours by it in ink alone, with a `colorFill` of 0. Share in [0, 1]. Default `0`.
   */
  colorHatching: number;
  /**
   * Tone, after the tone curve, below which the paper stays blank: a highlight with an edge. Tone in [0, 1]. Default
   * `0`.
   */
  highlightThreshold: number;
  /**
   * How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightThreshold`. Share in [0,
   * 1]. Default `0`. Only with `highlightThreshold` other than `0`.
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
  /** Strength of the ambient occlusion. Factor in [0, ∞). Default `1`. Only with `aoMap` other than `null`. */
  aoMapIntensity: number;
  /** Light baked into a map, added to that of the scene; coloured light counts by its luminance. Default `null`. */
  lightMap: Texture | null;
  /** Strength of the light map. Factor in [0, ∞). Default `1`. Only with `lightMap` other than `null`. */
  lightMapIntensity: number;
  /** Light that the surface gives off; its luminance lowers the tone. Default black. */
  emissive: ColorRepresentation;
  /** How strong that light is. Factor in [0, ∞). Default `1`. */
  emissiveIntensity: number;
  /** Map of that light, multiplied by `emissive`. Default `null`. */
  emissiveMap: Texture | null;
  /** Colour of the strokes. Default black. */
  ink: ColorRepresentation;
  /** Colour of the ground between strokes, multiplied by the surface colour as far as `colorFill` says. Default white. */
  paper: ColorRepresentation;
  /** Surface colour. Default white. */
  color: ColorRepresentation;
  /**
   * How much of the surface's own colour (`color`, `map` and vertices) is printed on the paper: nothing at 0, and in
   * between a tint of it, on which strokes are easier to read. Share in [0, 1]. Default `1`.
   */
  colorFill: number;
  /** What ink does to the colour below it. Default `'cover'`. Another value builds another program. */
  inkBlend: InkBlend;
  /**
   * Opacity of the paper between strokes: below 1 what is behind shows through, at 0 only strokes are drawn. Needs
   * `transparent`, `alphaTest` or `alphaHash`: a material that is drawn opaque keeps its paper. Share in [0, 1].
   * Default `1`.
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
  /**
   * What counts for a whole picture: exposure, depth fade, focus and vignette. Materials may share one, as the
   * materials of a scene that `applyHatching` hatched do; a new material has its own. A plain object sets numbers of
   * the one that the material has.
   */
  composition: HatchingComposition | Partial<HatchingCompositionOptions>;
  /**
   * What only the techniques of the paper by Suarez et al. read. Set them one by one, or some of them by a plain
   * object.
   */
  perTriangle: Partial<PerTriangleOptions>;
}

/** The properties of `HatchingMaterial`. */
export interface HatchingMaterialProperties extends ShaderMaterial {
  /**
   * The hatch images: a map, which materials may share and which you dispose of yourself; or the name of a style, whose
   * map all materials share (`TonalArtMap.shared`), drawn with the first frame that needs it. Until a map is ready the
   * surface is blank paper, and with `null` it stays so. Default `'hatching'`. Only `'triangle'`, `'adjacency'`,
   * `'hatching'`, `'dryMedia'`.
   */
  tonalArtMap: HatchingMap;
  /** What a surface is drawn with, and how. Default `'hatching'`. Another value builds another program. */
  technique: HatchingTechnique;
  /**
   * Size of the strokes: larger is finer. Tiles of the tonal art map per unit of object space in (0, ∞). Default `3`.
   * Only with `screenSpaceShare` other than `1`.
   */
  tilesPerObjectUnit: number;
  /**
   * How far strokes are turned, counterclockwise, as seen from outside. Where they follow the light, 0 draws them
   * tangent to it, π/2 towards it (figure 14); with `direction: 'sheet'` it is their angle to the horizontal of the
   * sheet. Of lines it turns what cuts them, where a light does: at π/2 `direction: 'light'` is `'towardsLight'`. Half
   * a turn more is the same direction. Radians. Default `0`, for `'hatching'`, `'dryMedia'`, `'stipple'` `Math.PI / 2`.
   * For all but `'stipple'`, with `direction` `'auto'` or `'light'` or `'towardsLight'` or `'sheet'`.
   */
  strokeAngle: number;
  /** What the strokes of a mesh that deforms are fixed to. Default `'rest'`. Another value builds another program. */
  strokeAnchor: StrokeAnchor;
  /**
   * What strokes are sized on: 0 the object, by `tilesPerObjectUnit`; 1 the screen, by `strokeWidth`, without popping.
   * In between, strokes grow less than the object does as the camera comes nearer. Strokes and dots have a program of
   * their own for 0, which is cheaper. Share in [0, 1]. Default `1`. For all but `'triangle'`, `'adjacency'`.
   */
  screenSpaceShare: number;
  /**
   * Width of a stroke on the screen, which is also where coarser levels of the map take over, unless blended greys
   * choose them by derivatives; of a `pen`, the width of the strokes of its `hand`. `null` leaves it to the technique:
   * for `triangle` and `adjacency` it is as wide as the map draws strokes, `tonalArtMap.strokeTexels` pixels. CSS
   * pixels in (0, ∞). Default `null`, for `'hatching'`, `'dryMedia'`, `'stipple'` `1.5`. For all but `'engraving'`,
   * `'woodcut'`, with `sharpInk` `true` and `hand` other than `null`, or `levelRule` `'depth'` and `hand` other than
   * `null`.
   */
  strokeWidth: number | null;
  /**
   * Width over which ink fades at the edge of a stroke or a dot. 0 is hard. Dry media have `softness` instead. Pixels
   * of the drawing buffer in [0, ∞). Default `1`. Only `'triangle'`, `'adjacency'`, `'hatching'`, `'stipple'`, with
   * `sharpInk` `true`.
   */
  edgePixels: number;
  /**
   * Distance between the points that strokes are anchored to. Smaller is steadier under a moving light, with shorter
   * strokes. Tiles in (0, ∞). Default `0.4`. Only `'hatching'`, `'dryMedia'`.
   */
  latticeSpacing: number;
  /**
   * What strokes and lines take their direction from. Strokes of `hatching` and `dryMedia` know `'light'`, `'form'`,
   * `'acrossForm'` and `'sheet'`; lines of `engraving`, `pen` and `woodcut` know all but `'sheet'`. Another counts as
   * the default. Default `'light'`. Only `'hatching'`, `'dryMedia'`, `'engraving'`, `'pen'`, `'woodcut'`. Another value
   * builds another program.
   */
  direction: StrokeDirection;
  /**
   * A hand from `learnHand`, whose whole strokes are drawn: at `strokeWidth`, or with `null` a millimetre of the sheet
   * six pixels long. Their lengths, distances and crossings are the hand's, in place of `lineSpacing`, `strokeLength`,
   * `crossFrom`, `crossAngle` and `irregularity`. Another hand builds no other program; `null` draws the pen's own
   * strokes. Default `null`. Only `'pen'`.
   */
  hand: Hand | null;
  /**
   * Distance between lines. Where that is less than `minLineSpacing`, every other line is left out. As the camera comes
   * nearer new lines appear between them, thin at first. CSS pixels at a `screenSpaceShare` of 1, 256ths of a tile at 0
   * in (0, ∞). Default `4.5`. Only `'engraving'`, `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  lineSpacing: number;
  /**
   * Least distance between lines; never less than two pixels of the drawing buffer. Where lines would lie closer, every
   * other one is left out. Below three pixels lines flicker in motion. CSS pixels in [2, ∞). Default `3`. Only
   * `'engraving'`, `'pen'`, `'woodcut'`.
   */
  minLineSpacing: number;
  /**
   * Length of a stroke of `pen`, and of a wedge of `woodcut`: from 0.7 to 1.4 times as much, since strokes give way to
   * others half as long as the camera comes nearer. CSS pixels at a `screenSpaceShare` of 1, 256ths of a tile at 0 in
   * (0, ∞). Default `72`. Only `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  strokeLength: number;
  /**
   * How many layers of strokes there are. Default `'single'`, for `'hatching'`, `'dryMedia'`, `'stipple'` `'tone'`.
   * Only `'triangle'`, `'adjacency'`, `'hatching'`, `'dryMedia'`, `'stipple'`. Another value builds another program.
   */
  get strokeLayers(): StrokeLayers;
  set strokeLayers(value: StrokeLayers | 'auto');
  /**
   * Tone above which others cross the first strokes, with `strokeLayers: 'tone'`, or the first lines of an engraving, a
   * pen or a woodcut; at 1 none do. Tone in [0, 1]. Default `0.52`, for `'hatching'`, `'dryMedia'`, `'stipple'` `0.6`.
   * Only with `strokeLayers` `'tone'` and `hand` `null`.
   */
  crossFrom: number;
  /**
   * Angle between the first layer of strokes and the second, with `strokeLayers: 'tone'`, or between the planes that
   * cut the first lines and those that cut the lines across them; lines that follow the form cross as they were baked.
   * 60° is a pen's, 90° an engraver's. Radians in (0, π/2]. Default `Math.PI / 3`. Only with `strokeLayers` `'tone'`
   * and `hand` `null`.
   */
  crossAngle: number;
  /**
   * How unsteady the hand is: lines differ in width, stray, and have gaps in the lights. 0 is a ruling machine. Share
   * in [0, 1]. Default `0.4`. Only `'engraving'`, `'pen'`, `'woodcut'`, with `hand` `null`.
   */
  irregularity: number;
  /**
   * What cast shadows do to the strokes of a mesh with `receiveShadow`. The tone is the same with all. Default
   * `'tone'`. Another value builds another program.
   */
  shadowStrokes: ShadowStrokes;
  /**
   * How strongly the grain of the paper breaks up strokes: at 0 strokes are smooth, at 1 only grain is left. Share in
   * [0, 1]. Default `0.4`. Only `'dryMedia'`.
   */
  paperGrain: number;
  /** Size of the bumps of the paper. CSS pixels in (0, ∞). Default `2.5`. Only `'dryMedia'`. */
  paperGrainSize: number;
  /**
   * How gradually strokes cover: near 0 it is black or white, as charcoal pressed hard; at 1 every tone is a grey.
   * Share in [0, 1]. Default `0.6`. Only `'dryMedia'`.
   */
  softness: number;
  /** How much of the strokes is rubbed into plain tone below them. Share in [0, 1]. Default `0`. Only `'dryMedia'`. */
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
   * The normal that tone is computed from. The value in use is read back; `'auto'` leaves it to the technique again.
   * Default `'face'`, for all but `'triangle'`, `'adjacency'` `'smooth'`. Another value builds another program.
   */
  get toneNormal(): ToneNormal;
  set toneNormal(value: ToneNormal | 'auto');
  /**
   * From the tone of the light to the tone that is printed. `'linear'`: the same. `'perceptual'`: half the paper is
   * covered where the light looks half as light as white (CIE lightness), which opens up the shade. `'printed'`: that
   * of printed line drawings, whose lights stay blank, and in whose deepest shade some paper shows. Or 2 to 8 points
   * `[light, printed]`, joined by a smooth curve; both run from 0, blank paper, to 1, the darkest hatch image. Other
   * points need no other program. Default `'linear'`, for all but `'triangle'`, `'adjacency'` `'printed'`.
   */
  toneCurve: ToneCurve;
  /**
   * Share of each light that the surroundings throw back from behind: shade is darkest at the terminator, as engravers
   * draw it. Planes in shade get more of it on one side of the light, so that two walls at one angle to the light
   * differ. Share in [0, 1]. Default `0`, for `'hatching'`, `'dryMedia'`, `'stipple'` `0.35`, for `'engraving'`,
   * `'pen'`, `'woodcut'` `0.4`.
   */
  reflectedLight: number;
  /**
   * How metallic the surface is, as in three's own materials. Smooth metal is drawn as draughtsmen draw chrome, by the
   * room it mirrors: light above, dark below a horizon with a hard edge, and a floor that is light again. What does not
   * mirror is shaded as any surface. Above 0 on smooth metal it compiles another program. Share in [0, 1]. Default `0`.
   */
  metalness: number;
  /**
   * How rough metal is, as in three's own materials: up to 0.4 it mirrors, from there on less, and from 0.7 on nothing.
   * Share in [0, 1]. Default `1`. Only with `metalness` other than `0`.
   */
  roughness: number;
  /**
   * Strength of the ambient occlusion that `bakeOcclusion` has baked: cavities, folds and contacts are darker under any
   * light. Without such a bake it does nothing. Share in [0, 1]. Default `1`.
   */
  occlusion: number;
  /**
   * How far hollows that `occlusion` knows of are brought to the darkest tone, under any light: sockets, nostrils, the
   * parting of lips, undercuts and contacts. At 0 they only lose light. Share in [0, 1]. Default `0`, for all but
   * `'triangle'`, `'adjacency'` `1`. Only with `occlusion` other than `0`.
   */
  hollowStrength: number;
  /**
   * How much of the darkness of the surface's own colour (`color`, `map` and vertices) is hatched: at 1 a colour that
   * looks half as light as white (CIE lightness) brings the tone half way to the darkest. White is left as it is.
   * Presets draw colours by it in ink alone, with a `colorFill` of 0. Share in [0, 1]. Default `0`.
   */
  colorHatching: number;
  /**
   * Tone, after the tone curve, below which the paper stays blank: a highlight with an edge. Tone in [0, 1]. Default
   * `0`.
   */
  highlightThreshold: number;
  /**
   * How soft that edge is: 0 is sharp; at 1 the tone fades in from nothing to twice `highlightThreshold`. Share in [0,
   * 1]. Default `0`. Only with `highlightThreshold` other than `0`.
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
  readonly normalScale: Vector2;
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
  /** Strength of the ambient occlusion. Factor in [0, ∞). Default `1`. Only with `aoMap` other than `null`. */
  aoMapIntensity: number;
  /** Light baked into a map, added to that of the scene; coloured light counts by its luminance. Default `null`. */
  lightMap: Texture | null;
  /** Strength of the light map. Factor in [0, ∞). Default `1`. Only with `lightMap` other than `null`. */
  lightMapIntensity: number;
  /** Light that the surface gives off; its luminance lowers the tone. Default black. */
  readonly emissive: Color;
  /** How strong that light is. Factor in [0, ∞). Default `1`. */
  emissiveIntensity: number;
  /** Map of that light, multiplied by `emissive`. Default `null`. */
  emissiveMap: Texture | null;
  /** Colour of the strokes. Default black. */
  readonly ink: Color;
  /** Colour of the ground between strokes, multiplied by the surface colour as far as `colorFill` says. Default white. */
  readonly paper: Color;
  /** Surface colour. Default white. */
  readonly color: Color;
  /**
   * How much of the surface's own colour (`color`, `map` and vertices) is printed on the paper: nothing at 0, and in
   * between a tint of it, on which strokes are easier to read. Share in [0, 1]. Default `1`.
   */
  colorFill: number;
  /** What ink does to the colour below it. Default `'cover'`. Another value builds another program. */
  inkBlend: InkBlend;
  /**
   * Opacity of the paper between strokes: below 1 what is behind shows through, at 0 only strokes are drawn. Needs
   * `transparent`, `alphaTest` or `alphaHash`: a material that is drawn opaque keeps its paper. Share in [0, 1].
   * Default `1`.
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
  /**
   * What counts for a whole picture: exposure, depth fade, focus and vignette. Materials may share one, as the
   * materials of a scene that `applyHatching` hatched do; a new material has its own. A plain object sets numbers of
   * the one that the material has.
   */
  get composition(): HatchingComposition;
  set composition(value: HatchingComposition | Partial<HatchingCompositionOptions>);
  /**
   * What only the techniques of the paper by Suarez et al. read. Set them one by one, or some of them by a plain
   * object.
   */
  get perTriangle(): PerTriangle;
  set perTriangle(value: Partial<PerTriangleOptions>);
}
