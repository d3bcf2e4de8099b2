import { counted } from './ModelError.js';

/** The kinds of changes that are made to a file when it is read, in the order in which they are listed. */
export const FILE_CHANGE_KINDS = ['orientation', 'sides', 'up', 'hidden'] as const;

/**
 * A kind of change that is made to a file when it is read. A reader leaves any of them out on request.
 *
 * | kind | the reader |
 * | --- | --- |
 * | `orientation` | turns triangles that face the wrong way |
 * | `sides` | draws surfaces from both sides, or hides their backs, other than three.js would |
 * | `up` | stands the model up, because its format or its shape suggests so |
 * | `hidden` | leaves out parts that are hidden in the file |
 */
export type FileChangeKind = (typeof FILE_CHANGE_KINDS)[number];

/** A change that was made to a file when it was read. */
export interface FileChange {
  kind: FileChangeKind;
  /** What was done, for the text behind “i”. */
  sentence: string;
}

/** The change of a file of which some parts are left out, because they are hidden in it. */
export const hiddenChange = (parts: number): FileChange[] =>
  parts === 0 ? [] : [{ kind: 'hidden', sentence: counted(parts, 'part', 'left out: hidden in the file') }];
