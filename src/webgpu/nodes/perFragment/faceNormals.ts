/** The twin of shaders/perFragment/faceNormals.glsl. */
import { tsl, type Value } from '../base/values.js';

/** Nothing is expanded, so no face normal came along; the derivatives' one looks at the viewer by itself. View space. */
export const readFaceNormals = (): Value => tsl.normalFlat;
