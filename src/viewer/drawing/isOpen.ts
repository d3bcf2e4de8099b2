import type { ModelStatistics } from './HatchedModel.js';

/** Whether back faces can be visible: the surface has borders, or its windings are inconsistent. */
export const isOpen = ({
  borderEdges,
  unpairedEdges,
  inconsistentEdges,
}: Pick<ModelStatistics, 'borderEdges' | 'unpairedEdges' | 'inconsistentEdges'>): boolean =>
  borderEdges + unpairedEdges + inconsistentEdges > 0;
