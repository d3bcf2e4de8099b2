import {
  type Camera,
  type IUniform,
  type Material,
  type Mesh,
  type Object3D,
  type Vector2,
  Vector3,
  Vector4,
} from 'three';
import { drawsHand, resolveLook } from '../../look/queries.js';
import { luminanceOf } from '../../look/vectors.js';
import { isFitted, type ToneFit } from '../../material/exposure/ToneFit.js';
import { type FadingLook, importanceOf, takesWeight, writeDepthFading } from '../../material/fading/fading.js';
import type { SceneExtent } from '../../material/fading/SceneExtent.js';
import { type SeenBox, seenBox } from '../../material/fading/seenDepths.js';
import { fittedCurve } from '../../material/fitToneCurve.js';
import type { HatchingBackground } from '../../material/HatchingBackground.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { HatchingShadowMaterial } from '../../material/HatchingShadowMaterial.js';
import { createHatchingUniforms, writeComputedUniforms, writeSizeUniforms } from '../../material/hatchingUniforms.js';
import { fetchedPart } from '../../material/parts/parts.js';
import { writeSheet } from '../../material/pictureOffset.js';
import type { StrokeProfiles } from '../../strokes/strokeProfiles.js';
import type { DrawnBackground } from '../DrawnScene.js';
import type { EngravedLook } from '../Engraver.js';
import type { LineTechnique } from '../lineMarks.js';
import type { ObjectFading } from '../shading/fading.js';
import type { GroundLook } from '../shading/groundShadow.js';
import { shareOfRoom } from '../shading/metal.js';
import { meanLightAt } from '../shading/radiance.js';
import { type CurveCubics, localDarkness } from '../shading/tone.js';
import type { SurfaceLook } from '../ToneReader.js';
import { colorTonesOf } from './colorTones.js';
import type { SceneLights } from './readLights.js';
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
  const uniforms = uniformsOf(material);
  const hand = drawnHandOf(material, uniforms);
  const { lineSpacing, strokeLength, minLineSpacing, crossFrom, layerTurns } = uniforms;
  const { technique, direction, shadowStrokes } = resolveLook(material, hasForm);
  const { irregularity, screenSpaceShare } = material;
  return {
    direction: direction as EngravedLook['direction'],
    technique: technique as LineTechnique,
    strokeLength: strokeLength.value,
    spacing: {
      lineSpacing: lineSpacing.value * (isOfShadows(material) ? material.shadowSpacing : 1),
      minLineSpacing: minLineSpacing.value,
      screenSpaceShare,
    },
    crossFrom: crossFrom.value,
    crossAngle: Math.atan2(layerTurns.value.y, layerTurns.value.x),
    irregularity: hand ? 0 : irregularity,
    crossesInShadows: shadowStrokes === 'cross',
    hand,
  };
}

/**
 * The strokes of the hand that a material draws with; null without one. Writes the sizes of its rows into the uniforms. A hand with a
 * fault, which is reported, gives way to the one before it.
 */
function drawnHandOf(material: HatchingMaterial, uniforms: Record<string, IUniform>): StrokeProfiles | null {
  const part = drawsHand(material) ? fetchedPart('handStrokes') : undefined;
  if (!part?.profilesOf) return null;
  part.writeUniforms?.(uniforms, material, 1);
  return material.hand && part.profilesOf(material.hand);
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
  const { color, emissive, emissiveIntensity, toneModel, toneCurve } = material;
  const { shininess, reflectedLight, occlusion, hollowStrength, toneSteps } = material;
  const emitted = emissiveIntensity * luminanceOf(emissive);
  const isFit = isFitted(material);
  const { exposureCompensation } = material.composition;
  const kept = isFit ? material.composition.kept(fit) : fit;
  const exposure = uniforms.exposure.value as Vector2;
  return {
    model: toneModel,
    curve: curveOf(toneCurve),
    steps: toneModel === 'toon' ? toneSteps : 0,
    exposure: isFit
      ? [exposureCompensation * kept.scale, exposureCompensation * kept.offset]
      : [exposure.x, exposure.y],
    highlightRamp: (uniforms.highlightRamp.value as Vector2).toArray() as [number, number],
    toneEnds: (uniforms.toneEnds.value as Vector2).toArray() as [number, number],
    occlusion,
    hollowStrength,
    openOcclusion: isFit ? kept.openOcclusion : 0,
    ground: isOfShadows(material) ? groundOf(material) : null,
    darkness: localDarkness([color.r, color.g, color.b], emitted, colorTonesOf(material, fit)),
    mirrored: shareOfRoom(material),
    opacity: opacityOf(material, geometry),
    ...{ shininess, reflectedLight, emitted, receivesShadows, fading },
  };
}

const isOfShadows = (material: HatchingMaterial): material is HatchingShadowMaterial =>
  material.isHatchingShadowMaterial;

const groundOf = ({ shadowTone, shadowFade, shadowSoftness }: HatchingShadowMaterial): GroundLook => ({
  tone: shadowTone,
  fade: shadowFade,
  softness: shadowSoftness,
});

function curveOf(curve: HatchingMaterial['toneCurve']): 'perceptual' | CurveCubics | null {
  if (curve === 'perceptual') return curve;
  return fittedCurve(curve) ?? null;
}

/** The fading of an object; null where everything has its full weight. */
export function readFading(object: Object3D, look: FadingLook | null, camera: Camera): ObjectFading | null {
  if (!takesWeight(look)) return null;
  const { composition } = look;
  const { focus, focusRadius, vignette, extent } = composition;
  const depthFading = new Vector3();
  const isMeasured = composition.depthFade !== 0 && extent !== null;
  writeDepthFading(composition, isMeasured ? seenOf(extent, camera) : null, camera, depthFading);
  const importance = importanceOf(object);
  if (depthFading.z === 0 && focus === null && vignette === 0 && importance === 1) return null;
  return {
    depthFading: [depthFading.x, depthFading.y, depthFading.z],
    focus: focus && { at: [focus.x, focus.y, focus.z], radius: focusRadius },
    ...{ vignette, sheet: sheetOf(camera) },
    importance,
  };
}

/** The fading of the outlines of a mesh, which is that of its first hatching material. */
export function readOutlineFading(mesh: Mesh, camera: Camera): ObjectFading | null {
  const materials: Material[] = Array.isArray(mesh.material) ? mesh.material : [mesh.material];
  const found = materials.find((material) => 'isHatchingMaterial' in material);
  return readFading(mesh, (found ?? null) as (Material & FadingLook) | null, camera);
}

/** The sheet of a camera, in a picture that is one wide and one high. */
function sheetOf(camera: Camera): DrawnBackground['sheet'] {
  const sheet = new Vector4();
  writeSheet(sheet, camera, new Vector4(0, 0, 1, 1));
  return sheet.toArray();
}

function seenOf({ box, frame }: SceneExtent, camera: Camera): SeenBox | null {
  const seen: SeenBox = { front: 0, back: 1, left: -1, right: 1, bottom: -1, top: 1 };
  return seenBox(box, frame.matrixWorld, camera, seen) ? seen : null;
}

/** Reads the field of lines behind a subject; undefined if the subject is not visible. */
export function readBackground(
  background: HatchingBackground,
  camera: Camera,
  { lamps, around }: SceneLights,
): DrawnBackground | undefined {
  const { subject, tone, contrast, spacing, direction, extent, ink } = background;
  const seen = subject && seenOf(subject, camera);
  if (!subject || !seen) return undefined;
  const centre = subject.box.getCenter(new Vector3()).applyMatrix4(subject.frame.matrixWorld);
  const light = new Vector3(...meanLightAt(centre.toArray(), lamps, around.skies));
  light.transformDirection(camera.matrixWorldInverse);
  return {
    ...{ tone, contrast, spacing, angle: direction, extent },
    seen: { left: seen.left, right: seen.right, bottom: seen.bottom, top: seen.top },
    lit: [light.x, light.y],
    sheet: sheetOf(camera),
    ink: `#${ink.getHexString()}`,
  };
}
