import type { ModelStatistics } from './HatchedModel.js';

/** Whether the backs of triangles can be seen: the surface ends somewhere, or the windings contradict each other. */
export const isOpen = ({
  borderEdges,
  unpairedEdges,
  inconsistentEdges,
}: Pick<ModelStatistics, 'borderEdges' | 'unpairedEdges' | 'inconsistentEdges'>): boolean =>
  borderEdges + unpairedEdges + inconsistentEdges > 0;
