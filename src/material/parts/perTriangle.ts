import { bindVertices, compilePrePass } from '../deformation/bindVertices.js';
import type { MaterialPart } from './MaterialPart.js';

/** The techniques whose strokes lie in triangles: `triangle` and `adjacency`. */
export const part: MaterialPart = {
  files: import.meta.glob(['./techniques/{triangle,adjacency}/*', './perTriangle/*'], {
    base: '../../../shaders',
    query: '?raw',
    import: 'default',
    eager: true,
  }),
  bindMesh: bindVertices,
  compile: compilePrePass,
};
