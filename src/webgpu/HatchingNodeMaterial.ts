import {
  type Camera,
  type Color,
  type IUniform,
  type Light,
  Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type Scene,
  type Vector2,
  type Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import {
  EnvironmentNode,
  Node,
  type NodeBuilder,
  type NodeFrame,
  NodeMaterial,
  type WebGPURenderer,
} from 'three/webgpu';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type PropertyNameOf,
  type ToneModel,
} from '../look/hatchingProperties.js';
import { isMirror } from '../look/mirrors.js';
import type { PresetName } from '../look/presetMaterials.js';
import { defaultOf, spelledOut } from '../look/presetParameters.js';
import { formOf, needsAdjacency, needsMap, resolveLook, runsAway, usesThresholds } from '../look/queries.js';
import { checkChoice, checkHand } from '../material/checkProperty.js';
import { checkValues, type HatchingMaterialParameters } from '../material/checkValues.js';
import { FrameStamp } from '../material/FrameStamp.js';
import { takesWeight, writeFading, writeImportance } from '../material/fading/fading.js';
import { fittedCurve, type ToneCurve } from '../material/fitToneCurve.js';
import { hasOtherFormAngle, noteFormAngle } from '../material/geometry/formAngles.js';
import { lineContrast } from '../material/geometry/lineFades.js';
import { composedWith, HatchingComposition } from '../material/groups/HatchingComposition.js';
import type { HatchingCompositionOptions, PerTriangleOptions } from '../material/groups/ownedProperties.js';
import { PerTriangle } from '../material/groups/PerTriangle.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { propertiesToJSON } from '../material/hatchingJSON.js';
import {
  createHatchingUniforms,
  writeComputedUniforms,
  writeMapUniforms,
  writePropertyUniforms,
  writeSizeUniforms,
} from '../material/hatchingUniforms.js';
import { fittingMap, mapIsReady, sharedMap } from '../material/mapInUse.js';
import { writeFieldFrame } from '../material/parts/fieldFrame.js';
import { writePartUniforms } from '../material/pictureOffset.js';
import { accessorOf, fieldOf } from '../material/propertyAccessors.js';
import { type HatchingMap, withVectors } from '../material/propertyValues.js';
import { TONE_CURVES } from '../material/shaders/defineNames.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import { writeCurveUniforms } from '../material/toneCurveTable.js';
import type { Hand } from '../strokes/hand/Hand.js';
import { maxTextureSize, warnOnce } from './deviceLimits.js';
import {
  checkStrokes,
  dotLayerOf,
  exposureReady,
  handCodeOf,
  handReady,
  patternReady,
  writeExposure,
  writeHand,
  writePattern,
} from './fetchedCode.js';
import { HatchingLightingModel, type LitSurface, unlitSurface } from './HatchingLightingModel.js';
import { darknessOf, emitVertex } from './hatchSurface.js';
import { lightLuminance, pixelFromBelow } from './nodes/base/maths.js';
import { tsl, type Value } from './nodes/base/values.js';
import { fadingAt } from './nodes/chunks/fading.js';
import { paper, printedColor } from './nodes/chunks/ink.js';
import { openToLights } from './nodes/chunks/occlusion.js';
import { readFaceNormals } from './nodes/chunks/screenGradient.js';
import { filledColor, litTone, localDarkness, shadedTone, unshadowedTone } from './nodes/chunks/tone.js';
import { tonedSurface } from './tonedSurface.js';

const NAME = 'HatchingNodeMaterial';
const propertyNames = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const propertyOf = (name: HatchingPropertyName): HatchingProperty => HATCHING_PROPERTIES[name];

const { diffuseColor, float, materialEmissive, mix, positionLocal, positionView, vec3 } = tsl;

/** Its own matrix: WebGPURenderer does not update `modelViewMatrix` of a mesh. */
const modelView = /* @__PURE__ */ new Matrix4();
const viewport = /* @__PURE__ */ new Vector4();

/** Writes the uniforms of each mesh before nodes read them. Yields the factor 1. All materials share it. */
class MeshValues extends Node {
  constructor() {
    super('float');
    this.updateBeforeType = 'object';
  }

  override setup(): Node {
    return float(1) as unknown as Node;
  }

  override updateBefore({ material, object, renderer, scene, camera }: NodeFrame): undefined {
    if (material instanceof HatchingNodeMaterial && renderer && scene && camera)
      material.writeDraw(renderer as unknown as WebGPURenderer, scene, camera, object as Mesh);
  }
}

const meshValues = /* @__PURE__ */ new MeshValues();

export interface HatchingNodeMaterial
  extends Pick<HatchingMaterialProperties, Exclude<PropertyNameOf<undefined>, 'hand' | 'toneCurve'>> {}

/**
 * `HatchingMaterial` for WebGPURenderer, experimental: the same properties with the same names, defaults and checks. It draws the
 * techniques but `triangle` and `adjacency`. A choice that it cannot draw yet is replaced by the nearest one, with one warning
 * (docs/support.md).
 */
export class HatchingNodeMaterial extends NodeMaterial {
  readonly isHatchingNodeMaterial = true;
  /** Code that reads the properties of a `HatchingMaterial`, such as vector drawing, accepts this material too. */
  readonly isHatchingMaterial = true;
  /** The uniforms that nodes read, named as in GLSL. @internal */
  readonly uniforms: Record<string, IUniform>;
  /** three.js watches only materials that have a node as a property. @internal */
  readonly meshValues: Node = meshValues;
  /** Null, since three.js reads `envMap` of every material: the scene's environment is used, with the scene's rotation. @internal */
  readonly envMap: null = null;
  protected focused: Vector3 | null = null;
  protected chosenMap: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  protected chosenHand: Hand | null = null;
  protected numbers = new Map<HatchingPropertyName, number | 'auto' | 'fit' | null>();
  private readonly chosen: Partial<Record<HatchingPropertyName, string | boolean>> = {
    technique: HATCHING_DEFAULTS.technique,
  };
  private composed = new HatchingComposition();
  private readonly ofTriangles = new PerTriangle(() => {});
  private curve: ToneCurve | undefined;
  /** The curve that was written last. */
  private writtenCurve: ToneCurve | undefined;
  /** The frame in which the uniforms were last written. */
  private readonly written = new FrameStamp();
  /** Whether the nodes were built for metal that mirrors the room. */
  private isBuiltAsMirror = false;
  /** Rebuilds the nodes. */
  private readonly renew = (): void => {
    this.needsUpdate = true;
  };

  static override get type(): string {
    return NAME;
  }

  /** @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range */
  constructor(parameters: HatchingMaterialParameters | undefined = undefined) {
    super();
    this.uniforms = { ...createHatchingUniforms(), viewToObject: { value: new Matrix3() } };
    for (const name of propertyNames) {
      if (propertyOf(name).owner !== undefined) continue;
      const field = fieldOf(name);
      if (field !== undefined) Object.assign(this, { [name]: field });
      else if (!(name in this)) Object.defineProperty(HatchingNodeMaterial.prototype, name, accessorOf(name));
    }
    this.lights = true;
    this.fog = true;
    this.toneMapped = false;
    this.setValues(parameters);
  }

  /** Whether the material shows the shadows that fall on it, and nothing else, as `HatchingShadowNodeMaterial` does. */
  get isHatchingShadowMaterial(): boolean {
    return false;
  }

  /** What counts for a whole picture, as in `HatchingMaterial`. */
  get composition(): HatchingComposition {
    return this.composed;
  }

  set composition(value: HatchingComposition | Partial<HatchingCompositionOptions>) {
    this.composed = composedWith(this.composed, value);
  }

  /** What only techniques without nodes read, as in `HatchingMaterial`. */
  get perTriangle(): PerTriangle {
    return this.ofTriangles;
  }

  set perTriangle(value: Partial<PerTriangleOptions>) {
    this.ofTriangles.setValues(value);
  }

  get hand(): Hand | null {
    return this.chosenHand;
  }

  set hand(value: Hand | null) {
    checkHand(value);
    if (value) checkStrokes(value);
    const isOther = (value === null) !== (this.chosenHand === null);
    this.chosenHand = value;
    // All hands are drawn by the same nodes.
    if (isOther) this.needsUpdate = true;
  }

  get toneCurve(): ToneCurve {
    return this.curve ?? (defaultOf('toneCurve', this.technique) as ToneCurve);
  }

  set toneCurve(value: ToneCurve) {
    fittedCurve(value);
    this.curve = value;
    this.writtenCurve = undefined;
    this.needsUpdate = true;
  }

  /**
   * Sets properties by name, as three's own.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  override setValues(values?: HatchingMaterialParameters): void {
    if (!values) return;
    const parameters = spelledOut(values);
    checkValues(parameters);
    super.setValues(withVectors(parameters));
  }

  /**
   * Resolves when everything the material draws with is loaded: its tonal art map, the pattern of its technique, the code that draws its hand,
   * and that which fits the exposure. These are fetched when a material first needs them; until then strokes are missing, or those of a pen in
   * place of a hand's, and the exposure is 1. For a page that renders only on changes: `material.ready.then(render)`. Rejects if one of them
   * cannot be loaded; reading it again tries again.
   */
  get ready(): Promise<void> {
    const map = mapIsReady(needsMap(this) ? this.tonalArtMap : null);
    const exposed = exposureReady(this.look);
    return Promise.all([map, patternReady(this), handReady(this), exposed]).then(() => {});
  }

  /** Sets all properties of a preset. Properties that only other presets set get their defaults. */
  set preset(name: PresetName) {
    this.setValues({ preset: name });
  }

  override copy(source: this): this {
    // NodeMaterial.copy would share the uniforms.
    Material.prototype.copy.call(this, source);
    this.fog = source.fog;
    this.lights = source.lights;
    for (const name of Object.keys(this.chosen)) delete this.chosen[name as HatchingPropertyName];
    Object.assign(this.chosen, source.chosen);
    for (const name of propertyNames) {
      const { kind, owner } = propertyOf(name);
      if (owner !== undefined) continue;
      const own = name as PropertyNameOf<undefined>;
      if (kind === 'color') (this[own] as Color).copy(source[own] as Color);
      else if (kind === 'vector2') (this[own] as Vector2).copy(source[own] as Vector2);
      else if (kind === 'texture' || kind === 'tonalArtMap' || kind === 'hand')
        Object.assign(this, { [own]: source[own] });
    }
    this.composed = source.composed;
    this.ofTriangles.setValues(source.ofTriangles);
    this.curve = source.curve;
    this.numbers = new Map(source.numbers);
    return this;
  }

  override toJSON(meta?: Parameters<Material['toJSON']>[0]): ReturnType<Material['toJSON']> {
    const json = Material.prototype.toJSON.call(this, meta);
    return Object.assign(json, propertiesToJSON(this.look));
  }

  /** Reports an error if the renderer is not WebGPURenderer. @internal */
  override onBeforeRender(renderer: WebGLRenderer | WebGPURenderer): void {
    if (!('isWebGLRenderer' in renderer)) return;
    warnOnce(
      "WebGLRenderer draws no node materials. Use WebGPURenderer of 'three/webgpu', or HatchingMaterial of 'three-hatching'.",
    );
  }

  /** Names the choices that the program depends on. */
  override customProgramCacheKey(): string {
    const { inkBlend, toneNormal } = this;
    const curve = curveOf(this.toneCurve);
    return [
      ...choicesOf(this),
      Number(this.screenSpaceShare > 0),
      Number(isMirror(this)),
      this.strokeAnchor,
      this.drawnToneModel,
      toneNormal,
      Number(runsAway(this)),
      curve,
      inkBlend,
      Number(dotLayerOf(this) !== undefined),
      Number(handCodeOf(this) !== undefined),
    ].join(' ');
  }

  /** Writes the material's uniforms once a frame, and those of the mesh at every draw. Allocates nothing. @internal */
  writeDraw(renderer: WebGPURenderer, scene: Scene, camera: Camera, mesh: Mesh): void {
    const u = this.uniforms;
    const { look } = this;
    // The functions below use only features of both renderers.
    const asked = renderer as unknown as WebGLRenderer;
    if (!this.written.isOf(asked, camera)) {
      this.written.note(asked, camera);
      this.writeFrame(look, asked, scene, camera);
    }
    writeImportance(mesh, takesWeight(look), u);
    u.lineContrast.value = lineContrast(mesh.geometry);
    writeFieldFrame(u, this.tilesPerObjectUnit, mesh.geometry, mesh);
    if (hasOtherFormAngle(mesh.geometry, this) && formOf(this)) noteFormAngle(mesh.geometry, this);
    modelView.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld);
    (u.viewToObject.value as Matrix3).getNormalMatrix(modelView).transpose();
  }

  private writeFrame(look: HatchingMaterialProperties, renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    const u = this.uniforms;
    const pixelRatio = renderer.getPixelRatio();
    writePropertyUniforms(look, u);
    if (isMirror(look) !== this.isBuiltAsMirror) this.renew();
    const chosen = this.mapInUse();
    const map = fittingMap(chosen, true, maxTextureSize(renderer as unknown as WebGPURenderer));
    writeSizeUniforms(look, chosen, pixelRatio, u);
    writeMapUniforms(map, usesThresholds(this), u);
    const hasPattern = writePattern(this, u, this.renew);
    u.inked.value = Number(hasPattern && (map !== null || !needsMap(this)));
    this.writeCurve();
    writeComputedUniforms(look, u);
    writeHand(look, pixelRatio, u, this.renew);
    writeFading(look, u, renderer, camera);
    writeExposure(look, renderer, scene, camera, u);
    const target = renderer.getRenderTarget();
    if (target) viewport.copy(target.viewport);
    else renderer.getViewport(viewport).multiplyScalar(pixelRatio);
    writePartUniforms(camera, viewport, u);
  }

  /** Writes the tone curve, once after it was set. */
  private writeCurve(): void {
    const { toneCurve } = this;
    if (toneCurve === this.writtenCurve) return;
    writeCurveUniforms(toneCurve, this.uniforms);
    this.writtenCurve = toneCurve;
  }

  override dispose(): void {
    super.dispose();
    this.uniforms.toneCurveTable.value?.dispose();
  }

  /** Builds nodes for the current choices. @internal */
  override setup(builder: NodeBuilder): void {
    this.writeCurve();
    this.isBuiltAsMirror = isMirror(this);
    super.setup(builder);
  }

  /** Positions the vertex as three.js' materials do, and writes the varyings of strokes. @internal */
  override setupPosition(builder: NodeBuilder): ReturnType<NodeMaterial['setupPosition']> {
    emitVertex(this.look, builder);
    return positionLocal as unknown as ReturnType<NodeMaterial['setupPosition']>;
  }

  /** @internal */
  override setupLighting(builder: NodeBuilder): ReturnType<NodeMaterial['setupLighting']> {
    this.warnOfMissing();
    const emissive = this.emissive;
    // `emissive` counts as light, so three.js must not add it to the print.
    Object.assign(this, { emissive: null });
    try {
      return super.setupLighting(builder);
    } finally {
      Object.assign(this, { emissive });
    }
  }

  /** The light of the environment. @internal */
  override setupEnvironment(builder: NodeBuilder): ReturnType<NodeMaterial['setupEnvironment']> {
    const { environmentNode } = builder as NodeBuilder & { environmentNode: Node | null };
    const around = super.setupEnvironment(builder) ?? environmentNode;
    return around && (new EnvironmentNode(around) as unknown as ReturnType<NodeMaterial['setupEnvironment']>);
  }

  /** The normal that tone is computed from. @internal */
  override setupNormal(): ReturnType<NodeMaterial['setupNormal']> {
    if (this.toneNormal !== 'face') return super.setupNormal();
    return readFaceNormals() as unknown as ReturnType<NodeMaterial['setupNormal']>;
  }

  /** @internal */
  override setupLightingModel(builder?: NodeBuilder): HatchingLightingModel {
    const built = builder as NodeBuilder & { lightsNode: { getLights(): Light[] } };
    const lights = built.lightsNode.getLights();
    const { look, drawnToneModel: toneModel } = this;
    const { shadowStrokes } = resolveLook(look, false);
    const endsStrokes = handCodeOf(look) !== undefined && shadowStrokes !== 'reorient' && toneModel !== 'shadow';
    const choices = { toneModel, shadowStrokes, endsStrokes };
    return new HatchingLightingModel(choices, lights, (surface) => this.print(surface, built));
  }

  /** Prints surfaces without any light; three.js builds its lighting model only where there are lights. @internal */
  override setupOutgoingLight(): ReturnType<NodeMaterial['setupOutgoingLight']> {
    const printed = tsl.Fn((builder) => this.print(unlitSurface(), builder))();
    return printed as unknown as ReturnType<NodeMaterial['setupOutgoingLight']>;
  }

  /** @internal */
  choice(name: HatchingPropertyName): string | boolean {
    return this.chosen[name] ?? (defaultOf(name, this.technique) as string | boolean);
  }

  /** @internal */
  choose(name: HatchingPropertyName, value: string | boolean): void {
    checkChoice(name, value);
    if (name === 'debugView' && value !== 'none') warnOnce('there are no nodes of debugView; the hatching is drawn.');
    const property = propertyOf(name);
    const chosen = value === 'auto' && property.kind === 'choice' && property.defaultFor ? undefined : value;
    if (chosen === this.chosen[name]) return;
    if (chosen === undefined) delete this.chosen[name];
    else this.chosen[name] = chosen;
    this.needsUpdate = true;
  }

  private get look(): HatchingMaterialProperties {
    return this as unknown as HatchingMaterialProperties;
  }

  private get drawnToneModel(): ToneModel | 'shadow' {
    return this.isHatchingShadowMaterial ? 'shadow' : this.toneModel;
  }

  /** The current tonal art map, if it is loaded. The map of a style is requested when it is first drawn with. */
  private mapInUse(): TonalArtMap | null {
    const { tonalArtMap } = this;
    if (!needsMap(this)) return null;
    return typeof tonalArtMap === 'string' ? sharedMap(tonalArtMap) : tonalArtMap;
  }

  private warnOfMissing(): void {
    const { technique } = this;
    if (needsAdjacency(this)) warnOnce(`there are no nodes of the technique "${technique}" yet; "engraving" is drawn.`);
  }

  private print(lit: LitSurface, builder: NodeBuilder): Value {
    const { material } = builder;
    const { look, technique, drawnToneModel: toneModel } = this;
    const emitted = materialEmissive;
    const radiance = lit.radiance.add(lightLuminance(emitted)).toVar();
    const castShadows = handCodeOf(look)?.castShadowsOf(lit.receivedShadows);
    const surface = { ...lit, castShadows, radiance, darkness: localDarkness(tonedSurface(builder), emitted) };
    const rules = { toneModel, curve: curveOf(this.toneCurve), isMirror: isMirror(look) };
    const fading = fadingAt(positionView, pixelFromBelow()).toVar();
    const toneOf = (light: Value): Value => litTone(light, surface, rules);
    const tones = castShadows?.tonesOf(radiance, openToLights(), toneOf);
    const tone = (tones ?? shadedTone(surface, rules)).mul(fading).toVar();
    // Dots cannot cross one another: two sets of them would clump.
    const crosses = lit.shadowed && resolveLook(look, false).shadowStrokes === 'cross' && technique !== 'stipple';
    const unshadowed = crosses ? unshadowedTone(surface, rules).mul(fading).toVar() : null;
    const color = mix(vec3(1), filledColor(diffuseColor.xyz), fading);
    const isOpaque = !(material as Material).transparent;
    const ground = paper.mul(color).toVar();
    const printed = printedColor(
      ground,
      darknessOf(look, surface, { tone, unshadowed }, builder)
        .mul(meshValues as unknown as Value)
        .toVar(),
      this.inkBlend === 'multiply',
      isOpaque,
    ).toVar();
    if (!isOpaque) diffuseColor.w.mulAssign(printed.w);
    return printed.xyz;
  }
}

/** The index of the kind of a tone curve: all but these two are read from points. */
const curveOf = (curve: ToneCurve): number =>
  TONE_CURVES.indexOf(curve === 'linear' || curve === 'perceptual' ? curve : 'points');

/** The choices that nodes are built for, with what follows from them. */
const choicesOf = ({ technique, direction, strokeLayers, shadowStrokes }: HatchingNodeMaterial): string[] => [
  ...[NAME, technique, direction, strokeLayers, shadowStrokes],
];
