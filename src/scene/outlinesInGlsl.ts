import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import {
  HatchingOutlineMaterial,
  type HatchingOutlineParameters,
} from '../material/outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../material/outlines/HatchingOutlines.js';
import { type OutlineKind, OutlineMaker } from './OutlineMaker.js';

const IN_GLSL: OutlineKind<HatchingOutlineMaterial, HatchingOutlines> = {
  material(parameters, isDeforming) {
    const material = new HatchingOutlineMaterial(parameters);
    material.writeUniforms(isDeforming, false);
    return material;
  },
  outlines: (mesh, material) => new HatchingOutlines(mesh, material),
};

/** Makes outlines for WebGLRenderer. @throws RangeError or TypeError for a wrong parameter */
export const outlinesInGlsl = (parameters: OutlineOptions & HatchingOutlineParameters): OutlineMaker =>
  new OutlineMaker(parameters, IN_GLSL);
