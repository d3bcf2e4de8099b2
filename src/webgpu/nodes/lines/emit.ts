/** Counterpart of shaders/techniques/lines/emit.glsl. */
import type { Light, SkinnedMesh } from 'three';
import type { NodeBuilder } from 'three/webgpu';
import { inverseOf, linearPart } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import type { Anchor } from '../chunks/anchor.js';
import { followsForm } from '../chunks/lightOrientation.js';
import { bonesOf, inObjectSpace } from '../chunks/vertex.js';
import {
  type DirectionChoices,
  fieldLight,
  firstField,
  formCrossing,
  formSlope,
  formValue,
  formVarying,
  isByVertex,
  turnsWithLight,
  vField,
  vFieldLight,
  vFieldNormal,
  vFieldPoint,
  vForm,
  vFormCrossing,
} from './fields.js';

const { determinant, If, vec4 } = tsl;

const fieldOrigin = /* @__PURE__ */ hatchingUniform('fieldOrigin', 'vec3');
export const objectToField: Value = /* @__PURE__ */ hatchingUniform('objectToField', 'mat3');
const objectToFieldNormal = /* @__PURE__ */ hatchingUniform('objectToFieldNormal', 'mat3');

/** @param field choices of the field that lines are level sets of */
export function emitLines(
  builder: NodeBuilder,
  anchor: Anchor,
  { field, isAtRest, lights }: { field: DirectionChoices; isAtRest: boolean; lights: readonly Light[] },
): void {
  const { direction } = field;
  vFieldPoint.assign(objectToField.mul(anchor.position.sub(fieldOrigin)));
  vFieldNormal.assign(objectToFieldNormal.mul(anchor.strokeNormal));
  if (followsForm(direction)) {
    const along = formVarying(formSlope(), formValue().x, objectToFieldNormal, vFieldPoint);
    const across = formVarying(formCrossing(), formValue().y, objectToFieldNormal, vFieldPoint);
    const isAcross = direction === 'acrossForm';
    vForm.assign(isAcross ? across : along);
    vFormCrossing.assign(isAcross ? along : across);
    return;
  }
  const light = turnsWithLight(field) ? lightOfField(builder, anchor, isAtRest, lights) : vec4(0, 1, 0, 0);
  if (isByVertex(field)) vField.assign(firstField(light, field));
  else vFieldLight.assign(light);
}

function lightOfField(
  { object }: NodeBuilder,
  { objectToView, viewToObject }: Anchor,
  isAtRest: boolean,
  lights: readonly Light[],
): Value {
  let restToView = objectToView;
  let viewToRest = viewToObject;
  if (isAtRest && (object as SkinnedMesh).isSkinnedMesh) {
    // The light in the space of the first bone, which stands for the mesh: by bone, lines would break at joints.
    const firstBone = inObjectSpace(bonesOf(object as SkinnedMesh).element(0));
    restToView = objectToView.toVar();
    viewToRest = viewToObject.toVar();
    If(determinant(linearPart(firstBone)).notEqual(0), () => {
      restToView.assign(objectToView.mul(firstBone));
      viewToRest.assign(inverseOf(linearPart(restToView)));
    });
  }
  return fieldLight(objectToField.mul(viewToRest).toVar(), restToView.mul(vec4(fieldOrigin, 1)).xyz.toVar(), lights);
}
