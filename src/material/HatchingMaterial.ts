import {
  type BufferGeometry,
  type Camera,
  Color,
  type Group,
  Material,
  Matrix3,
  type Object3D,
  type Scene,
  ShaderMaterial,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { TonalArtMap } from '../tam/TonalArtMap.js';
import { bindVertices } from './bindVertices.js';
import { blankTonalArtMap } from './blankTonalArtMap.js';
import { fitToneCurve } from './fitToneCurve.js';
import type { HatchingMaterialParameters, ToneCurve } from './HatchingMaterialOptions.js';
import { hatchingShaders } from './hatchingShaders.js';
import {
  DEBUG_VIEWS,
  type DebugView,
  INK_BLENDS,
  type InkBlend,
  LEVEL_RULES,
  type LevelRule,
  STROKE_ANCHORS,
  type StrokeAnchor,
  TONE_CURVES,
  TONE_MODELS,
  TONE_NORMALS,
  type ToneModel,
  type ToneNormal,
  VERTEX_LAYOUTS,
} from './shaderConventions.js';
import { type HatchingTechnique, techniques } from './techniques.js';

const viewport = new Vector4();

/**
 * Hatches a surface: strokes lie in it, turn with the light and grow denser in the shade. An implementation of Suarez,
 * Belhadj and Boyer, "GPU real time hatching", 2013.
 *
 * Takes the scene's lights, shadows and fog. One DirectionalLight of intensity π and no other light gives the paper's
 * N·L. Draws geometry from `prepareHatchingGeometry()`.
 *
 * Every property may be set at any time and counts from the next frame on; those that build another program say so.
 */
export class HatchingMaterial extends ShaderMaterial {
  readonly isHatchingMaterial: boolean = true;
  override readonly type: string = 'HatchingMaterial';

  tonalArtMap: TonalArtMap | null = null;
  strokeScale = 3;
  strokeRotation = 0;
  readonly strokeOffset = new Vector2();
  toneSteps = 4;
  shininess = 30;
  reflectedLight = 0;
  anchorSpacing = 0.45;
  screenConstancy = 0;
  texelPixels = 1;
  edgePixels = 1;
  creaseAngle = Math.PI / 2;
  readonly ink = new Color(0x000000);
  readonly paper = new Color(0xffffff);
  readonly color = new Color(0xffffff);
  paperOpacity = 1;
  map: Texture | null = null;
  alphaMap: Texture | null = null;

  #technique: HatchingTechnique = 'adjacency';
  #toneNormalChosen = false;
  #toneCurve: ToneCurve = 'linear';

  /** @throws Error if a choice is none of the known names, or `toneCurve` no curve. */
  constructor(parameters?: HatchingMaterialParameters) {
    super({
      uniforms: UniformsUtils.merge([
        UniformsLib.lights,
        UniformsLib.fog,
        {
          alphaMap: { value: null },
          alphaMapTransform: { value: new Matrix3() },
          alphaTest: { value: 0 },
          anchorSpacing: { value: 0 },
          creaseCosine: { value: 0 },
          deformedNormals: { value: null },
          deformedPositions: { value: null },
          deformedTurns: { value: null },
          diffuse: { value: null },
          edgePixels: { value: 0 },
          ink: { value: null },
          map: { value: null },
          mapTransform: { value: new Matrix3() },
          opacity: { value: 1 },
          paper: { value: null },
          paperOpacity: { value: 1 },
          reflectedLight: { value: 0 },
          restPositions: { value: null },
          screenConstancy: { value: 0 },
          shininess: { value: 0 },
          strokeDirection: { value: new Vector2() },
          strokeScale: { value: 1 },
          strokeTransform: { value: new Matrix3() },
          texelPixels: { value: 1 },
          thresholdMap: { value: null },
          thresholdMapLevels: { value: 1 },
          thresholdMoments: { value: new Vector3(1, 1, 0) },
          thresholdMapSize: { value: 1 },
          tonalArtMap: { value: null },
          tonalArtMapTones: { value: 2 },
          toneCurveCubics: { value: null },
          toneCurveSpans: { value: null },
          toneCurveStart: { value: 0 },
          toneSteps: { value: 0 },
          triangleVertices: { value: null },
          viewportHeight: { value: 1 },
        },
      ]),
      defines: {
        TONE_MODEL: TONE_MODELS.indexOf('lambert'),
        TONE_NORMAL: TONE_NORMALS.indexOf('face'),
        TONE_CURVE: TONE_CURVES.indexOf('linear'),
        LEVEL_RULE: LEVEL_RULES.indexOf('derivatives'),
        INK_BLEND: INK_BLENDS.indexOf('cover'),
        DEBUG_VIEW: DEBUG_VIEWS.indexOf('none'),
        STROKE_ANCHOR: STROKE_ANCHORS.indexOf('rest'),
        VERTEX_LAYOUT: VERTEX_LAYOUTS.indexOf('corner'),
      },
      ...hatchingShaders('adjacency'),
      lights: true,
      fog: true,
      clipping: true,
    });
    // ShaderMaterial draws transparent double-sided meshes in one pass; three's own surface materials draw the back first.
    this.forceSinglePass = false;
    this.setValues(parameters);
    this.#writeUniforms();
  }

  get technique(): HatchingTechnique {
    return this.#technique;
  }

  set technique(value: HatchingTechnique) {
    if (!Object.hasOwn(techniques, value)) {
      throw new Error(
        `HatchingMaterial.technique: "${value}" is not known; use one of ${Object.keys(techniques).join(', ')}.`,
      );
    }
    if (value === this.#technique) return;
    this.#technique = value;
    // Programs are told apart by their text.
    Object.assign(this, hatchingShaders(value));
    this.needsUpdate = true;
    if (this.#toneNormalChosen) return;
    this.#define('TONE_NORMAL', 'toneNormal', TONE_NORMALS, techniques[value].toneNormal);
  }

  get crisp(): boolean {
    return this.defines.CRISP !== undefined;
  }

  set crisp(value: boolean) {
    this.#switch('CRISP', value);
  }

  get secondLayer(): boolean {
    return this.defines.SECOND_LAYER !== undefined;
  }

  set secondLayer(value: boolean) {
    this.#switch('SECOND_LAYER', value);
  }

  get toneCurve(): ToneCurve {
    return this.#toneCurve;
  }

  set toneCurve(value: ToneCurve) {
    const isNamed = value === 'linear' || value === 'perceptual';
    if (!isNamed) {
      const { start, spans, cubics } = fitToneCurve(value);
      this.uniforms.toneCurveStart.value = start;
      this.uniforms.toneCurveSpans.value = spans;
      this.uniforms.toneCurveCubics.value = cubics;
    }
    this.#define('TONE_CURVE', 'toneCurve', TONE_CURVES, isNamed ? value : 'points');
    this.#toneCurve = value;
  }

  get levelRule(): LevelRule {
    return LEVEL_RULES[this.defines.LEVEL_RULE as number];
  }

  set levelRule(value: LevelRule) {
    this.#define('LEVEL_RULE', 'levelRule', LEVEL_RULES, value);
  }

  get inkBlend(): InkBlend {
    return INK_BLENDS[this.defines.INK_BLEND as number];
  }

  set inkBlend(value: InkBlend) {
    this.#define('INK_BLEND', 'inkBlend', INK_BLENDS, value);
  }

  get strokeAnchor(): StrokeAnchor {
    return STROKE_ANCHORS[this.defines.STROKE_ANCHOR as number];
  }

  set strokeAnchor(value: StrokeAnchor) {
    this.#define('STROKE_ANCHOR', 'strokeAnchor', STROKE_ANCHORS, value);
  }

  get toneModel(): ToneModel {
    return TONE_MODELS[this.defines.TONE_MODEL as number];
  }

  set toneModel(value: ToneModel) {
    this.#define('TONE_MODEL', 'toneModel', TONE_MODELS, value);
  }

  get toneNormal(): ToneNormal {
    return TONE_NORMALS[this.defines.TONE_NORMAL as number];
  }

  set toneNormal(value: ToneNormal) {
    this.#define('TONE_NORMAL', 'toneNormal', TONE_NORMALS, value);
    this.#toneNormalChosen = true;
  }

  get debugView(): DebugView {
    return DEBUG_VIEWS[this.defines.DEBUG_VIEW as number];
  }

  set debugView(value: DebugView) {
    this.#define('DEBUG_VIEW', 'debugView', DEBUG_VIEWS, value);
  }

  override onBeforeRender(
    renderer: WebGLRenderer,
    _scene: Scene,
    camera: Camera,
    geometry: BufferGeometry,
    object: Object3D,
    _group: Group,
  ): void {
    // The cameras of an ArrayCamera have a part of the target each.
    const part = (camera as Camera & { viewport?: Vector4 }).viewport;
    this.uniforms.viewportHeight.value = (part ?? renderer.getCurrentViewport(viewport)).w;
    this.#writeUniforms();
    if (techniques[this.technique].vertexData !== 'adjacency') return;
    const layout = bindVertices(renderer, camera, geometry, object, this);
    this.#define('VERTEX_LAYOUT', 'vertex layout', VERTEX_LAYOUTS, layout);
  }

  override copy(source: this): this {
    // Not ShaderMaterial's copy: that clones every texture among the uniforms, and each clone would be uploaded again.
    Material.prototype.copy.call(this, source);
    this.fog = source.fog;
    this.lights = source.lights;
    this.clipping = source.clipping;
    this.wireframe = source.wireframe;
    this.wireframeLinewidth = source.wireframeLinewidth;
    this.vertexShader = source.vertexShader;
    this.fragmentShader = source.fragmentShader;
    this.defines = { ...source.defines };
    this.#technique = source.#technique;
    this.toneCurve = source.toneCurve;

    this.tonalArtMap = source.tonalArtMap;
    this.strokeScale = source.strokeScale;
    this.strokeRotation = source.strokeRotation;
    this.strokeOffset.copy(source.strokeOffset);
    this.#toneNormalChosen = source.#toneNormalChosen;
    this.anchorSpacing = source.anchorSpacing;
    this.screenConstancy = source.screenConstancy;
    this.texelPixels = source.texelPixels;
    this.edgePixels = source.edgePixels;
    this.toneSteps = source.toneSteps;
    this.shininess = source.shininess;
    this.reflectedLight = source.reflectedLight;
    this.creaseAngle = source.creaseAngle;
    this.ink.copy(source.ink);
    this.paper.copy(source.paper);
    this.paperOpacity = source.paperOpacity;
    this.color.copy(source.color);
    this.map = source.map;
    this.alphaMap = source.alphaMap;
    this.#writeUniforms();
    return this;
  }

  /** Properties are plain values; this is the one place that brings them to the shader. Allocates nothing. */
  #writeUniforms(): void {
    const u = this.uniforms;
    u.diffuse.value = this.color;
    u.opacity.value = this.opacity;
    u.alphaTest.value = this.alphaTest;
    u.ink.value = this.ink;
    u.paper.value = this.paper;
    u.paperOpacity.value = this.paperOpacity;
    u.reflectedLight.value = this.reflectedLight;
    u.shininess.value = this.shininess;
    u.toneSteps.value = this.toneSteps;
    u.creaseCosine.value = Math.cos(this.creaseAngle);
    u.tonalArtMap.value = this.tonalArtMap?.texture ?? blankTonalArtMap();
    u.tonalArtMapTones.value = this.tonalArtMap?.tones ?? 2;

    // u = s·cos − t·sin, v = s·sin + t·cos, in tiles
    const { strokeScale: scale, strokeOffset: offset } = this;
    const cos = Math.cos(this.strokeRotation);
    const sin = Math.sin(this.strokeRotation);
    u.strokeTransform.value.set(cos * scale, -sin * scale, offset.x, sin * scale, cos * scale, offset.y, 0, 0, 1);
    u.strokeDirection.value.set(cos, sin);
    u.strokeScale.value = scale;
    u.anchorSpacing.value = this.anchorSpacing;
    u.screenConstancy.value = this.screenConstancy;
    u.texelPixels.value = this.texelPixels;
    u.edgePixels.value = this.edgePixels;
    if (this.tonalArtMap !== null && (this.crisp || techniques[this.technique].map === 'thresholdMap')) {
      u.thresholdMap.value = this.tonalArtMap.thresholdTexture;
      u.thresholdMapLevels.value = this.tonalArtMap.levels;
      const { variance, coarserVariance, covariance } = this.tonalArtMap.thresholdMoments;
      u.thresholdMoments.value.set(variance, coarserVariance, covariance);
      u.thresholdMapSize.value = this.tonalArtMap.size;
    }

    writeTexture(this.map, u.map, u.mapTransform);
    writeTexture(this.alphaMap, u.alphaMap, u.alphaMapTransform);
  }

  #switch(define: string, value: boolean): void {
    if (value === (this.defines[define] !== undefined)) return;
    if (value) this.defines[define] = '';
    else delete this.defines[define];
    this.needsUpdate = true;
  }

  #define<Name extends string>(define: string, property: string, names: readonly Name[], value: Name): void {
    const index = names.indexOf(value);
    if (index === -1) {
      throw new Error(`HatchingMaterial.${property}: "${value}" is not known; use one of ${names.join(', ')}.`);
    }
    if (this.defines[define] === index) return;
    this.defines[define] = index;
    this.needsUpdate = true;
  }
}

function writeTexture(texture: Texture | null, uniform: { value: unknown }, transform: { value: Matrix3 }): void {
  uniform.value = texture;
  if (texture === null) return;
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  transform.value.copy(texture.matrix);
}
