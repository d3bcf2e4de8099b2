import {
  type BufferGeometry,
  type Camera,
  type Color,
  type Group,
  Material,
  type Mesh,
  type NormalMapTypes,
  type Object3D,
  type Scene,
  type ShaderMaterial,
  TangentSpaceNormalMap,
  type Texture,
  Vector4,
  type WebGLProgramParametersWithUniforms,
  type WebGLRenderer,
} from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type PropertyNameOf,
} from '../look/hatchingProperties.js';
import type { PresetName } from '../look/presetMaterials.js';
import { defaultOf, spelledOut } from '../look/presetParameters.js';
import { followsForm, needsMap, usesThresholds } from '../look/queries.js';
import type { Hand } from '../strokes/hand/Hand.js';
import { checkChoice, checkHand } from './checkProperty.js';
import type { HatchingMaterialParameters } from './checkValues.js';
import { checkValues, warnOfUnused } from './checkValues.js';
import { vertexLayoutOf } from './deformation/canDeform.js';
import { silence } from './diagnostics/warn.js';
import { isFitted } from './exposure/ToneFit.js';
import { FrameStamp } from './FrameStamp.js';
import { takesWeight, writeFading, writeImportance } from './fading/fading.js';
import { DrawnMeshes } from './firstDraw/DrawnMeshes.js';
import type { ToneCurve } from './fitToneCurve.js';
import { isFormed } from './geometry/formGeometry.js';
import { composedWith, HatchingComposition } from './groups/HatchingComposition.js';
import type { HatchingCompositionOptions, PerTriangleOptions } from './groups/ownedProperties.js';
import { PerTriangle } from './groups/PerTriangle.js';
import { type HatchingMaterialJSON, propertiesToJSON, setFromJSON } from './hatchingJSON.js';
import {
  createHatchingUniforms,
  MESH_UNIFORMS,
  writeComputedUniforms,
  writeMapUniforms,
  writePropertyUniforms,
  writeSizeUniforms,
} from './hatchingUniforms.js';
import { fittingMap, mapIsReady, sharedMap } from './mapInUse.js';
import { PropertyFields } from './PropertyFields.js';
import { fetchedPart, fetchParts, fetchPartsOf, PartInUse } from './parts/parts.js';
import { drawnPart, writePartUniforms } from './pictureOffset.js';
import { type ProgramFacts, programDefines, programSwitches, writeDefines } from './programDefines.js';
import { withVectors } from './propertyValues.js';
import type { ShaderFiles, Shaders } from './shaders/hatchingShaders.js';
import { plainShaders } from './shaders/plainShaders.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';
import { defineRigid, keepHooks, RendererKind } from './three/hooks.js';
import { MeshUniforms } from './three/MeshUniforms.js';
import { writeCurveUniforms } from './toneCurveTable.js';

/** Properties beside those of the table that three.js copies in `ShaderMaterial.copy`. */
// biome-ignore format: one line
const COPIED = ['fog', 'normalMapType', 'lights', 'clipping', 'wireframe', 'wireframeLinewidth', 'vertexShader', 'fragmentShader'] as const;

const propertyNames = /* @__PURE__ */ Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];
const propertyOf = (name: HatchingPropertyName): HatchingProperty => HATCHING_PROPERTIES[name];

/**
 * Hatches a surface: strokes lie in it, turn with the light and grow denser in the shade. An implementation of Suarez,
 * Belhadj and Boyer, "GPU real time hatching", 2013.
 *
 * Takes the scene's lights, shadows and fog. One DirectionalLight of intensity π and no other light gives the paper's
 * N·L. Draws geometry from `prepareHatchingGeometry()`.
 *
 * Every property may be set at any time and takes effect in the next frame; those that compile another program say so. A property that
 * the technique does not use compiles none.
 */
export class HatchingMaterial extends PropertyFields {
  readonly isHatchingMaterial = true;
  /** @internal Left out of the declarations, because three.js 0.170 declares an accessor and other versions a property. */
  override readonly type: string = 'HatchingMaterial';

  /** The space of `normalMap`, as in three's own materials: `TangentSpaceNormalMap` or `ObjectSpaceNormalMap`. */
  normalMapType: NormalMapTypes = TangentSpaceNormalMap;

  /** The choices that were set. They include the technique, which decides the defaults of the others. */
  private readonly chosen: { [Name in HatchingPropertyName]?: string | boolean | undefined } = {
    technique: HATCHING_DEFAULTS.technique,
  };
  private composed = new HatchingComposition();
  private readonly ofTriangles = new PerTriangle(() => this.writeProgram());
  /** The tone curve that was set; undefined means the technique's default. */
  private curve: ToneCurve | undefined;
  /** The shaders in use. They are assigned only when they change, so that a user may replace them. */
  private shaders: Shaders | undefined;
  /** The part that the technique of the shaders in use needs. */
  private readonly inUse = new PartInUse(() => this.writeProgram());
  /** The facts, beside the properties, that decide the program. */
  private readonly met: ProgramFacts = { hasEnvironment: false, vertexLayout: 'corner', hasForm: true };
  /** The frame that the uniforms were last written for, and the part of the render target, in pixels, that it is drawn to. */
  private readonly written = new FrameStamp();
  private readonly writtenTo = new Vector4();
  /** Values of the properties in that frame that are needed again for each of its meshes. */
  private followsForm = false;
  private takesWeight = false;
  /** The uniforms that differ between meshes. @internal */
  readonly ofMesh: MeshUniforms;
  /** The program switches of the last frame (see `programSwitches`). */
  private drawnSwitches = -1;
  /** Whether the program reads its strokes from a map. */
  private drawsWithMap = true;
  private readonly rendererKind = new RendererKind();
  /** Meshes that were announced before the first program was built. */
  private announced: Mesh[] = [];
  private readonly drawn = new DrawnMeshes();
  private isSettingValues = false;

  /** Whether the library's warnings are turned off (docs/troubleshooting.md lists them). Default: false. */
  static get silent(): boolean {
    return silence.isOn;
  }

  static set silent(isSilent: boolean) {
    silence.isOn = isSilent;
  }

  /** @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range */
  // React Three Fiber resets a removed attribute to its default only if the constructor's `length` is 0.
  constructor(parameters: HatchingMaterialParameters | undefined = undefined) {
    super();
    this.uniforms = createHatchingUniforms();
    this.ofMesh = new MeshUniforms(this, MESH_UNIFORMS);
    this.lights = true;
    this.fog = true;
    this.clipping = true;
    // Ink and paper are drawn in the colours that were set, without tone mapping.
    this.toneMapped = false;
    keepHooks(this, HatchingMaterial.prototype);
    // ShaderMaterial draws transparent double-sided meshes in one pass; three's surface materials draw the back faces first.
    this.forceSinglePass = false;
    this.setValues(parameters);
    this.writeProgram();
    this.writeUniforms();
  }

  /** Fetches the code of all techniques, so that every material draws with it from its first frame on. */
  static preload(): Promise<void> {
    return fetchParts();
  }

  /** Whether the material shows the shadows that fall on it, and nothing else, as `HatchingShadowMaterial` does. */
  get isHatchingShadowMaterial(): boolean {
    return false;
  }

  override get composition(): HatchingComposition {
    return this.composed;
  }

  override set composition(value: HatchingComposition | Partial<HatchingCompositionOptions>) {
    this.composed = composedWith(this.composed, value);
    this.writeProgram();
  }

  override get perTriangle(): PerTriangle {
    return this.ofTriangles;
  }

  override set perTriangle(value: Partial<PerTriangleOptions>) {
    this.ofTriangles.setValues(value);
  }

  override get hand(): Hand | null {
    return this.chosenHand;
  }

  override set hand(value: Hand | null) {
    checkHand(value);
    // Once the code that draws hands has loaded, it finds every fault.
    if (value) fetchedPart('handStrokes')?.checkHand?.(value);
    this.chosenHand = value;
    this.writeProgram();
  }

  override get toneCurve(): ToneCurve {
    return this.curve ?? (defaultOf('toneCurve', this.technique) as ToneCurve);
  }

  override set toneCurve(value: ToneCurve) {
    writeCurveUniforms(value, this.uniforms);
    this.curve = value;
    this.writeProgram();
  }

  /**
   * Sets properties by name, as three's own materials do. Warns of each property that the technique does not use.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  override setValues(values?: HatchingMaterialParameters): void {
    if (!values) return;
    const { defines } = this;
    const parameters = spelledOut(values);
    checkValues(parameters);
    this.isSettingValues = true;
    try {
      super.setValues(withVectors(parameters));
    } finally {
      this.isSettingValues = false;
    }
    if (this.defines !== defines) {
      // three.js has replaced the material's own defines by the given ones; both are needed.
      this.defines = { ...defines, ...this.defines };
      this.needsUpdate = true;
    }
    this.writeProgram();
    warnOfUnused(parameters, this.technique);
  }

  /**
   * Sets every property of a preset, and resets the properties that only other presets set. Properties that are set afterwards override
   * it.
   */
  set preset(name: PresetName) {
    this.setValues({ preset: name });
  }

  /**
   * Sets the properties that `toJSON` wrote, except the tonal art map; unknown properties are ignored. Called by three's own loaders,
   * which find the class after `MaterialLoader.registerMaterial('HatchingMaterial', HatchingMaterial)`.
   *
   * @param textures by uuid
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  override fromJSON(json: HatchingMaterialJSON, textures: Readonly<Record<string, Texture>> = {}): this {
    setFromJSON(this, json, textures);
    return this;
  }

  /** Creates a material from the JSON that `toJSON` wrote, with any version of three.js. See the method of the same name. */
  static fromJSON(json: HatchingMaterialJSON, textures: Readonly<Record<string, Texture>> = {}): HatchingMaterial {
    return new this().fromJSON(json, textures);
  }

  /**
   * Resolves when the material's map and code have loaded. The code of a technique is fetched when a material first uses it, and until
   * then the surface is plain paper or looks as before. For pages that render
   * on demand: `material.ready.then(render)`. Rejects if the map cannot be drawn or the code cannot be fetched; reading the property
   * again tries again.
   */
  get ready(): Promise<void> {
    this.writeProgram();
    return Promise.all([fetchPartsOf(this), mapIsReady(needsMap(this) ? this.tonalArtMap : null)]).then(() => {});
  }

  /**
   * Called by the renderer when it is about to choose a program, before a frame or in `compile`. Brings the program up to date (see
   * {@link ProgramFacts}).
   *
   * @returns a key that differs between programs of different hooks
   */
  override customProgramCacheKey(): string {
    this.writeProgram();
    this.rendererKind.ask('HatchingMaterial');
    return super.customProgramCacheKey();
  }

  /**
   * Announces a mesh that the material will draw, so that `renderer.compile` builds the programs of the first frame. `applyHatching`
   * calls it.
   *
   * @internal
   */
  announce(mesh: Mesh): void {
    this.announced.push(mesh);
    this.use('vertexLayout', vertexLayoutOf(mesh.geometry, mesh));
    this.use('hasForm', isFormed(mesh.geometry));
  }

  /**
   * Called by the renderer. Adds to both shaders the defines that three.js adds to the vertex shader alone. Also builds the programs of
   * the deformation pre-pass and of the environment's blur, which would otherwise be built in the first frame.
   */
  override onBeforeCompile(shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer): void {
    this.rendererKind.state = 'webgl';
    defineRigid(shader);
    const { part } = this.inUse;
    if (!part) return;
    for (const mesh of this.announced.splice(0)) {
      part.compile?.(renderer, mesh);
      const environment = part.surface.environmentAround(mesh);
      if (environment) part.surface.blurredEnvironment(renderer, environment);
    }
  }

  /** Called by the renderer. Writes the properties into the uniforms. */
  override onBeforeRender(
    renderer: WebGLRenderer,
    scene: Scene,
    camera: Camera,
    geometry: BufferGeometry,
    object: Object3D,
    _group: Group,
  ): void {
    this.rendererKind.state = 'webgl';
    const drawn = drawnPart(renderer, camera);
    // The uniforms are written once for all meshes of a frame, because three.js, too, uploads the uniforms of a material once per frame
    // unless told otherwise.
    if (this.ofMesh.isAllWanted || !this.written.isOf(renderer, camera) || !this.writtenTo.equals(drawn)) {
      this.written.note(renderer, camera);
      this.writtenTo.copy(drawn);
      this.followsForm = followsForm(this);
      this.takesWeight = takesWeight(this);
      const switches = programSwitches(this);
      if (this.drawnSwitches !== switches) this.needsUpdate = true;
      this.drawnSwitches = switches;
      this.writeUniforms(renderer, camera);
      writePartUniforms(camera, drawn, this.uniforms);
      const surface = this.inUse.part?.surface;
      if (surface && isFitted(this)) {
        const { composition } = this;
        const fit = composition.keptFit ?? surface.sceneExposure(renderer, scene, camera);
        surface.writeFit(composition.kept(fit), this, this.uniforms);
      }
      if (surface) this.use('hasEnvironment', surface.bindEnvironment(renderer, scene, camera, this.uniforms));
    }
    if (writeImportance(object, this.takesWeight, this.uniforms)) this.ofMesh.want(renderer);
    if (this.followsForm) this.use('hasForm', isFormed(geometry));
    this.drawn.note(this, renderer, scene, camera, geometry, object, this.writtenTo);
    if (this.announced.length > 0) this.announced.length = 0;
    const layout = this.inUse.part?.bindMesh?.(renderer, camera, geometry, object, this);
    if (layout) this.use('vertexLayout', layout);
  }

  /** Stores a fact of the scene or the mesh that decides the program. */
  private use<Fact extends keyof ProgramFacts>(fact: Fact, value: ProgramFacts[Fact]): void {
    if (value === this.met[fact]) return;
    this.met[fact] = value;
    this.writeProgram();
  }

  /** Copies the properties of another material. Textures, the tonal art map and the composition are shared. */
  override copy(source: this): this {
    // ShaderMaterial.copy would clone every texture among the uniforms, and each clone would be uploaded again.
    Material.prototype.copy.call(this, source);
    for (const name of COPIED) Object.assign(this, { [name]: source[name] });
    this.shaders = source.shaders;
    this.inUse.part = source.inUse.part;
    this.met.hasEnvironment = source.met.hasEnvironment;
    this.defines = { ...source.defines };
    for (const name of propertyNames) this.copyProperty(name, source);
    this.composed = source.composed;
    this.ofTriangles.setValues(source.ofTriangles);
    this.copyNumbers(source);
    this.writeProgram();
    this.writeUniforms();
    this.needsUpdate = true;
    return this;
  }

  override dispose(): void {
    super.dispose();
    this.uniforms.toneCurveTable.value?.dispose();
  }

  /** The JSON of three's own materials, and every property that is not at its default. The tonal art map is left out. */
  override toJSON(meta?: Parameters<Material['toJSON']>[0]): ReturnType<ShaderMaterial['toJSON']> {
    // ShaderMaterial.toJSON would write the shaders and the uniforms, which follow from the properties.
    const json = Material.prototype.toJSON.call(this, meta);
    // three.js takes `true` for the default and leaves it out.
    const toneMapped = this.toneMapped ? { toneMapped: true } : {};
    return Object.assign(json, toneMapped, propertiesToJSON(this)) as unknown as ReturnType<ShaderMaterial['toJSON']>;
  }

  protected override choice(name: HatchingPropertyName): string | boolean {
    return this.chosen[name] ?? (defaultOf(name, this.technique) as string | boolean);
  }

  protected override choose(name: HatchingPropertyName, value: string | boolean): void {
    checkChoice(name, value);
    const property = propertyOf(name);
    const chosen = value === 'auto' && property.kind === 'choice' && property.defaultFor ? undefined : value;
    if (chosen === this.chosen[name]) return;
    this.chosen[name] = chosen;
    this.writeProgram();
  }

  /** The files of the program beyond those of every material. @param ofPart those of its technique and medium @internal */
  protected shaderFiles(ofPart: ShaderFiles): ShaderFiles {
    return ofPart;
  }

  private copyProperty(name: HatchingPropertyName, source: this): void {
    const { kind, owner } = propertyOf(name);
    if (owner === 'composition' || owner === 'perTriangle') return;
    const own = name as PropertyNameOf<undefined>;
    switch (kind) {
      case 'color':
      case 'vector2':
        (this[own] as Color).copy(source[own] as Color);
        break;
      case 'choice':
      case 'switch':
        this.chosen[name] = source.chosen[name];
        break;
      case 'curve':
        writeCurveUniforms(source.toneCurve, this.uniforms);
        this.curve = source.curve;
        break;
      case 'number':
        break; // copyNumbers
      default:
        Object.assign(this, { [own]: source[own] });
    }
  }

  /** Writes the properties, which are plain values until then, to the uniforms. Allocates nothing. */
  private writeUniforms(renderer?: WebGLRenderer, camera?: Camera): void {
    const u = this.uniforms;
    const isOfThresholds = usesThresholds(this);
    const chosen = this.drawsWithMap ? this.mapInUse() : null;
    const map = fittingMap(chosen, isOfThresholds, renderer?.capabilities.maxTextureSize ?? Infinity);
    writePropertyUniforms(this, u);
    u.opacity.value = this.opacity;
    u.alphaTest.value = this.alphaTest;
    writeSizeUniforms(this, chosen, renderer?.getPixelRatio() ?? 1, u);
    writeMapUniforms(map, isOfThresholds, u);
    u.inked.value = Number(map !== null || !this.drawsWithMap);
    writeComputedUniforms(this, u);
    this.inUse.part?.writeUniforms?.(u, this, renderer?.getPixelRatio() ?? 1);
    writeFading(this, u, renderer, camera);
  }

  /** The map to draw with, once it is ready. The shared map of a style is requested only when a renderer draws or compiles. */
  private mapInUse(): TonalArtMap | null {
    const { tonalArtMap } = this;
    if (typeof tonalArtMap !== 'string') return tonalArtMap;
    return this.rendererKind.state === 'webgl' ? sharedMap(tonalArtMap) : null;
  }

  /** Updates the shaders and the defines after choices were set. Choices that are set together are applied at once. */
  private writeProgram(): void {
    if (this.isSettingValues) return;
    const part = this.inUse.take(this);
    if (!part) {
      // Until the code has loaded, the surface looks as it did before, or like plain paper.
      if (!this.shaders) Object.assign(this, plainShaders(), { drawsWithMap: needsMap(this) });
      return;
    }
    const { surface, files } = part;
    if (this.announced.some(surface.environmentAround)) this.met.hasEnvironment = true;
    const shaders = surface.hatchingShaders(this.technique, this.shaderFiles(files));
    let hasChanged = this.shaders !== shaders;
    if (hasChanged) {
      this.shaders = shaders;
      Object.assign(this, shaders);
      writeCurveUniforms(this.toneCurve, this.uniforms);
    }
    if (writeDefines(this.defines, programDefines(this, this.met))) hasChanged = true;
    this.drawsWithMap = needsMap(this);
    if (hasChanged) this.needsUpdate = true;
  }
}
