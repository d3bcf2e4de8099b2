/** Reports progress: the current step and, if known, how far it is in [0, 1]. */
export type Report = (stage: string, progress?: number) => void;
