/** Reports the progress of a task: what it is doing, and how far it is in [0, 1] if that is known. */
export type Report = (stage: string, progress?: number) => void;
