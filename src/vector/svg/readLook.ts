import type { IUniform, Mesh, Vector2 } from 'three';
import { luminanceOf } from '../../look/luminance.js';
import { resolveLook } from '../../look/resolveLook.js';
import { isFitted } from '../../material/exposure/isFitted.js';
import type { ToneFit } from '../../material/exposure/ToneFit.js';
import { fittedCurve } from '../../material/fitToneCurve.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import { createHatchingUniforms, writeComputedUniforms, writeSizeUniforms } from '../../material/hatchingUniforms.js';
import type { EngravedLook } from '../Engraver.js';
import type { ObjectFading } from '../shading/fading.js';
import type { GroundLook } from '../shading/groundShadow.js';
import { type CurveCubics, localDarkness } from '../shading/tone.js';
import type { SurfaceLook } from '../Toner.js';
import { opacityOf } from './seenThrough.js';

/** The uniforms of a material. Sizes are in CSS pixels. */
function uniformsOf(material: HatchingMaterial): Record<string, IUniform> {
  const uniforms = createHatchingUniforms();
  writeComputedUniforms(material, uniforms);
  writeSizeUniforms(material, null, 1, uniforms);
  return uniforms;
}

/**
 * The properties of a material's engraved lines.
 *
 * @param hasForm whether the geometry was prepared with its form
 */
export function engravedLookOf(material: HatchingMaterial, hasForm: boolean): EngravedLook {
  const { lineSpacing, finestSpacing, crossFrom } = uniformsOf(material);
  const { medium, lineField, shadowStrokes } = resolveLook(material, hasForm);
  const { strokeLength, crossAngle, handmade, sizedOnScreen, shadowSpacing, toneModel } = material;
  return {
    lineField,
    medium: medium === 'pen' || medium === 'woodcut' ? medium : 'ink',
    strokeLength,
    spacing: {
      lineSpacing: lineSpacing.value * (toneModel === 'shadow' ? shadowSpacing : 1),
      finestSpacing: finestSpacing.value,
      sizedOnScreen,
    },
    crossFrom: crossFrom.value,
    crossAngle,
    handmade,
    crossesInShadows: shadowStrokes === 'cross',
  };
}

/**
 * The properties of a material that its tone depends on.
 *
 * @param mesh the mesh that it draws
 * @param fit of the exposure to the scene
 * @param fading of the object
 */
export function surfaceLookOf(
  material: HatchingMaterial,
  { geometry, receiveShadow: receivesShadows }: Mesh,
  fit: ToneFit,
  fading: ObjectFading | null,
): SurfaceLook {
  const uniforms = uniformsOf(material);
  const { color, emissive, emissiveIntensity, localTone, toneModel, toneCurve } = material;
  const { shininess, reflectedLight, occlusion, hollowTone, toneSteps, exposureCompensation } = material;
  const emitted = emissiveIntensity * luminanceOf(emissive);
  const isFit = isFitted(material);
  const exposure = uniforms.exposure.value as Vector2;
  return {
    model: toneModel === 'shadow' ? 'lambert' : toneModel,
    curve: curveOf(toneCurve),
    steps: toneModel === 'toon' ? toneSteps : 0,
    exposure: isFit ? [exposureCompensation * fit.scale, exposureCompensation * fit.offset] : [exposure.x, exposure.y],
    highlightRamp: (uniforms.highlightRamp.value as Vector2).toArray() as [number, number],
    toneEnds: (uniforms.toneEnds.value as Vector2).toArray() as [number, number],
    occlusion,
    hollowTone,
    ground: toneModel === 'shadow' ? groundOf(material) : null,
    darkness: localTone > 0 ? localDarkness(luminanceOf(color), emitted, localTone, isFit ? 1 / fit.white : 1) : 0,
    opacity: opacityOf(material, geometry),
    ...{ shininess, reflectedLight, emitted, receivesShadows, fading },
  };
}

const groundOf = ({ shadowTone, shadowFade, shadowSoftness }: HatchingMaterial): GroundLook => ({
  tone: shadowTone,
  fade: shadowFade,
  softness: shadowSoftness,
});

function curveOf(curve: HatchingMaterial['toneCurve']): 'perceptual' | CurveCubics | null {
  if (curve === 'perceptual') return curve;
  return fittedCurve(curve) ?? null;
}
