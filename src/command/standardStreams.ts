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

const WIDTH = 30;

/** A progress bar in a terminal. Prints nothing to streams that are no terminals, such as logs. */
export class ProgressBar {
  private shown = -1;

  constructor(private readonly stream: NodeJS.WriteStream) {}

  /** @param progress in [0, 1] */
  show(stage: string, progress: number): void {
    const percent = Math.floor(100 * progress);
    if (!this.stream.isTTY || percent === this.shown) return;
    this.shown = percent;
    const filled = Math.round(WIDTH * progress);
    this.stream.write(
      `\r${'█'.repeat(filled)}${'░'.repeat(WIDTH - filled)} ${String(percent).padStart(3)} % ${stage}\x1b[K`,
    );
  }

  /** Erases the line. */
  clear(): void {
    if (this.shown >= 0) this.stream.write('\r\x1b[K');
  }
}
