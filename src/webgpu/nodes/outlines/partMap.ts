/** The map of parts: what part is seen in each pixel, and the plane in which it lies there. */
import type { Node, NodeBuilder } from 'three/webgpu';
import { isOrthographic } from '../base/maths.js';
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';
import { deformVertex } from '../chunks/vertex.js';
import { placeOfInstance, placeOfInstanceNumber } from './points.js';

const { dFdx, dFdy, float, floor, Fn, instanceIndex, int, positionLocal, positionView, select, varying, vec4 } = tsl;

/** Counterpart of shaders/meetings/part.vert: the parts of a scene, each with a number of its own. */

/** The number of a part, or of its first instance. */
const partNumber = /* @__PURE__ */ hatchingUniform('partNumber', 'float');

/** Moves a vertex as three.js' materials do. @param isInstanced whether it is moved by the matrix of its instance too */
export function placePart(builder: NodeBuilder, isInstanced: boolean): void {
  deformVertex(builder);
  if (isInstanced) positionLocal.assign(placeOfInstance(positionLocal, placeOfInstanceNumber(int(instanceIndex))));
}

const numberAlong = (): Value => varying(partNumber.add(float(instanceIndex)));

/** Counterpart of shaders/meetings/part.frag: what the map holds of a pixel. */

/** The numbers of parts. The map is made of floats, into which every device renders, and which hold such a number with that of a look of 255. */
export const NUMBERS = 65_536;

/** The number of the material of its outlines, from 1. */
const partLook = /* @__PURE__ */ hatchingUniform('partLook', 'float');

/** The number that the map holds of the part that is drawn, from 1. */
export const numberOfPart = (): Value =>
  floor(numberAlong().add(0.5))
    .mod(NUMBERS - 1)
    .add(1);

/** Larger where it is nearer, and linear over the screen on a plane. */
export const nearnessOfPart = (): Value => select(isOrthographic(), positionView.z, float(-1).div(positionView.z));

/** Look and number, nearness, and the slope of the nearness. */
export const partWord: Node<'vec4'> = /* @__PURE__ */ Fn(() => {
  const nearness = nearnessOfPart().toVar();
  return vec4(partLook.mul(NUMBERS).add(numberOfPart()), nearness, dFdx(nearness), dFdy(nearness));
})() as unknown as Node<'vec4'>;
