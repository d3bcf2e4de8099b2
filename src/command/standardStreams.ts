import process from 'node:process';
import { MAX_BYTES } from '../viewer/files/common/ModelFile.js';

/** The argument for the standard input, as a model, and for the standard output, as a drawing. */
export const STANDARD = '-';

/** The name of the standard input in messages and file names. */
export const STANDARD_INPUT = 'stdin';

/**
 * Reads a model from the standard input to its end.
 *
 * @throws Error whose message is a single sentence, or the reason of the signal
 */
export async function readStandardInput(signal: AbortSignal): Promise<Uint8Array> {
  const { stdin } = process;
  if (stdin.isTTY) throw new Error('The model - reads the standard input, but nothing is piped into it.');
  const parts: Buffer[] = [];
  let bytes = 0;
  const onAbort = (): void => void stdin.destroy();
  signal.addEventListener('abort', onAbort, { once: true });
  try {
    for await (const part of stdin as AsyncIterable<Buffer>) {
      parts.push(part);
      bytes += part.length;
      if (bytes > MAX_BYTES)
        throw new Error(
          `The standard input has more than ${MAX_BYTES / 2 ** 20} MB, which is the most that three-hatching takes.`,
        );
    }
  } catch (error) {
    signal.throwIfAborted();
    const { code, message } = error as NodeJS.ErrnoException;
    throw new Error(code === undefined ? message : `The standard input cannot be read (${code}).`);
  } finally {
    signal.removeEventListener('abort', onAbort);
  }
  signal.throwIfAborted();
  return Buffer.concat(parts);
}

/**
 * Writes a drawing to the standard output.
 *
 * @throws Error whose message is a single sentence, if the reader closes the pipe early
 */
export function writeStandardOutput(text: string): Promise<void> {
  return new Promise((resolve, reject) => {
    process.stdout.write(text, (error) => {
      if (error) reject(new Error('The standard output was closed before the whole drawing was written.'));
      else resolve();
    });
  });
}
