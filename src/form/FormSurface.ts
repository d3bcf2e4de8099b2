import type { TriangleMesh } from '../mesh/TriangleMesh.js';
import type { HeatEquation } from '../normals/assembleHeatEquation.js';
import type { Fans } from '../normals/buildFans.js';

/** The surface that a form field is computed on. Creases are borders here: lines on one side know nothing of the other. */
export interface FormSurface {
  mesh: TriangleMesh;
  /** Twins with NO_TWIN at borders, at creases and where windings contradict each other. */
  twins: Int32Array<ArrayBuffer>;
  /** See `computeAreaNormals`. */
  areaNormals: Float64Array<ArrayBuffer>;
  /** The fans of `twins`. */
  fans: Fans;
  /** Unit normals at the scale of a stroke, three per fan. */
  normals: Float32Array<ArrayBuffer>;
  /** The curvature tensor of these normals, six floats per fan; see `fanCurvatures`. */
  tensors: Float32Array<ArrayBuffer>;
  /** A third of the area of each fan's triangles. */
  masses: Float64Array<ArrayBuffer>;
  heat: HeatEquation;
  /** The bounding radius of the mesh. */
  radius: number;
}
