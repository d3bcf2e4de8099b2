/** The twin of shaders/techniques/engraved/read.glsl. */
import type { NodeBuilder } from 'three/webgpu';
import { followsForm } from '../../base/followsForm.js';
import type { HatchingParameters } from './Hatching.js';
import { readHatchingParameters as readCut } from './readCut.js';
import { readHatchingParameters as readForm } from './readForm.js';

/** What engraving needs to know at this fragment. @param lineField the choice */
export const read = (builder: NodeBuilder, lineField: string): HatchingParameters =>
  followsForm(lineField) ? readForm(builder, lineField === 'acrossForm') : readCut(builder);
