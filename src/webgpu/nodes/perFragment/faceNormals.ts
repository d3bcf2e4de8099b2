/** Counterpart of shaders/perFragment/faceNormals.glsl. */
import { tsl, type Value } from '../base/values.js';

/** The face normal, view space, from screen-space derivatives, which faces the viewer: the geometry has no attribute for it. */
export const readFaceNormals = (): Value => tsl.normalFlat;
