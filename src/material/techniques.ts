import type { ToneNormal } from './shaderConventions.js';

/**
 * How strokes are laid on the surface.
 * - `triangle`: Algorithm 1 alone. Every triangle has its own strokes; they break at its edges (paper, figure 4a).
 * - `adjacency`: Algorithms 1 to 3. Every triangle blends in the strokes of its three neighbours (figure 4b).
 * - `anchored`: beyond the paper. Strokes are anchored to a lattice fixed on the object instead of to triangles, and ink
 *   is decided per pixel, after blending: continuous, crisp and independent of the mesh.
 */
export type HatchingTechnique = 'triangle' | 'adjacency' | 'anchored';

/** What the material needs to know of a technique; all else lies in its folder of chunks, `shaders/techniques/<name>`. */
export interface Technique {
  /** What it asks of a geometry's vertices: the primitive of six, or a normal at the scale of a stroke. */
  vertexData: 'adjacency' | 'hatchNormal';
  /** The texture it reads, unless the material is crisp: that takes thresholds. */
  map: 'tonalArtMap' | 'thresholdMap';
  /** The normal tone is computed from where none is asked for. */
  toneNormal: ToneNormal;
}

/** One row and one folder of chunks for each way to lay strokes on a surface. */
export const techniques: Readonly<Record<HatchingTechnique, Technique>> = {
  triangle: { vertexData: 'adjacency', map: 'tonalArtMap', toneNormal: 'face' },
  adjacency: { vertexData: 'adjacency', map: 'tonalArtMap', toneNormal: 'face' },
  anchored: { vertexData: 'hatchNormal', map: 'thresholdMap', toneNormal: 'smooth' },
};
