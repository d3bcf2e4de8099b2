/** Counterpart of shaders/techniques/engraved/readCut.glsl: lines that are level sets of a field in space. */
import type { NodeBuilder } from 'three/webgpu';
import { FIELD_CONSTANTS, HAND_CONSTANTS } from '../../../look/constants/engravedConstants.js';
import { tsl } from '../base/values.js';
import { screenGradient, screenMap, triangleOnScreen } from '../perFragment/screenGradient.js';
import { readViewToAnchor } from '../perFragment/viewToAnchor.js';
import { objectToField } from './emit.js';
import { across, fieldAt, type LineCut } from './fieldAxis.js';
import { fieldHere } from './fieldHere.js';
import type { HatchingParameters, LinesInShadow } from './Hatching.js';
import { handPoint, handPressure, slowWaves } from './hand.js';
import { vFieldNormal, vFieldPoint } from './varyings.js';

const { cross, dot, float, length, max, min, mix, normalize, smoothstep, sqrt } = tsl;
const { BARE_SLOPE, SIDE_FADE, SPARSEST_SLOPE } = FIELD_CONSTANTS;

export function readHatchingParameters(
  builder: NodeBuilder,
  cut: LineCut,
  { lights, receivedShadows, shadowLeft }: LinesInShadow,
): HatchingParameters {
  const field = fieldHere(builder, cut, lights, receivedShadows);
  const place = vFieldPoint.toVar();
  const normal = normalize(vFieldNormal).toVar();
  const waves = slowWaves(place.mul(HAND_CONSTANTS.HAND_WAVES)).toVar();
  const point = handPoint(place, waves).toVar();
  const viewToField = objectToField.mul(readViewToAnchor(builder)).toVar();
  const onScreen = screenMap(normal, viewToField);
  const triangle = triangleOnScreen(viewToField);
  const { value, gradient } = fieldAt(field, point);
  const along = dot(normal, gradient).toVar();
  const slope = sqrt(max(float(1).sub(along.mul(along)), 1e-12)).toVar();
  const has = smoothstep(BARE_SLOPE[0], BARE_SLOPE[1], slope).toVar();
  const sideB = across(field.xyz).toVar();
  const sideC = cross(field.xyz, sideB).toVar();
  const b = dot(normal, sideC).toVar();
  const c = dot(normal, sideB).toVar();
  const between = b
    .mul(b)
    .sub(c.mul(c))
    .div(max(slope.mul(slope), 1e-4));
  const shareB = mix(1, smoothstep(-SIDE_FADE, SIDE_FADE, between), has).toVar();
  const valueOnScreen = screenGradient(gradient, onScreen).toVar();
  return {
    onScreen,
    shadowLeft,
    pressure: handPressure(waves).toVar(),
    has,
    shareB,
    firstFamily: () => ({
      value,
      perPixel: length(valueOnScreen),
      seen: length(screenGradient(gradient, triangle)),
      rise: min(slope.div(SPARSEST_SLOPE), 1),
      gradient,
      coarsest: FIELD_CONSTANTS.ANY_OCTAVE,
      isOfForm: false,
    }),
    crossingFamily(isB, [cosine, sine]) {
      const side = isB ? sideB : sideC;
      const leaning = gradient.mul(cosine).add(side.mul(sine)).toVar();
      return {
        value: cosine.mul(value).add(sine.mul(dot(point, side))),
        perPixel: length(valueOnScreen.mul(cosine).add(screenGradient(side, onScreen).mul(sine))),
        seen: length(screenGradient(leaning, triangle)),
        rise: float(1),
        gradient: leaning,
        coarsest: FIELD_CONSTANTS.ANY_OCTAVE,
        isOfForm: false,
      };
    },
  };
}
