import {
  type Camera,
  Color,
  type ColorRepresentation,
  DoubleSide,
  Material,
  type MaterialParameters,
  type Mesh,
  type PerspectiveCamera,
  ShaderMaterial,
  type Vector4,
  type WebGLRenderer,
} from 'three';
import { ACCENT_STEPS, OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { constantCase } from '../../look/HatchingProperty.js';
import type { HiddenOutlines } from '../../look/hiddenOutlines.js';
import {
  BORDER,
  CONTRARY,
  CORNER_AT_END,
  CORNER_AT_START,
  CREASE,
  INTERSECTION,
  IS_EDGE,
  MATERIAL_BORDER,
  POINT_BITS,
  POINT_MASK,
  SPACING_STEPS,
} from '../../mesh/bake/outlineLayout.js';
import { checkColor } from '../checkProperty.js';
import { FrameStamp } from '../FrameStamp.js';
import { type FadingLook, takesWeight, writeFading, writeImportance } from '../fading/fading.js';
import { writeSheet } from '../pictureOffset.js';
import type { Shaders } from '../shaders/hatchingShaders.js';
import { conventionsChunk } from '../shaders/shaderConventions.js';
import { definesOf, resolveIncludes } from '../shaders/shaderText.js';
import { toothConstantsChunk } from '../tam/patternSizes.js';
import { toothMap } from '../tam/toothMap.js';
import { lightChunks } from '../three/lightKinds.js';
import { MeshUniforms } from '../three/MeshUniforms.js';
import { type OutlineWeights, setWeights } from './OutlineWeights.js';
import { HATCHING_OUTLINE_DEFAULTS, OUTLINE_NUMBER_NAMES, type OutlineNumberName } from './outlineProperties.js';
import {
  checkHidden,
  createOutlineUniforms,
  defineIntersections,
  defineOutlineNumbers,
  defineOutlineWeights,
  OUTLINE_MESH_UNIFORMS,
  writeOutlineLook,
} from './outlineUniforms.js';
import { writeDrawState } from './surfaceRules.js';

const flags = { BORDER, CREASE, MATERIAL_BORDER, CONTRARY, CORNER_AT_START, CORNER_AT_END, IS_EDGE, INTERSECTION };

/** The constants, as defines, that the shaders of outlines share with the bake and with vector drawing. */
const outlineConventionsChunk = (): string =>
  [
    ...Object.entries(flags).map(([name, bit]) => `#define EDGE_${name} ${bit}u`),
    definesOf(OUTLINE_CONSTANTS),
    definesOf({ ACCENT_STEPS, POINT_BITS }, ''),
    definesOf({ SPACING_STEPS }),
    definesOf({ POINT_MASK }, 'u'),
  ].join('\n');

/** The sources of the outline shaders, and the chunks that they share with `HatchingMaterial`. */
const files: Readonly<Record<string, string>> = import.meta.glob(
  [
    '../../../shaders/outlines/*',
    '../../../shaders/chunks/{fading,lightLuminance,lineCoverage,meanLight,normalDistribution,tooth}.glsl',
    '../../../shaders/perTriangle/turns.glsl',
  ],
  { query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of outlines. The first call resolves their includes. */
export function outlineShaders(): Shaders {
  if (made) return made;
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    'outlines/conventions': outlineConventionsChunk(),
    toothConstants: toothConstantsChunk(),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    chunks[path.replace('../../../shaders/', '').replace('chunks/', '').replace('.glsl', '')] = text;
  }
  made = {
    vertexShader: resolveIncludes(chunks['outlines/outlines.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['outlines/outlines.frag'], chunks),
  };
  return made;
}

/** The id where no material decides what fades. */
const NO_LOOK = -1;

/** The parameters of `new HatchingOutlineMaterial()` and `setValues()`. */
export type HatchingOutlineParameters = MaterialParameters &
  Partial<Pick<HatchingOutlineMaterial, OutlineNumberName>> & {
    ink?: ColorRepresentation | undefined;
    /** Some of the weights, or all. */
    weights?: Partial<OutlineWeights> | undefined;
    hidden?: HiddenOutlines | undefined;
    intersections?: boolean | undefined;
    fog?: boolean | undefined;
    clipping?: boolean | undefined;
  };

/**
 * The material of `HatchingOutlines`. It uses the lights, fog and clipping planes of the scene. Every property may be set at any time
 * and takes effect in the next frame; `wobble` and `paperGrain` compile another program when they change between 0 and more than 0. Several
 * `HatchingOutlines` may share one material.
 */
export class HatchingOutlineMaterial extends ShaderMaterial {
  readonly isHatchingOutlineMaterial = true;
  /** @internal Left out of the declarations, because three.js 0.170 declares an accessor and other versions a property. */
  override readonly type: string = 'HatchingOutlineMaterial';

  /** Width of an outline of weight 1, in CSS pixels, above 0. In print, see `millimetresToPixels`. Default 1.8. */
  declare outlineWidth: number;
  /**
   * The share of the contours between a lit surface and the paper that is lost, from 0 (none) to 1 (every lit one). The brightest parts
   * are lost first. A thin line remains, thinner the larger the share: 0.12 of its width at 1. Default 0.2.
   */
  declare lostEdges: number;
  /**
   * How much heavier a contour becomes where another one ends behind it, as a share of its weight, 0 or more. The accent tapers over
   * eight times `outlineWidth` to either side. Default 0.5.
   */
  declare accents: number;
  /**
   * Where a contour begins to taper, 0 or more. A contour ends where the surface stops curving away along the line of sight. It has
   * its full width where that curvature is at least `taper` divided by the bounding radius, and becomes narrower below. 0 ends it
   * bluntly. Default 0.8.
   */
  declare taper: number;
  /** How far outlines deviate as if drawn by hand, in CSS pixels, 0 or more. The deviation is fixed to the object. Default 0. */
  declare wobble: number;
  /** How far outlines are drawn beyond the corners of creases and borders, in CSS pixels, 0 or more. Default 0. */
  declare overshoot: number;
  /** How strongly the tooth of the paper breaks outlines up, from 0 (ink, the default) to 1. See docs/media.md. */
  declare paperGrain: number;
  /** Size of the bumps of the paper, in CSS pixels, above 0. Default 2.5. */
  declare paperGrainSize: number;
  /** Colour of the outlines. Default black. */
  ink: Color = new Color(HATCHING_OUTLINE_DEFAULTS.ink);
  /** How heavy each kind of line is. Set them one by one, or some of them by `setValues({ weights: { creases: 0 } })`. */
  declare readonly weights: OutlineWeights;

  /** Uploads the uniforms that differ between meshes. @internal */
  readonly ofMesh: MeshUniforms;

  /**
   * Whether lines are drawn along which the surface cuts those of other meshes of the scene whose outlines have it true too, and along
   * which the parts of a mesh that are not connected cut each other. They are computed in the worker, once for two meshes that do not move
   * towards each other, and appear some frames later: the scene dispatches an event of the type `'intersections'` then. Meanwhile, and
   * between instances and meshes that deform, they are drawn as far as the screen shows them. Default false.
   */
  declare intersections: boolean;

  private hiddenLines: HiddenOutlines = HATCHING_OUTLINE_DEFAULTS.hidden;
  /** The frame that the uniforms were written for, and the id of the fading material: a reference would keep the material alive. */
  private readonly written = new FrameStamp();
  private writtenLook = NO_LOOK;

  /** @throws RangeError if a number is out of its range; TypeError if `ink` is not a colour, or `weights` has an unknown name */
  // React Three Fiber resets a removed attribute to its default only if the constructor's `length` is 0.
  constructor(parameters: HatchingOutlineParameters | undefined = undefined) {
    super();
    defineOutlineNumbers(this, 'HatchingOutlineMaterial', (name, value) => {
      // The define is set at once, so that `renderer.compile` compiles the program that frames use.
      if (name === 'wobble' || name === 'paperGrain') this.setDefine(constantCase(name), value > 0);
    });
    defineOutlineWeights(this, 'HatchingOutlineMaterial');
    defineIntersections(this, 'HatchingOutlineMaterial');
    this.uniforms = createOutlineUniforms();
    Object.assign(this, outlineShaders());
    this.lights = true;
    this.fog = true;
    this.clipping = true;
    this.transparent = true;
    this.depthWrite = false;
    this.toneMapped = false;
    this.side = DoubleSide;
    this.ofMesh = new MeshUniforms(this, OUTLINE_MESH_UNIFORMS);
    this.setValues(parameters);
    this.writeUniforms(false, false);
  }

  /**
   * Sets properties by name, as `setValues` of three.js does.
   *
   * @throws RangeError if a number is out of its range; TypeError if `ink` is not a colour, or `weights` has an unknown name
   */
  override setValues(values?: HatchingOutlineParameters): void {
    if (!values) return;
    if (values.ink !== undefined) checkColor('HatchingOutlineMaterial.ink', values.ink);
    const { weights, ...others } = values;
    if (weights !== undefined) setWeights(this.weights, weights, 'HatchingOutlineMaterial');
    super.setValues(others as MaterialParameters);
  }

  /**
   * How outlines and creases behind a surface are drawn, as in technical drawings: not at all (`'none'`, the default), `'dashed'` or
   * `'faint'`. They are half as wide as `outlineWidth`, wherever they lie. Drawing them takes one more pass over all edges of the mesh.
   */
  get hidden(): HiddenOutlines {
    return this.hiddenLines;
  }

  set hidden(value: HiddenOutlines) {
    this.hiddenLines = checkHidden(value, 'HatchingOutlineMaterial');
  }

  override copy(source: this): this {
    // ShaderMaterial.copy would clone every texture among the uniforms, and each clone would be uploaded again.
    Material.prototype.copy.call(this, source);
    this.fog = source.fog;
    this.lights = source.lights;
    this.clipping = source.clipping;
    for (const name of OUTLINE_NUMBER_NAMES) this[name] = source[name];
    this.ink.copy(source.ink);
    Object.assign(this.weights, source.weights);
    this.hidden = source.hidden;
    this.intersections = source.intersections;
    return this;
  }

  /**
   * Writes the properties to the uniforms.
   *
   * @param pixelRatio pixels of the render target, the unit of the shaders, per CSS pixel
   * @internal
   */
  writeUniforms(isDeformed: boolean, hasMaterials: boolean, pixelRatio = 1): void {
    writeOutlineLook(this, this.uniforms, pixelRatio);
    if (this.paperGrain > 0) this.uniforms.toothMap.value = toothMap();
    this.writeMesh(isDeformed, hasMaterials);
    this.uniformsNeedUpdate = true;
  }

  /**
   * Writes the uniforms for the outlines of one mesh: those of the frame if these outlines are the first in it, and those of the mesh.
   * Allocates nothing.
   *
   * @param viewport the part of the render target that the camera draws into, in pixels
   * @param look the material that decides where the outlines fade
   * @internal
   */
  writeDraw(
    renderer: WebGLRenderer,
    camera: Camera,
    mesh: Mesh,
    viewport: Vector4,
    look: (Material & FadingLook) | null,
    isDeformed: boolean,
  ): void {
    const u = this.uniforms;
    const hasMaterials = Array.isArray(mesh.material);
    const lookId = look?.id ?? NO_LOOK;
    const isSame =
      !this.ofMesh.isAllWanted &&
      this.written.isOf(renderer, camera) &&
      lookId === this.writtenLook &&
      viewport.equals(u.viewport.value as Vector4);
    if (isSame) {
      this.writeMesh(isDeformed, hasMaterials);
      this.ofMesh.want(renderer);
    } else {
      this.written.note(renderer, camera);
      this.writtenLook = lookId;
      (u.viewport.value as Vector4).copy(viewport);
      this.writeUniforms(isDeformed, hasMaterials, renderer.getPixelRatio());
      u.nearDistance.value = (camera as PerspectiveCamera).near ?? 0;
      writeFading(look, u, renderer, camera);
      writeSheet(u.sheet.value, camera, viewport, u.toothOffset.value);
    }
    writeImportance(mesh, takesWeight(look), u);
    writeDrawState(this, u);
  }

  private writeMesh(isDeformed: boolean, hasMaterials: boolean): void {
    // If all groups have the same material, there are no borders between materials.
    this.uniforms.materialBorders.value = hasMaterials ? this.weights.materialBorders : 0;
    this.setDefine('DEFORMED', isDeformed);
  }

  private setDefine(name: string, isSet: boolean): void {
    if (isSet === name in this.defines) return;
    if (isSet) this.defines[name] = '';
    else delete this.defines[name];
    this.needsUpdate = true;
  }
}
