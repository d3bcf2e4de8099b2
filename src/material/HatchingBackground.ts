import {
  Box3,
  BufferGeometry,
  type Camera,
  Color,
  type ColorRepresentation,
  Mesh,
  type Object3D,
  type Scene,
  ShaderMaterial,
  Sphere,
  UniformsLib,
  UniformsUtils,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { BACKGROUND_CONSTANTS, HASH_FACTORS } from '../look/constants/patternConstants.js';
import {
  BACKGROUND_NUMBER_NAMES,
  BACKGROUND_NUMBERS,
  type BackgroundNumberName,
  HATCHING_BACKGROUND_DEFAULTS,
} from './backgroundProperties.js';
import { checkNumber } from './checkNumber.js';
import { warnOfRenderer } from './diagnostics/warn.js';
import { SceneExtent } from './fading/SceneExtent.js';
import { keptFromProxies } from './hatchingUniforms.js';
import { writeSheet } from './pictureOffset.js';
import type { Shaders } from './shaders/hatchingShaders.js';
import { conventionsChunk } from './shaders/shaderConventions.js';
import { definesOf, resolveIncludes } from './shaders/shaderText.js';
import { lightChunks } from './three/lightKinds.js';
import { NO_VERTICES } from './three/posing.js';

/** The sources of the background shaders, and the chunks that they share with materials. */
const files: Readonly<Record<string, string>> = import.meta.glob(
  ['../../shaders/background/*', '../../shaders/chunks/{lightLuminance,lineCoverage,meanLight}.glsl'],
  { query: '?raw', import: 'default', eager: true },
);

let made: Shaders | undefined;

/** The shaders of backgrounds. The first call resolves their includes. */
export function backgroundShaders(): Shaders {
  if (made) return made;
  const chunks: Record<string, string> = {
    conventions: conventionsChunk(),
    'background/constants': [definesOf(BACKGROUND_CONSTANTS), definesOf(HASH_FACTORS, 'u')].join('\n'),
    ...lightChunks(),
  };
  for (const [path, text] of Object.entries(files)) {
    chunks[path.replace('../../shaders/', '').replace('chunks/', '').replace('.glsl', '')] = text;
  }
  made = {
    vertexShader: resolveIncludes(chunks['background/background.vert'], chunks),
    fragmentShader: resolveIncludes(chunks['background/background.frag'], chunks),
  };
  return made;
}

/** The parameters of `new HatchingBackground()`. */
export type HatchingBackgroundParameters = Partial<Pick<HatchingBackground, BackgroundNumberName>> & {
  ink?: ColorRepresentation | undefined;
};

/** The render order: before everything else that follows the opaque surfaces, such as shadows on the paper. */
const RENDER_ORDER = -1e6;
/** The vertex count of one triangle that covers the sheet. */
const VERTICES = 3;

const viewport = /* @__PURE__ */ new Vector4();

/**
 * A field of parallel ruled lines on the paper behind a subject. It is darker behind the subject's lit side and lighter behind its dark
 * side, so that the subject stands out, and its rim ends in open strokes. Add it to the scene; it stays behind everything, wherever it
 * is added.
 *
 *     const { materials } = await applyHatching(model, 'engraving');
 *     scene.add(new HatchingBackground(composition.extent, { ink: '#1c1a17' }));
 *
 * The direction of the light is the mean of all lights of the scene, projected onto the sheet. Every property may be changed at any
 * time, and builds no program. It casts no shadow, and is left out of raycasts and bounds.
 */
export class HatchingBackground extends Mesh<BufferGeometry, ShaderMaterial> {
  readonly isHatchingBackground = true;

  /** The share of the paper that the lines cover in the middle of the field, from 0 to 1. Default 0.25. */
  declare tone: number;
  /** How much darker the field is behind the lit side, and lighter behind the dark side, from 0 to 1. Default 0.75. */
  declare contrast: number;
  /** Distance between the lines, in CSS pixels, above 0. Default 6. */
  declare spacing: number;
  /** Angle between the lines and the lower edge of the sheet, in radians; positive angles rise to the right. Default π/5. */
  declare direction: number;
  /** How far the field reaches from the middle of the subject, by half of its width and height on the sheet, above 0. Default 1.4. */
  declare extent: number;
  /** Colour of the lines. Default black. */
  readonly ink = new Color(HATCHING_BACKGROUND_DEFAULTS.ink);
  /** The subject in front of the field; without one nothing is drawn. */
  subject: SceneExtent | null;

  /**
   * @param subject what stands in front of the field: the extent of a hatched scene, or an object, whose bounds are measured now
   * @throws RangeError if a number is out of its range
   */
  constructor(subject: SceneExtent | Object3D | null = null, { ink, ...numbers }: HatchingBackgroundParameters = {}) {
    super(emptyGeometry(), backgroundMaterial());
    for (const name of BACKGROUND_NUMBER_NAMES) this.defineNumber(name);
    this.subject = subject && 'isObject3D' in subject ? extentOf(subject) : subject;
    this.frustumCulled = false;
    this.renderOrder = RENDER_ORDER;
    if (ink !== undefined) this.ink.set(ink);
    Object.assign(this, numbers);
  }

  /** Does nothing: rays pass through the background. */
  override raycast(): void {}

  /** Frees the GPU memory of the background. */
  override dispose(): void {
    // In older versions of three.js, Object3D has no dispose().
    super.dispose?.();
    this.geometry.dispose();
    this.material.dispose();
  }

  override readonly onBeforeRender = (renderer: WebGLRenderer, _scene: Scene, camera: Camera): void => {
    const { geometry, subject, material } = this;
    if ('isWebGPURenderer' in renderer) {
      geometry.setDrawRange(0, NO_VERTICES);
      warnOfRenderer('HatchingBackground', false);
      return;
    }
    const seen = subject?.seenFrom(renderer, camera);
    geometry.setDrawRange(0, seen ? VERTICES : NO_VERTICES);
    if (!subject || !seen) return;
    const u = material.uniforms;
    const pixelRatio = renderer.getPixelRatio();
    const part = (camera as Camera & { viewport?: Vector4 }).viewport;
    const sheet: Vector4 = u.sheet.value;
    writeSheet(sheet, camera, part ?? renderer.getCurrentViewport(viewport));
    u.subject.value.set(
      (0.25 * (seen.left + seen.right) + 0.5) * sheet.z,
      (0.25 * (seen.bottom + seen.top) + 0.5) * sheet.w,
      0.25 * (seen.right - seen.left) * sheet.z,
      0.25 * (seen.top - seen.bottom) * sheet.w,
    );
    const centre: Vector3 = u.centre.value;
    subject.box.getCenter(centre).applyMatrix4(subject.frame.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
    u.tone.value = this.tone;
    u.contrast.value = this.contrast;
    u.extent.value = this.extent;
    u.spacing.value = this.spacing * pixelRatio;
    u.direction.value.set(Math.cos(this.direction), Math.sin(this.direction));
    u.ink.value = this.ink;
    u.opacity.value = material.opacity;
    material.uniformsNeedUpdate = true;
  };

  private defineNumber(name: BackgroundNumberName): void {
    let current: number = HATCHING_BACKGROUND_DEFAULTS[name];
    Object.defineProperty(this, name, {
      get: () => current,
      set: (value: number) => {
        current = checkNumber(name, value, BACKGROUND_NUMBERS[name], 'HatchingBackground');
      },
      enumerable: true,
    });
  }
}

/** A geometry without attributes: other materials, such as those of depth passes, draw nothing of it. */
function emptyGeometry(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.boundingBox = new Box3();
  geometry.boundingSphere = new Sphere(new Vector3(), -1);
  return geometry;
}

const backgroundMaterial = (): ShaderMaterial =>
  new ShaderMaterial({
    ...backgroundShaders(),
    uniforms: keptFromProxies(
      UniformsUtils.merge([
        UniformsLib.lights,
        Object.fromEntries(BACKGROUND_NUMBER_NAMES.map((name) => [name, { value: 0 }])),
        {
          centre: { value: new Vector3() },
          direction: { value: new Vector2() },
          ink: { value: new Color() },
          opacity: { value: 1 },
          sheet: { value: new Vector4() },
          subject: { value: new Vector4() },
        },
      ]),
    ),
    lights: true,
    transparent: true,
    depthWrite: false,
    toneMapped: false,
  });

/** The extent of an object in its own space. */
function extentOf(object: Object3D): SceneExtent {
  object.updateWorldMatrix(true, true);
  const box = new Box3().setFromObject(object).applyMatrix4(object.matrixWorld.clone().invert());
  return new SceneExtent(object, box);
}
