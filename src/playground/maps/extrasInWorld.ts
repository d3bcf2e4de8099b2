import type { HatchedModel } from '../../viewer/drawing/HatchedModel.js';
import { type ModelExtras, movedExtras } from '../../viewer/files/common/ModelExtras.js';

/** What the file of a model offers, where the model stands upright. */
export function extrasInWorld({ root, extras }: HatchedModel): ModelExtras {
  const { parent } = root;
  if (!parent) return extras;
  parent.updateWorldMatrix(true, false);
  return movedExtras(extras, parent.matrixWorld);
}
