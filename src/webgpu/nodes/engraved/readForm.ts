/** Counterpart of shaders/techniques/engraved/readForm.glsl: lines that follow the form, level sets of two baked functions. */
import type { NodeBuilder } from 'three/webgpu';
import { FORM_CONSTANTS, HAND_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import type { Medium } from '../../../look/hatchingProperties.js';
import { tsl, type Value } from '../base/values.js';
import { isInFullShadow } from '../perFragment/fullShadow.js';
import { screenGradient, screenMap, triangleOnScreen } from '../perFragment/screenGradient.js';
import { readViewToAnchor } from '../perFragment/viewToAnchor.js';
import { objectToField } from './emit.js';
import type { HatchingParameters, LinesInShadow } from './Hatching.js';
import { handmade, handPoint, handPressure, slowWaves } from './hand.js';
import { vFieldNormal, vFieldPoint, vForm, vFormCrossing } from './varyings.js';

const { dot, float, If, length, normalize, vec2, vec3 } = tsl;
const { COARSEST_OCTAVES, WIDTH_WAVE } = FORM_CONSTANTS;

const formValueAt = (form: Value, stray: Value): Value =>
  form.w.add(dot(form.xyz, vFieldPoint.mul(0.5).add(stray))).toVar();

/** @param isAcross whether the first family runs across the form */
export function readHatchingParameters(
  builder: NodeBuilder,
  { isAcross, medium }: { isAcross: boolean; medium: Medium },
  { lights, receivedShadows, shadowLeft }: LinesInShadow,
): HatchingParameters {
  const first = vForm.toVar();
  const crossing = vFormCrossing.toVar();
  const [along, across] = isAcross ? [...COARSEST_OCTAVES].reverse() : COARSEST_OCTAVES;
  const coarsest = vec2(along, across).toVar();
  const isDark = isInFullShadow(lights, receivedShadows);
  if (isDark) {
    // Where no light arrives the families change places.
    If(isDark, () => {
      first.assign(vFormCrossing);
      crossing.assign(vForm);
      coarsest.assign(vec2(across, along));
    });
  }
  const waves = slowWaves(vFieldPoint.mul(HAND_CONSTANTS.HAND_WAVES)).toVar();
  const stray = handPoint(vec3(0), waves).toVar();
  // Strokes and cuts have variations of their own.
  const differs = medium === 'pen' || medium === 'woodcut';
  const ofHand = handPressure(waves);
  const pressure = differs ? ofHand : ofHand.add(handmade.mul(WIDTH_WAVE).mul(waves.z));
  const values = [formValueAt(first, stray), formValueAt(crossing, stray)];
  const viewToField = objectToField.mul(readViewToAnchor(builder)).toVar();
  const onScreen = screenMap(normalize(vFieldNormal).toVar(), viewToField);
  const triangle = triangleOnScreen(viewToField);
  const valueOnScreen = screenGradient(first.xyz, onScreen).toVar();
  const crossingOnScreen = screenGradient(crossing.xyz, onScreen).toVar();
  return {
    onScreen,
    shadowLeft,
    pressure: pressure.toVar(),
    has: float(1),
    shareB: float(1),
    firstFamily: () => ({
      value: values[0],
      perPixel: length(valueOnScreen),
      seen: length(screenGradient(first.xyz, triangle)),
      rise: length(first.xyz),
      gradient: first.xyz,
      coarsest: coarsest.x,
      isOfForm: true,
    }),
    // The other family crosses at the angle of the bake. The difference of the two functions is whole across seams too, and its lines lean
    // the other way.
    crossingFamily(_isB, _lean, isOther) {
      const gradient = isOther ? first.xyz.sub(crossing.xyz).toVar() : crossing.xyz;
      return {
        value: isOther ? values[0].sub(values[1]) : values[1],
        perPixel: length(isOther ? valueOnScreen.sub(crossingOnScreen) : crossingOnScreen),
        seen: length(screenGradient(gradient, triangle)),
        rise: length(crossing.xyz),
        gradient,
        coarsest: isOther ? Math.min(along, across) : coarsest.y,
        isOfForm: true,
      };
    },
  };
}
