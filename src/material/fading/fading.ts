import { type Camera, type IUniform, type Object3D, Vector3, Vector4, type WebGLRenderer } from 'three';
import { isUsedBy, propertyOf } from '../../look/queries.js';
import type { HatchingCompositionProperties } from '../groups/ownedProperties.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { automaticDepthFade } from './automaticDepthFade.js';
import type { SeenDepths } from './seenDepths.js';

type Uniforms = Record<string, IUniform>;

/** The properties that decide how much weight the drawing has where: those of a HatchingMaterial. */
export type FadingLook = Pick<HatchingMaterialProperties, 'technique' | 'composition'>;

/** The uniforms of shaders/chunks/fading.glsl. */
export const createFadingUniforms = (): Uniforms => ({
  depthFading: { value: new Vector3(0, 1, 0) },
  focusing: { value: new Vector4() },
  importance: { value: 1 },
  sheet: { value: new Vector4(0, 0, 1, 1) },
  vignette: { value: 0 },
});

/** Whether a look fades anything anywhere, as the techniques of the paper by Suarez et al. do not. */
export const takesWeight = (look: FadingLook | null): look is FadingLook =>
  look !== null && isUsedBy(look.technique, propertyOf('depthFade'));

/** Whether ink fades around a focus or towards the rim of the sheet. Allocates nothing. */
export const fadesAround = (look: FadingLook): boolean =>
  (look.composition.vignette !== 0 || look.composition.focus !== null) && takesWeight(look);

/**
 * Writes the uniforms of a frame. Allocates nothing.
 *
 * @param look null for full weight everywhere
 * @param camera undefined before the first frame
 */
export function writeFading(look: FadingLook | null, u: Uniforms, renderer?: WebGLRenderer, camera?: Camera): void {
  const focusing = u.focusing.value as Vector4;
  if (!takesWeight(look)) {
    (u.depthFading.value as Vector3).set(0, 1, 0);
    focusing.w = 0;
    u.vignette.value = 0;
    return;
  }
  // Most scenes do not fade, and need not be measured.
  const { composition } = look;
  const seen = composition.depthFade !== 0 && renderer && camera && composition.extent?.seenFrom(renderer, camera);
  writeDepthFading(composition, seen || null, camera, u.depthFading.value);
  u.vignette.value = composition.vignette;
  const { focus, focusRadius } = composition;
  if (!focus) {
    focusing.w = 0;
    return;
  }
  const { x, y, z } = focus;
  focusing.set(x, y, z, 1);
  if (camera) focusing.applyMatrix4(camera.matrixWorldInverse);
  focusing.w = focusRadius;
}

/**
 * Writes the depths between which a look fades, and how strongly. Allocates nothing.
 *
 * @param seen the depth range of the scene; null if it was not measured: depths are then in view units
 */
export function writeDepthFading(
  { depthFade, depthFadeStart, depthFadeEnd }: HatchingCompositionProperties,
  seen: Readonly<SeenDepths> | null,
  camera: Camera | undefined,
  fading: Vector3,
): void {
  const strength = depthFade !== 'auto' ? depthFade : seen && camera ? automaticDepthFade(seen, camera) : 0;
  const start = seen ? seen.front : 0;
  const unit = seen ? seen.back - seen.front : 1;
  const near = start + unit * depthFadeStart;
  // A fade of length 0 is a step; the least length avoids a division by 0.
  fading.set(near, Math.max(start + unit * depthFadeEnd, near + 1e-6), strength);
}

/**
 * Writes the importance of an object. Allocates nothing.
 *
 * @param isWeighed whether its look fades anything at all
 * @returns whether the importance differs from that of the previous object
 */
export function writeImportance(object: Object3D, isWeighed: boolean, u: Uniforms): boolean {
  const importance = isWeighed ? importanceOf(object) : 1;
  const isOther = importance !== u.importance.value;
  u.importance.value = importance;
  return isOther;
}

/**
 * The importance of an object, from 0 to 1: `userData.hatching.importance` of the object or of its nearest ancestor that has one;
 * otherwise 1. Allocates nothing.
 */
export function importanceOf(drawn: Object3D): number {
  for (let object: Object3D | null = drawn; object !== null; object = object.parent) {
    const importance: unknown = object.userData?.hatching?.importance;
    if (typeof importance === 'number' && importance >= 0) return Math.min(importance, 1);
  }
  return 1;
}
