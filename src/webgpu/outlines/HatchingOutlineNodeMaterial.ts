import {
  type Camera,
  Color,
  DoubleSide,
  type IUniform,
  Material,
  type MaterialParameters,
  type Mesh,
  NormalBlending,
  type PerspectiveCamera,
  type RGB,
  SRGBColorSpace,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { type NodeBuilder, NodeMaterial, type WebGPURenderer } from 'three/webgpu';
import type { HiddenOutlines } from '../../look/hiddenOutlines.js';
import { checkColor } from '../../material/checkProperty.js';
import { type FadingLook, takesWeight, writeFading, writeImportance } from '../../material/fading/fading.js';
import type {
  HatchingOutlineMaterial,
  HatchingOutlineParameters,
} from '../../material/outlines/HatchingOutlineMaterial.js';
import { setWeights } from '../../material/outlines/OutlineWeights.js';
import {
  HATCHING_OUTLINE_DEFAULTS,
  OUTLINE_NUMBER_NAMES,
  type OutlineNumberName,
} from '../../material/outlines/outlineProperties.js';
import {
  checkHidden,
  createOutlineUniforms,
  defineIntersections,
  defineOutlineNumbers,
  defineOutlineWeights,
  writeOutlineLook,
} from '../../material/outlines/outlineUniforms.js';
import { copyDrawState, writeDrawState } from '../../material/outlines/surfaceRules.js';
import { writeSheet } from '../../material/pictureOffset.js';
import { toothMap } from '../../material/tam/toothMap.js';
import { tsl } from '../nodes/base/values.js';
import type { OutlineDefines } from '../nodes/outlines/fragments.js';
import { clipSpine, type OutlineNodes, outlineNodes } from '../nodes/outlines/outlineNodes.js';

const NAME = 'HatchingOutlineNodeMaterial';

/** Ink and paper of less contrast, out of 1, are blended as three.js does. */
const LEAST_CONTRAST = 0.02;

const encoded: RGB = { r: 0, g: 0, b: 0 };
const grey = /* @__PURE__ */ new Color();

/** The light of a grey in sRGB. */
const lightOf = (value: number): number => grey.setRGB(value, value, value, SRGBColorSpace).r;

/** The mean of the channels of a colour in sRGB. */
function greyOf(color: Color): number {
  color.getRGB(encoded, SRGBColorSpace);
  return (encoded.r + encoded.g + encoded.b) / 3;
}

/**
 * Writes what shaders compute opacities for a canvas from: the greys of paper and ink in sRGB, the light of the paper, and one by what the
 * light of the ink differs from it; 0 where they differ too little.
 *
 * @param paper undefined where it is not known: then it is taken to be white, or black below light ink
 */
function writeCanvasBlend(ink: Color, paper: Color | undefined, uniform: Vector4): void {
  const inkGrey = greyOf(ink);
  const paperGrey = paper ? greyOf(paper) : Number(inkGrey < 0.5);
  const light = lightOf(paperGrey);
  const isClear = Math.abs(inkGrey - paperGrey) > LEAST_CONTRAST;
  uniform.set(paperGrey, inkGrey, light, isClear ? 1 / (lightOf(inkGrey) - light) : 0);
}

/** Makes the nodes of what a material draws. */
export type MakeNodes = (defines: OutlineDefines) => OutlineNodes;

const hiddenNodes: MakeNodes = (defines) => outlineNodes({ ...defines, HIDDEN: true });

export interface HatchingOutlineNodeMaterial
  extends Pick<HatchingOutlineMaterial, OutlineNumberName | 'ink' | 'weights' | 'hidden' | 'intersections'> {}

/**
 * The material of `HatchingOutlines` for WebGPURenderer: the same properties as those of `HatchingOutlineMaterial`, with the same defaults.
 * It uses the lights and the fog of the scene. Every property may be set at any time and takes effect in the next frame; `wobble` and
 * `paperGrain` need another program when they change between 0 and more than 0. Several `HatchingOutlines` may share a material.
 */
export class HatchingOutlineNodeMaterial extends NodeMaterial {
  readonly isHatchingOutlineNodeMaterial = true;
  /** The uniforms that nodes read, named as in GLSL. @internal */
  readonly uniforms: Record<string, IUniform>;

  static override get type(): string {
    return NAME;
  }

  private hiddenLines: HiddenOutlines = HATCHING_OUTLINE_DEFAULTS.hidden;
  private nodes!: OutlineNodes;
  private makeNodes: MakeNodes = outlineNodes;
  /** The materials that draw something else with the same look. */
  private readonly others = new Map<MakeNodes, HatchingOutlineNodeMaterial>();

  /** @throws RangeError if a number is out of its range; TypeError if `ink` is not a colour, or `weights` has an unknown name */
  constructor(parameters: HatchingOutlineParameters | undefined = undefined) {
    super();
    this.uniforms = { ...createOutlineUniforms(), isInstanced: { value: false }, isDeformed: { value: false } };
    this.uniforms.canvasBlend = { value: new Vector4() };
    this.ink = new Color(HATCHING_OUTLINE_DEFAULTS.ink);
    defineOutlineNumbers(this, NAME, (name) => {
      if (name === 'wobble' || name === 'paperGrain') this.chooseNodes();
    });
    defineOutlineWeights(this, NAME);
    defineIntersections(this, NAME);
    Object.defineProperty(this, 'hidden', {
      get: () => this.hiddenLines,
      set: (value: HiddenOutlines) => {
        this.hiddenLines = checkHidden(value, NAME);
      },
      enumerable: true,
    });
    this.lights = true;
    this.transparent = true;
    this.depthWrite = false;
    this.side = DoubleSide;
    // Otherwise three.js would draw each outline twice, backs before fronts.
    this.forceSinglePass = true;
    this.chooseNodes();
    this.setValues(parameters);
    this.writeLook(1);
  }

  /**
   * Sets properties by name, as `setValues` of three.js does.
   *
   * @throws RangeError if a number is out of its range; TypeError if `ink` is not a colour, or `weights` has an unknown name
   */
  override setValues(values?: HatchingOutlineParameters): void {
    if (!values) return;
    if (values.ink !== undefined) checkColor(`${NAME}.ink`, values.ink);
    const { weights, ...others } = values;
    if (weights !== undefined) setWeights(this.weights, weights, NAME);
    super.setValues(others as MaterialParameters);
  }

  override copy(source: this): this {
    // NodeMaterial.copy would share the uniforms.
    Material.prototype.copy.call(this, source);
    this.fog = source.fog;
    this.lights = source.lights;
    for (const name of OUTLINE_NUMBER_NAMES) this[name] = source[name];
    this.ink.copy(source.ink);
    Object.assign(this.weights, source.weights);
    this.hidden = source.hidden;
    this.intersections = source.intersections;
    return this;
  }

  /** The material of hidden outlines, updated. @internal */
  ofHidden(): HatchingOutlineNodeMaterial {
    const hidden = this.drawing(hiddenNodes);
    copyDrawState(this, hidden);
    // Hidden outlines are found per fragment.
    hidden.depthTest = false;
    return hidden;
  }

  /**
   * The material that draws something else with the same look and uniforms, updated.
   *
   * @param more names of uniforms that it has in addition
   * @internal
   */
  drawing(makeNodes: MakeNodes, more: readonly string[] = []): HatchingOutlineNodeMaterial {
    const other = this.others.get(makeNodes) ?? this.makeOther(makeNodes, more);
    other.fog = this.fog;
    other.paperGrain = this.paperGrain;
    other.wobble = this.wobble;
    return other;
  }

  private makeOther(makeNodes: MakeNodes, more: readonly string[]): HatchingOutlineNodeMaterial {
    const made = new HatchingOutlineNodeMaterial();
    made.makeNodes = makeNodes;
    made.chooseNodes();
    const { uniforms } = this;
    const own = Object.fromEntries(more.map((name) => [name, { value: null }]));
    (made as { uniforms: Record<string, IUniform> }).uniforms = more.length === 0 ? uniforms : { ...uniforms, ...own };
    this.others.set(makeNodes, made);
    this.addEventListener('dispose', () => {
      made.dispose();
    });
    return made;
  }

  /** The same for all materials that share a program. */
  override customProgramCacheKey(): string {
    return `${NAME} ${this.nodes.key}`;
  }

  /** Writes the properties to the uniforms. @param pixelRatio device pixels per CSS pixel @internal */
  writeLook(pixelRatio: number): void {
    writeOutlineLook(this, this.uniforms, pixelRatio);
    if (this.paperGrain > 0) this.uniforms.toothMap.value = toothMap();
  }

  /**
   * Writes the uniforms of one mesh.
   *
   * @param viewport the viewport in the render target, pixels from the lower left
   * @param look the fading of the mesh
   * @param isEncodedLater whether colours are blended in linear light, and encoded for a canvas at the end
   * @internal
   */
  writeDraw(
    renderer: WebGPURenderer,
    camera: Camera,
    mesh: Mesh,
    viewport: Vector4,
    look: (Material & FadingLook) | null,
    isEncodedLater: boolean,
  ): void {
    const u = this.uniforms;
    this.writeLook(renderer.getPixelRatio());
    // A mesh with one material has no borders between materials.
    if (!Array.isArray(mesh.material)) u.materialBorders.value = 0;
    (u.viewport.value as Vector4).copy(viewport);
    u.nearDistance.value = (camera as PerspectiveCamera).near ?? 0;
    // The function uses only features of both renderers.
    writeFading(look, u, renderer as unknown as WebGLRenderer, camera);
    writeSheet(u.sheet.value, camera, viewport, u.toothOffset.value);
    writeImportance(mesh, takesWeight(look), u);
    writeDrawState(this, u);
    const { canvasBlend } = u;
    if (!isEncodedLater || this.blending !== NormalBlending) canvasBlend.value.w = 0;
    else writeCanvasBlend(this.ink, (look as { paper?: Color } | null)?.paper, canvasBlend.value);
  }

  /** Fog is that of the spine: the triangle that covers a piece faces the viewer. @internal */
  override setup(builder: NodeBuilder): void {
    const context = builder.context as { getViewZ?: () => OutlineNodes['viewZ'] };
    context.getViewZ = () => this.nodes.viewZ;
    super.setup(builder);
  }

  /** @internal */
  override setupPosition(builder: NodeBuilder): ReturnType<NodeMaterial['setupPosition']> {
    const { vertex, place } = this.nodes;
    if (vertex || !place) return super.setupPosition(builder);
    place(builder);
    return tsl.positionLocal as unknown as ReturnType<NodeMaterial['setupPosition']>;
  }

  /** Depth is that of the spine, as in GLSL. @internal */
  override setupDepth(builder: NodeBuilder): void {
    this.depthNode = builder.renderer.logarithmicDepthBuffer ? this.nodes.logarithmicDepth : null;
    super.setupDepth(builder);
    this.depthNode = null;
  }

  /** Outlines are clipped by their spines. @internal */
  override setupClipping(): ReturnType<NodeMaterial['setupClipping']> {
    return null as unknown as ReturnType<NodeMaterial['setupClipping']>;
  }

  /** @internal */
  override setupHardwareClipping(builder: NodeBuilder): void {
    Object.assign(builder, { hardwareClipping: false });
  }

  /** Outlines have their own colour; lights only affect their width. @internal */
  override setupLighting(builder: NodeBuilder): ReturnType<NodeMaterial['setupLighting']> {
    clipSpine(builder);
    return this.nodes.outgoing;
  }

  private chooseNodes(): void {
    const nodes = this.makeNodes({ HIDDEN: false, PAPER_GRAIN: this.paperGrain > 0, WOBBLE: this.wobble > 0 });
    if (nodes === this.nodes) return;
    this.nodes = nodes;
    // Nodes are shared by all materials, so that they share programs.
    this.vertexNode = nodes.vertex;
    this.colorNode = nodes.color;
    this.needsUpdate = true;
  }
}
