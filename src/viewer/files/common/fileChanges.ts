import { counted } from './ModelError.js';

/** The kinds of changes that are made to a file when it is read, in the order in which they are listed. */
export const FILE_CHANGE_KINDS = ['orientation', 'sides', 'up', 'hidden', 'ceiling'] as const;

/**
 * A kind of change that is made to a file when it is read. Each has a switch: on request, `sides` is done, and any of the others is not.
 *
 * | kind | the reader | usually |
 * | --- | --- | --- |
 * | `orientation` | turns triangles that face the wrong way, and computes normals again that contradict them | done |
 * | `sides` | draws both sides of surfaces, also where a glTF file has one | not done |
 * | `up` | stands the model up, because its format or its shape suggests so | done |
 * | `hidden` | leaves out parts that are hidden in the file | done |
 * | `ceiling` | leaves out the ceiling of closed rooms | done |
 */
export type FileChangeKind = (typeof FILE_CHANGE_KINDS)[number];

/** How a file is read; by default as usual. */
export interface HowRead {
  /** Material variant of a glTF file: its index, or as text its name or its number counted from 1. */
  readonly variant?: string | number | undefined;
  /** Kinds of changes that are switched from what is usual, in the order of `FILE_CHANGE_KINDS`. */
  readonly switched?: readonly FileChangeKind[] | undefined;
}

/** A change that was made to a file when it was read. */
export interface FileChange {
  kind: FileChangeKind;
  /** What was done, for the text behind “i”. */
  sentence: string;
}

/** The change of a file of which some parts are left out, because they are hidden in it. */
export const hiddenChange = (parts: number): FileChange[] =>
  parts === 0 ? [] : [{ kind: 'hidden', sentence: counted(parts, 'part', 'left out: hidden in the file') }];
