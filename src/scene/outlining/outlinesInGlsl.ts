import type { OutlineOptions } from '../../geometry/PrepareHatchingGeometryOptions.js';
import { HatchingOutlineMaterial, type HatchingOutlineParameters } from '../../outlines/HatchingOutlineMaterial.js';
import { HatchingOutlines } from '../../outlines/HatchingOutlines.js';
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
