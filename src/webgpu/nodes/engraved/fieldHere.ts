/** Counterpart of shaders/techniques/engraved/fieldHere.glsl: the field at this fragment. */
import type { Light } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import { tsl, type Value } from '../base/values.js';
import { isInFullShadow } from '../perFragment/fullShadow.js';
import { readViewToAnchor } from '../perFragment/viewToAnchor.js';
import { objectToField } from './emit.js';
import { across, firstField, isByVertex, type LineCut } from './fieldAxis.js';
import { fieldLight } from './lightField.js';
import { vField, vFieldLight, vFieldPoint } from './varyings.js';

const { If, positionView, select, vec4 } = tsl;

/**
 * The light of the field, from the lights that arrive; where none does, a direction across it. It is constant where the same lights arrive.
 */
function arrivingLight(
  builder: NodeBuilder,
  lights: readonly Light[],
  receivedShadows: readonly ReceivedShadow[],
): Value {
  const shadowed = receivedShadows.flatMap(({ isShadowed }) => isShadowed ?? []);
  if (shadowed.length === 0) return vFieldLight;
  const isDark = isInFullShadow(lights, receivedShadows);
  const light = vFieldLight.toVar();
  if (isDark) light.assign(select(isDark, vec4(across(vFieldLight.xyz), 0), vFieldLight));
  if (isDark && shadowed.length === 1) return light;
  const isAny = shadowed.reduce((any, one) => any.or(one));
  If(isDark ? isAny.and(isDark.not()) : isAny, () => {
    const viewToField = objectToField.mul(readViewToAnchor(builder)).toVar();
    light.assign(fieldLight(viewToField, positionView, lights, { receivedShadows, fromOrigin: vFieldPoint }));
  });
  return light;
}

export const fieldHere = (
  builder: NodeBuilder,
  cut: LineCut,
  lights: readonly Light[],
  receivedShadows: readonly ReceivedShadow[],
): Value =>
  (isByVertex(cut) ? vField : firstField(arrivingLight(builder, lights, receivedShadows).toVar(), cut)).toVar();
