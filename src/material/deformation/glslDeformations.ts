import type { WebGLRenderer } from 'three';
import { Deformations } from './Deformations.js';
import { PrePass } from './PrePass.js';

/** The deformations of WebGLRenderer. Their key is `properties`, which three.js replaces when a lost context is restored. */
export const glslDeformations: Deformations<WebGLRenderer> = /* @__PURE__ */ new Deformations(
  ({ properties }) => properties,
  (renderer, geometry, vertices) => new PrePass(renderer, geometry, vertices),
);
