import type { OutlineOptions } from '../../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingOutlineParameters } from '../../material/outlines/HatchingOutlineMaterial.js';
import { type OutlineKind, OutlineMaker } from '../../scene/OutlineMaker.js';
import { HatchingOutlineNodeMaterial } from './HatchingOutlineNodeMaterial.js';
import { HatchingOutlines } from './HatchingOutlines.js';

type MakerOfNodes = OutlineMaker<HatchingOutlineNodeMaterial, HatchingOutlines>;

const OF_NODES: OutlineKind<HatchingOutlineNodeMaterial, HatchingOutlines> = {
  material: (parameters) => new HatchingOutlineNodeMaterial(parameters),
  outlines: (mesh, material) => new HatchingOutlines(mesh, material),
};

/** Makes outlines for WebGPURenderer. @throws RangeError or TypeError for an invalid parameter */
export const outlinesOfNodes = (parameters: OutlineOptions & HatchingOutlineParameters): MakerOfNodes =>
  new OutlineMaker(parameters, OF_NODES);
