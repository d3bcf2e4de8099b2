/** The twin of shaders/perFragment/faceNormals.glsl. */
import { BackSide, DoubleSide, type Material } from 'three';
import { tsl, type Value } from '../base/values.js';

const { frontFacing, normalFlat, normalViewGeometry, select } = tsl;

/** It looks at the viewer by itself. View space. */
export const readFaceNormals = (): Value => normalFlat;

/** The normal of the vertices, where tone is taken from faces: turned towards the side that is seen. Unit, view space. */
export function smoothNormal({ side }: Material): Value {
  const turned = normalViewGeometry.negate();
  if (side === BackSide) return turned;
  return side === DoubleSide ? select(frontFacing, normalViewGeometry, turned) : normalViewGeometry;
}
