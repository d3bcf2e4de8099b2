import type { IUniform, Vector4 } from 'three';
import { LUMINANCE, type SurfaceFacts, type ToneFit, type ValuePlan, writeFilter } from './ToneFit.js';

/** The plan of a scene in which all is white: what comes later is as dark as it is, up to the darkest that is planned. */
export const WHITE_PLAN: ValuePlan = {
  filter: LUMINANCE,
  knots: [1, 0, 0, 0],
  bends: [0.7, -0.7, 0, 0],
  tones: null,
};

/** What of a material a fit is written with. */
interface FittedMaterial extends SurfaceFacts {
  readonly composition: { readonly exposureCompensation: number; readonly plannedValues: number };
}

/** Writes the exposure of a material from a fit. Allocates nothing. */
export function writeFit(
  { scale, offset, white, openOcclusion: open, plan }: ToneFit,
  material: FittedMaterial,
  { exposure, colorExposure, colorFilter, openOcclusion, valueKnots, valueBends }: Readonly<Record<string, IUniform>>,
): void {
  const { exposureCompensation, plannedValues } = material.composition;
  exposure.value.set(scale, offset).multiplyScalar(exposureCompensation);
  colorExposure.value = 1 / white;
  openOcclusion.value = open;
  writeFilter(plan.filter, plannedValues, colorFilter.value);
  writeValues(plan, material, valueKnots.value, valueBends.value);
}

/** A lightness so far above white that a curve which begins there has one darkness for all colours. */
const FAR_ABOVE = 2 ** 16;

/** Writes the curve of a plan for a material. Allocates nothing. */
export function writeValues(plan: ValuePlan, material: SurfaceFacts, knots: Vector4, bends: Vector4): void {
  const tone = plan.tones?.of(material);
  knots.fromArray(plan.knots);
  bends.fromArray(plan.bends);
  if (tone === undefined) return;
  knots.set(FAR_ABOVE, 0, 0, 0);
  bends.set(tone / FAR_ABOVE, 0, 0, 0);
}
