/** Counterpart of shaders/techniques/anchored/read.glsl: the frame of strokes, found per fragment so that it turns continuously. */
import type { Light } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { followsForm } from '../base/followsForm.js';
import type { ReceivedShadow } from '../base/ReceivedShadow.js';
import { tsl, type Value } from '../base/values.js';
import { safeNormalize } from '../chunks/safeNormalize.js';
import { isInFullShadow } from '../perFragment/fullShadow.js';
import { readViewToAnchor } from '../perFragment/viewToAnchor.js';
import { readStrokeAxes as readForm } from './readForm.js';
import { readStrokeAxes as readLight } from './readLight.js';
import { readStrokeAxes as readSheet } from './readSheet.js';
import type { StrokeAxes } from './StrokeAxes.js';
import { vRestPosition, vStrokeNormal, vToViewer } from './varyings.js';

const { dot, vec3 } = tsl;

/** The parameters of hatching at a fragment. */
export interface HatchingParameters extends StrokeAxes {
  /** Object space. */
  point: Value;
  /** Unit, object space. */
  normal: Value;
  /** Components of the direction to the viewer along u, v and the normal, of any length. */
  lean: Value;
}

/** @param strokeField the choice @param receivedShadows lights that cast shadows */
export function readHatchingParameters(
  builder: NodeBuilder,
  lights: readonly Light[],
  strokeField: string,
  receivedShadows: readonly ReceivedShadow[],
): HatchingParameters {
  const n = safeNormalize(vStrokeNormal);
  const viewToAnchor = readViewToAnchor(builder);
  let axes: StrokeAxes;
  if (followsForm(strokeField))
    axes = readForm(n, strokeField === 'acrossForm', isInFullShadow(lights, receivedShadows));
  else if (strokeField === 'sheet') axes = readSheet(n, viewToAnchor);
  else axes = readLight(n, lights, viewToAnchor, receivedShadows);
  const lean = vec3(dot(vToViewer, axes.uAxis), dot(vToViewer, axes.vAxis), dot(vToViewer, n)).toVar();
  return { ...axes, point: vRestPosition.toVar(), normal: n, lean };
}
