/** Tells how a task gets on: what it is at, and how far in [0, 1] where that is known. */
export type Report = (stage: string, progress?: number) => void;
