import {
  Color,
  type ColorRepresentation,
  DoubleSide,
  Material,
  type MaterialParameters,
  ShaderMaterial,
  Vector2,
} from 'three';
import { checkNumber } from '../material/checkNumber.js';
import { checkColor } from '../material/checkValues.js';
import { toothMap } from '../tam/toothMap.js';
import { HATCHING_LINE_DEFAULTS, LINE_NUMBER_NAMES, LINE_NUMBERS, type LineNumberName } from './lineProperties.js';
import { lineShaders } from './lineShaders.js';
import { createLineUniforms } from './lineUniforms.js';

/** What `new HatchingLineMaterial()` and `setValues()` take. */
export type HatchingLineParameters = MaterialParameters &
  Partial<Pick<HatchingLineMaterial, LineNumberName>> & {
    ink?: ColorRepresentation | undefined;
    /** On the lit side and in the shade. */
    shadeWeights?: Vector2 | readonly [number, number] | undefined;
    fog?: boolean | undefined;
    clipping?: boolean | undefined;
  };

/**
 * How `HatchingLines` are drawn. Takes the scene's lights, fog and clipping planes. Every property may be set at any time and
 * counts from the next frame on; `wobble` and `tooth` build another program when they become 0, or more than 0. Several `HatchingLines` may share
 * one.
 */
export class HatchingLineMaterial extends ShaderMaterial {
  readonly isHatchingLineMaterial = true;
  /** @internal Left out of the declarations, because three.js 0.170 declares an accessor, and other versions a property. */
  override readonly type: string = 'HatchingLineMaterial';

  /** Width of a line of weight 1, in pixels of the drawing buffer, more than 0. See `millimetresToPixels`. Default 1.8. */
  declare lineWidth: number;
  /** Weight of the lines along which a surface turns away from the eye; 0 draws none. Default 1. */
  declare contours: number;
  /** Weight of the edges where a surface ends; 0 draws none. Default 1. */
  declare borders: number;
  /** Weight of sharp edges both of whose sides are seen; 0 draws none. Default 0.6. */
  declare creases: number;
  /** Weight of edges between groups of a geometry, on meshes with several materials; 0 draws none. Default 0.6. */
  declare materialBorders: number;
  /**
   * Weight of suggestive contours, where a contour would appear if the eye moved a little (DeCarlo et al., 2003); 0 draws
   * none. Every triangle is tested for them. Default 0; try 0.6.
   */
  declare suggestiveContours: number;
  /**
   * A contour ends where the surface ceases to bend away along the line of sight. It is as wide as asked where that curvature
   * is `taper` divided by the bounding radius, and tapers to nothing below. 0 ends it bluntly. Default 0.8.
   */
  declare taper: number;
  /** How far a hand strays from the line, in pixels. It belongs to the place on the object. Default 0. */
  declare wobble: number;
  /** How far a hand runs on past the corners of creases and borders, in pixels. Default 0. */
  declare overshoot: number;
  /** How much the paper counts against lines of a dry medium, in [0, 1]: 0, the default, is ink. See docs/media.md. */
  declare tooth: number;
  /** Size of the bumps of the paper, in pixels, more than 0. Default 2.5. */
  declare toothSize: number;
  /** Colour of the lines. Default black. */
  ink: Color = new Color(HATCHING_LINE_DEFAULTS.ink);
  /** Weights on the lit side and in the shade, by all lights of the scene. Default (0.5, 1.4). */
  shadeWeights: Vector2 = new Vector2(...HATCHING_LINE_DEFAULTS.shadeWeights);

  /** @throws RangeError if a number is out of its range; TypeError for an ink that is no colour */
  // React Three Fiber gives an attribute that is taken away its default only if the constructor counts no parameters.
  constructor(parameters: HatchingLineParameters | undefined = undefined) {
    super();
    for (const name of LINE_NUMBER_NAMES) this.defineNumber(name);
    this.uniforms = createLineUniforms();
    Object.assign(this, lineShaders());
    this.lights = true;
    this.fog = true;
    this.clipping = true;
    this.transparent = true;
    this.depthWrite = false;
    this.side = DoubleSide;
    this.setValues(parameters);
    this.writeUniforms(false, false);
  }

  /**
   * Sets properties by name, as three's own.
   *
   * @throws RangeError for a number out of its range; TypeError for an ink that is no colour
   */
  override setValues(values?: HatchingLineParameters): void {
    if (!values) return;
    if (values.ink !== undefined) checkColor('HatchingLineMaterial.ink', values.ink);
    const { shadeWeights, ...others } = values;
    super.setValues(others as MaterialParameters);
    if (shadeWeights !== undefined) this.shadeWeights.set(...checkPair(shadeWeights));
  }

  override copy(source: this): this {
    // Not ShaderMaterial's copy: that clones every texture among the uniforms, and each clone would be uploaded again.
    Material.prototype.copy.call(this, source);
    this.fog = source.fog;
    this.lights = source.lights;
    this.clipping = source.clipping;
    for (const name of LINE_NUMBER_NAMES) this[name] = source[name];
    this.ink.copy(source.ink);
    this.shadeWeights.copy(source.shadeWeights);
    return this;
  }

  /** Brings the properties to the shader. Allocates nothing. Called before each draw. @internal */
  writeUniforms(isDeformed: boolean, hasMaterials: boolean): void {
    for (const name of LINE_NUMBER_NAMES) this.uniforms[name].value = this[name];
    // Groups say nothing where all of them have one material.
    if (!hasMaterials) this.uniforms.materialBorders.value = 0;
    this.uniforms.ink.value = this.ink;
    this.uniforms.shadeWeights.value = this.shadeWeights;
    this.uniforms.opacity.value = this.opacity;
    if (this.tooth > 0) this.uniforms.toothMap.value = toothMap();
    this.setDefine('DEFORMED', isDeformed);
    this.uniformsNeedUpdate = true;
  }

  private setDefine(name: string, isSet: boolean): void {
    if (isSet === name in this.defines) return;
    if (isSet) this.defines[name] = '';
    else delete this.defines[name];
    this.needsUpdate = true;
  }

  private defineNumber(name: LineNumberName): void {
    let current: number = HATCHING_LINE_DEFAULTS[name];
    Object.defineProperty(this, name, {
      get: () => current,
      set: (value: number) => {
        current = checkNumber(name, value, LINE_NUMBERS[name], 'HatchingLineMaterial');
        // At once, so that `renderer.compile` builds the program that frames use.
        if (name === 'wobble' || name === 'tooth') this.setDefine(name.toUpperCase(), current > 0);
      },
      enumerable: true,
    });
  }
}

function checkPair(weights: Vector2 | readonly [number, number]): [number, number] {
  const [lit, shaded] = Symbol.iterator in Object(weights) ? [...(weights as Iterable<number>)] : [];
  if (lit >= 0 && shaded >= 0 && lit + shaded < Infinity) return [lit, shaded];
  throw new RangeError(
    'HatchingLineMaterial.shadeWeights: pass two numbers, 0 or more: the weights on the lit side and in the shade.',
  );
}
