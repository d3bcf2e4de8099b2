/** Counterpart of shaders/techniques/engraved/read.glsl. */
import type { NodeBuilder } from 'three/webgpu';
import type { Medium } from '../../../look/hatchingProperties.js';
import { followsForm } from '../base/followsForm.js';
import type { LineCut } from './fieldAxis.js';
import type { HatchingParameters, LinesInShadow } from './Hatching.js';
import { readHatchingParameters as readCut } from './readCut.js';
import { readHatchingParameters as readForm } from './readForm.js';

/** The parameters of engraving at this fragment. @param cut the field that lines are level sets of */
export const read = (builder: NodeBuilder, cut: LineCut, medium: Medium, shadow: LinesInShadow): HatchingParameters =>
  followsForm(cut.lineField)
    ? readForm(builder, { isAcross: cut.lineField === 'acrossForm', medium }, shadow)
    : readCut(builder, cut, shadow);
