import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { type ModelExtras, movedExtras } from '../../viewer/files/common/ModelExtras.js';

/** The cameras and lights of a model's file, in the space of the upright model. */
export function extrasInWorld({ root, extras }: HatchedModel): ModelExtras {
  const { parent } = root;
  if (!parent) return extras;
  parent.updateWorldMatrix(true, false);
  return movedExtras(extras, parent.matrixWorld);
}
