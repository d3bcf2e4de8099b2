import {
  type BufferGeometry,
  type Camera,
  type Color,
  type IUniform,
  type Light,
  Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type Vector2,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { Node, type NodeBuilder, type NodeFrame, NodeMaterial, type WebGPURenderer } from 'three/webgpu';
import { lineContrast } from '../geometry/lineFades.js';
import type { HatchingMap } from '../material/checkTonalArtMap.js';
import { checkChoice, checkValues } from '../material/checkValues.js';
import { takesWeight, writeEmphasis, writeImportance } from '../material/emphasis/emphasis.js';
import type { SceneExtent } from '../material/emphasis/SceneExtent.js';
import { writeSheet } from '../material/emphasis/writeSheet.js';
import { defaultOf } from '../material/facts/defaultOf.js';
import type { HatchingProperty } from '../material/facts/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
} from '../material/facts/hatchingProperties.js';
import { formOf } from '../material/facts/lookFacts.js';
import type { PresetName } from '../material/facts/presetMaterials.js';
import { spelledOut } from '../material/facts/presetParameters.js';
import { fittedCurve, type ToneCurve } from '../material/fitToneCurve.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { HatchingMaterialProperties } from '../material/HatchingMaterialProperties.js';
import { propertiesToJSON } from '../material/hatchingJSON.js';
import {
  createHatchingUniforms,
  writeComputedUniforms,
  writeCurveUniforms,
  writePropertyUniforms,
  writeSizeUniforms,
} from '../material/hatchingUniforms.js';
import { writeFieldFrame } from '../material/parts/fieldFrame.js';
import { withoutForm } from '../material/programDefines.js';
import { accessorOf, fieldOf } from '../material/propertyAccessors.js';
import { TONE_CURVES } from '../material/shaders/shaderConventions.js';
import { withVectors } from '../material/vectorValues.js';
import { tell } from '../mistakes/tell.js';
import { HatchingLightingModel } from './HatchingLightingModel.js';
import { emphasisAt } from './nodes/chunks/emphasis.js';
import { lightLuminance } from './nodes/chunks/lightLuminance.js';
import { filledColor, localDarkness } from './nodes/chunks/localColor.js';
import { paper, printedColor } from './nodes/chunks/printedColor.js';
import { shadedTone } from './nodes/chunks/tone.js';
import { firstField } from './nodes/techniques/engraved/fieldAxis.js';
import { hatchLayer, readHatchingParameters } from './nodes/techniques/engraved/hatchLayer.js';
import { fieldLight } from './nodes/techniques/engraved/lightField.js';
import { hatchingUniform } from './nodes/uniforms.js';
import { tsl, type Value } from './nodes/values.js';

const NAME = 'HatchingNodeMaterial';
const propertyNames = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const propertyOf = (name: HatchingPropertyName): HatchingProperty => HATCHING_PROPERTIES[name];

const { diffuseColor, float, materialEmissive, mix, modelViewMatrix, normalGeometry, positionGeometry } = tsl;
const { positionView, screenCoordinate, screenSize, varying, vec2, vec3, vec4 } = tsl;
const fieldOrigin = /* @__PURE__ */ hatchingUniform('fieldOrigin', 'vec3');
const objectToField = /* @__PURE__ */ hatchingUniform('objectToField', 'mat3');
const objectToFieldNormal = /* @__PURE__ */ hatchingUniform('objectToFieldNormal', 'mat3');

const told = new Set<string>();

function tellOnce(sentence: string): void {
  if (told.has(sentence)) return;
  told.add(sentence);
  tell(`${NAME}: ${sentence}`);
}

/** Of its own: WebGPURenderer leaves that of a mesh as it is. */
const modelView = /* @__PURE__ */ new Matrix4();
const turned = /* @__PURE__ */ new Matrix3();
const viewport = /* @__PURE__ */ new Vector4();

/** Writes what each mesh is drawn with, before nodes read it. The factor 1, which all materials share. */
class MeshValues extends Node {
  constructor() {
    super('float');
    this.updateBeforeType = 'object';
  }

  override setup(): Node {
    return float(1) as unknown as Node;
  }

  override updateBefore({ material, object, renderer, camera }: NodeFrame): undefined {
    if (material instanceof HatchingNodeMaterial && renderer && camera)
      material.writeDraw(renderer as unknown as WebGPURenderer, camera, object as Mesh);
  }
}

const meshValues = /* @__PURE__ */ new MeshValues();

export interface HatchingNodeMaterial extends Pick<HatchingMaterialProperties, HatchingPropertyName> {}

/**
 * `HatchingMaterial` for WebGPURenderer, experimental: the same properties with the same names, defaults and checks. It draws the technique
 * `engraved` with lines of ink that a light or an axis cuts. What it does not draw yet it says once, and takes what comes nearest.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export class HatchingNodeMaterial extends NodeMaterial {
  readonly isHatchingNodeMaterial = true;
  /** What nodes read, as programs in GLSL do. @internal */
  readonly uniforms: Record<string, IUniform>;
  /** three.js looks for changes only in materials that have a node. @internal */
  readonly meshValues: Node = meshValues;
  /** How far the scene reaches, by which `depthFade` measures depth. Without one its units are those of the world, from the eye. Default: null. */
  extent: SceneExtent | null = null;

  protected focused: HatchingMaterialProperties['focus'] = null;
  protected hatchImages: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  protected numbers = new Map<HatchingPropertyName, number | 'auto' | null>();
  private readonly chosen: Partial<Record<HatchingPropertyName, string | boolean>> = {
    technique: HATCHING_DEFAULTS.technique,
  };
  private curve: ToneCurve | undefined;

  static override get type(): string {
    return NAME;
  }

  /** @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range */
  constructor(parameters: HatchingMaterialParameters | undefined = undefined) {
    super();
    this.uniforms = { ...createHatchingUniforms(), viewToField: { value: new Matrix3() } };
    for (const name of propertyNames) {
      const field = fieldOf(name);
      if (field !== undefined) Object.assign(this, { [name]: field });
      else if (!(name in this)) Object.defineProperty(HatchingNodeMaterial.prototype, name, accessorOf(name));
    }
    this.lights = true;
    this.fog = true;
    this.toneMapped = false;
    this.setValues(parameters);
  }

  get toneCurve(): ToneCurve {
    return this.curve ?? (defaultOf('toneCurve', this.technique) as ToneCurve);
  }

  set toneCurve(value: ToneCurve) {
    fittedCurve(value);
    this.curve = value;
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

  /** Sets all that a preset names, and gives what only other presets name its default. */
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
      const { kind } = propertyOf(name);
      if (kind === 'color') (this[name] as Color).copy(source[name] as Color);
      else if (kind === 'vector2') (this[name] as Vector2).copy(source[name] as Vector2);
      else if (kind === 'texture' || kind === 'tonalArtMap') Object.assign(this, { [name]: source[name] });
    }
    this.curve = source.curve;
    this.numbers = new Map(source.numbers);
    this.focused = source.focused?.clone() ?? null;
    this.extent = source.extent;
    return this;
  }

  override toJSON(meta?: Parameters<Material['toJSON']>[0]): ReturnType<Material['toJSON']> {
    const json = Material.prototype.toJSON.call(this, meta);
    return Object.assign(json, propertiesToJSON(this as unknown as HatchingMaterialProperties));
  }

  /** What chooses the program. */
  override customProgramCacheKey(): string {
    const { inkBlend, toneModel } = this;
    const curve = curveOf(this.toneCurve);
    return [NAME, this.lineFieldInUse(), toneModel, curve, inkBlend].join(' ');
  }

  /** Writes the properties, and what is of the mesh, to the uniforms. @internal */
  writeDraw(renderer: WebGPURenderer, camera: Camera, mesh: Mesh): void {
    const u = this.uniforms;
    const look = this as unknown as HatchingMaterialProperties & { extent: SceneExtent | null };
    writePropertyUniforms(look, u);
    writeSizeUniforms(look, null, renderer.getPixelRatio(), u);
    writeCurveUniforms(this.toneCurve, u);
    writeComputedUniforms(look, u);
    // What it asks of a renderer, both kinds have.
    writeEmphasis(look, u, renderer as unknown as WebGLRenderer, camera);
    const target = renderer.getRenderTarget();
    if (target) viewport.copy(target.viewport);
    else renderer.getViewport(viewport).multiplyScalar(renderer.getPixelRatio());
    u.viewportHeight.value = viewport.w;
    writeSheet(u.sheet.value, camera, viewport);
    writeImportance(mesh, takesWeight(look), u);
    u.lineContrast.value = lineContrast(mesh.geometry);
    writeFieldFrame(u, this.tilesPerUnit, mesh.geometry, mesh);
    turned.getNormalMatrix(modelView.multiplyMatrices(camera.matrixWorldInverse, mesh.matrixWorld)).transpose();
    (u.viewToField.value as Matrix3).multiplyMatrices(u.objectToField.value, turned);
  }

  /** Nodes are made for the values that they find. @internal */
  override setup(builder: NodeBuilder): void {
    writeCurveUniforms(this.toneCurve, this.uniforms);
    super.setup(builder);
  }

  /** @internal */
  override setupLighting(builder: NodeBuilder): ReturnType<NodeMaterial['setupLighting']> {
    this.tellOfLacks(builder.object as Mesh);
    const emissive = this.emissive;
    // The light of the surface itself is light too, and not added to the print.
    Object.assign(this, { emissive: null });
    try {
      return super.setupLighting(builder);
    } finally {
      Object.assign(this, { emissive });
    }
  }

  /** @internal */
  override setupLightingModel(builder?: NodeBuilder): HatchingLightingModel {
    const built = builder as NodeBuilder & { lightsNode: { getLights(): Light[] } };
    const lights = built.lightsNode.getLights();
    return new HatchingLightingModel(this.toneModel, lights, (radiance) => this.print(radiance, lights, built));
  }

  /** Where there is no light at all. @internal */
  override setupOutgoingLight(builder?: NodeBuilder): ReturnType<NodeMaterial['setupOutgoingLight']> {
    const printed = builder ? this.print(float(0).toVar(), [], builder) : vec3(0);
    return printed as unknown as ReturnType<NodeMaterial['setupOutgoingLight']>;
  }

  /** @internal */
  choice(name: HatchingPropertyName): string | boolean {
    return this.chosen[name] ?? (defaultOf(name, this.technique) as string | boolean);
  }

  /** @internal */
  choose(name: HatchingPropertyName, value: string | boolean): void {
    checkChoice(name, value);
    const property = propertyOf(name);
    const chosen = value === 'auto' && property.kind === 'choice' && property.defaultFor ? undefined : value;
    if (chosen === this.chosen[name]) return;
    if (chosen === undefined) delete this.chosen[name];
    else this.chosen[name] = chosen;
    this.needsUpdate = true;
  }

  private lineFieldInUse(): string {
    return formOf(this) === false && this.lineField !== 'auto' ? this.lineField : withoutForm(this);
  }

  private tellOfLacks({ isSkinnedMesh, isInstancedMesh, isBatchedMesh, morphTargetInfluences }: LackingMesh): void {
    const { technique, medium, toneModel, shadowStrokes, exposure } = this;
    if (technique !== 'engraved')
      tellOnce(`there are no nodes of the technique "${technique}" yet; "engraved" is drawn.`);
    if (medium === 'pen' || medium === 'woodcut' || medium === 'stipple' || medium === 'dry')
      tellOnce(`there are no nodes of the medium "${medium}" yet; lines of ink are drawn.`);
    if (toneModel === 'shadow') tellOnce('there are no nodes of the tone model "shadow" yet; all tones are drawn.');
    if (shadowStrokes !== 'tone') tellOnce(`shadowStrokes "${shadowStrokes}" is not drawn by nodes yet.`);
    if (formOf(this) === true) tellOnce('there are no nodes of lines that follow the form yet.');
    if (exposure === 'auto') tellOnce('an exposure that is fitted to the scene is not known to nodes yet; it is 1.');
    if (isSkinnedMesh || isInstancedMesh || isBatchedMesh || morphTargetInfluences)
      tellOnce('lines on instances, skins and morph targets are not yet spaced as those of other meshes.');
  }

  private print(light: Value, lights: readonly Light[], { geometry, material }: NodeBuilder): Value {
    const emitted = materialEmissive;
    const radiance = light.add(lightLuminance(emitted));
    const curve = curveOf(this.toneCurve);
    const fromBelow = vec2(screenCoordinate.x, screenSize.y.sub(screenCoordinate.y));
    const emphasis = emphasisAt(positionView, fromBelow).toVar();
    const darkness = localDarkness(diffuseColor.xyz, emitted);
    const tone = shadedTone(radiance, darkness, curve, this.toneModel === 'toon')
      .mul(emphasis)
      .toVar();
    const normal = (geometry as BufferGeometry).hasAttribute('hatchNormal') ? hatchNormal() : normalGeometry;
    const place = varying(objectToField.mul(positionGeometry.sub(fieldOrigin)) as never).toVar();
    const fieldNormal = varying(objectToFieldNormal.mul(normal) as never);
    const lineField = this.lineFieldInUse();
    const turns = lineField === 'light' || lineField === 'towards';
    const field = tsl.Fn(() =>
      firstField(
        turns ? fieldLight(modelViewMatrix.mul(vec4(fieldOrigin, 1)).xyz, lights).toVar() : vec4(0, 1, 0, 0),
        lineField,
      ),
    )();
    const parameters = readHatchingParameters(varying(field as never).toVar(), place, fieldNormal);
    const color = mix(vec3(1), filledColor(diffuseColor.xyz), emphasis);
    const isOpaque = !(material as Material).transparent;
    const ground = paper.mul(color).toVar();
    const printed = printedColor(
      ground,
      hatchLayer(parameters, tone).mul(meshValues as unknown as Value),
      this.inkBlend === 'multiply',
      isOpaque,
    ).toVar();
    if (!isOpaque) diffuseColor.w.mulAssign(printed.w);
    return printed.xyz;
  }
}

/** The number of its kind: shaders know any curve but these two by its points. */
const curveOf = (curve: ToneCurve): number =>
  TONE_CURVES.indexOf(curve === 'linear' || curve === 'perceptual' ? curve : 'points');

interface LackingMesh {
  readonly isSkinnedMesh?: boolean;
  readonly isInstancedMesh?: boolean;
  readonly isBatchedMesh?: boolean;
  readonly morphTargetInfluences?: readonly number[] | undefined;
}

/** The normal at the scale of a stroke; that of the surface where the geometry has a blank one. */
function hatchNormal(): Value {
  const attribute = (tsl.attribute as unknown as (name: string, type: string) => Value)('hatchNormal', 'vec4').xyz;
  return tsl.select(tsl.dot(attribute, attribute).greaterThan(0.25), attribute, normalGeometry);
}
