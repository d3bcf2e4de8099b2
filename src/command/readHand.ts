import { readFileSync, statSync } from 'node:fs';
import { checkHand } from '../strokes/hand/checkHand.js';
import type { Hand } from '../strokes/hand/Hand.js';
import { UsageError } from './errors.js';

/** The maximum size of a file, in bytes: 100,000 points take less than a tenth of it. */
const MAX_BYTES = 64 * 2 ** 20;

/** Messages for error codes of the file system, about the file after --hand. */
const MEANINGS: Readonly<Record<string, string>> = {
  ENOENT: 'is not there; check the path after --hand',
  ENOTDIR: 'is not there; check the path after --hand',
  EISDIR: 'is a folder; name the JSON file of a hand after --hand',
  EACCES: 'may not be read; change its permissions',
  EPERM: 'may not be read; change its permissions',
};

/**
 * Reads the JSON file of a hand.
 *
 * @throws UsageError whose message is a sentence, if it cannot be read or is no hand
 */
export function readHand(path: string): Hand {
  const text = readText(path);
  let hand: unknown;
  try {
    hand = JSON.parse(text);
  } catch {
    throw new UsageError(`${path} is not JSON; --hand needs a file with { version, strokes, numbers }.`);
  }
  try {
    checkHand(path, hand);
  } catch (error) {
    throw new UsageError((error as Error).message);
  }
  return hand;
}

function readText(path: string): string {
  try {
    const { size } = statSync(path);
    if (size > MAX_BYTES) throw new UsageError(`${path} is larger than 64 MB, more than any hand needs.`);
    return readFileSync(path, 'utf8');
  } catch (error) {
    if (error instanceof UsageError) throw error;
    const { code } = error as NodeJS.ErrnoException;
    throw new UsageError(`${path} ${MEANINGS[code ?? ''] ?? `could not be read (${code})`}.`);
  }
}
