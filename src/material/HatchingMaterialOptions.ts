import type { ColorRepresentation, MaterialParameters, Texture, Vector2 } from 'three';
import type { TonalArtMap } from '../tam/TonalArtMap.js';
import type { ToneCurvePoint } from './fitToneCurve.js';
import type { DebugView, InkBlend, LevelRule, StrokeAnchor, ToneModel, ToneNormal } from './shaderConventions.js';
import type { HatchingTechnique } from './techniques.js';

/** What a HatchingMaterial can be told, beside everything three's own `Material` accepts. */
export interface HatchingMaterialOptions {
  /** The hatch images. The material does not own it: dispose of it yourself. Without one the surface stays paper. */
  tonalArtMap: TonalArtMap | null;
  /** Default `adjacency`. Changing it builds another program. */
  technique: HatchingTechnique;
  /** Size of the strokes: tiles of the tonal art map per unit of object space. Default 3. */
  strokeScale: number;
  /**
   * Direction of the strokes: radians, counter-clockwise about the normal. 0 (default) draws them tangent to the light,
   * π/2 towards it (paper, figure 14).
   */
  strokeRotation: number;
  /** Shift of the strokes along T and B, in tiles. Default (0, 0). */
  strokeOffset: Vector2;
  /**
   * What the strokes of a mesh that deforms are fixed to: `rest` (default), its surface; `deformed`, object space, as in the
   * paper. Changing it builds another program.
   */
  strokeAnchor: StrokeAnchor;
  /** Default `lambert`. Changing it builds another program. */
  toneModel: ToneModel;
  /** Number of bands of the `toon` tone model, from 2. Default 4. */
  toneSteps: number;
  /** Exponent of the highlight of the `phong` tone model. Default 30. */
  shininess: number;
  /**
   * Default `face` as in the paper, but `smooth` for `anchored`, which knows no faces. Changing it builds another
   * program.
   */
  toneNormal: ToneNormal;
  /**
   * From the tone of the light to the tone that is printed. `linear` (default): the same. `perceptual`: half the paper is
   * covered where the light looks half as light as white (CIE lightness), which opens up the shade. Or 2 to 8 points
   * [light, printed], joined by a smooth curve; both run from 0, paper, to 1, the darkest hatch image. Going from one of
   * the three to another builds another program, other points do not.
   */
  toneCurve: ToneCurve;
  /**
   * In [0, 1], how much of each light the surroundings throw back: the side turned away is lit by so much from behind, so
   * that shade is darkest at the terminator, as engravers draw it. Default 0.
   */
  reflectedLight: number;
  /**
   * Crosses the strokes with a second layer where several lights disagree about their direction. The two together keep
   * the tone. Default false. With one light there is no difference. Changing it builds another program.
   */
  secondLayer: boolean;
  /** `triangle` and `adjacency`; `anchored` always goes by depth. Default `derivatives`. Changing it builds another program. */
  levelRule: LevelRule;
  /**
   * `triangle` and `adjacency` only: blends the fields that ink is decided from instead of the grey of the strokes, so
   * that they stay black and white. Default false, the paper's way. Changing it builds another program.
   */
  crisp: boolean;
  /** `anchored`: tiles between the points strokes are anchored to. Smaller is steadier under a moving light, with shorter strokes. Default 0.45. */
  anchorSpacing: number;
  /**
   * `anchored`, in [0, 1]: 0 (default) sizes strokes on the object by `strokeScale`, 1 on the screen by `texelPixels`,
   * without popping between; in between, strokes grow less than the object does as it comes nearer.
   */
  screenConstancy: number;
  /**
   * Pixels of the drawing buffer per texel of the map, where `anchored` sizes strokes on the screen; also where coarser
   * levels of the map take over, unless blended greys choose them by derivatives. Default 1: a stroke drawn two texels wide is
   * about two pixels wide.
   */
  texelPixels: number;
  /** Width in pixels over which ink fades at the edge of a stroke, for `anchored` and `crisp`. 0 is hard. Default 1. */
  edgePixels: number;
  /**
   * Radians in (0, π]. The blend with a neighbour fades out as the angle between the two normals reaches this. Default
   * π/2, the paper's rule. Only `adjacency` blends.
   */
  creaseAngle: number;
  /** Default `none`. Changing it builds another program. */
  debugView: DebugView;
  /** Colour of the strokes. Default black. */
  ink: ColorRepresentation;
  /** Colour of the ground between strokes, multiplied by the surface colour. Default white. */
  paper: ColorRepresentation;
  /** What ink does to the colour below it. Default `cover`. Changing it builds another program. */
  inkBlend: InkBlend;
  /**
   * In [0, 1]. Below 1 (default) one sees through the paper, at 0 there are strokes and nothing else. Asks for
   * `transparent`, `alphaTest` or `alphaHash`; a material that is drawn opaque keeps its paper.
   */
  paperOpacity: number;
  /** Surface colour. Default white. */
  color: ColorRepresentation;
  /** Surface colour map, multiplied by `color`. */
  map: Texture | null;
  /** Opacity map (green channel), as three's own. */
  alphaMap: Texture | null;
}

/** See {@link HatchingMaterialOptions.toneCurve}. */
export type ToneCurve = 'linear' | 'perceptual' | readonly ToneCurvePoint[];

export type HatchingMaterialParameters = MaterialParameters &
  Partial<HatchingMaterialOptions> & {
    fog?: boolean;
    wireframe?: boolean;
    clipping?: boolean;
    lights?: boolean;
  };
