export { type ApplyNodeHatchingOptions, applyHatching, type HatchedNodeScene } from './applyHatching.js';
export { HatchingNodeMaterial } from './HatchingNodeMaterial.js';
export { HatchingShadowNodeMaterial } from './HatchingShadowNodeMaterial.js';
export { HatchingOutlineNodeMaterial } from './outlines/HatchingOutlineNodeMaterial.js';
export { HatchingOutlines } from './outlines/HatchingOutlines.js';
