#!/usr/bin/env node
import process from 'node:process';
import { draw } from './draw.js';
import { Interrupted, UsageError } from './readOptions.js';
import { ProgressBar } from './standardStreams.js';
import { tam } from './tam.js';

/** Exit codes: 0 done, 1 failed, 2 called wrongly, 130 interrupted. */
const FAILED = 1;
const MISUSED = 2;
const INTERRUPTED = 130;

const abort = new AbortController();
// SIGHUP comes when the terminal is closed.
for (const name of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) process.on(name, () => abort.abort());
// The reader of a pipe may close it early.
for (const stream of [process.stdout, process.stderr]) stream.on('error', () => {});
const bar = new ProgressBar(process.stderr);

try {
  const args = process.argv.slice(2);
  if (args[0] === 'draw') {
    const failed = await draw(args.slice(1), abort.signal, bar);
    if (failed > 0) process.exitCode = FAILED;
  } else await tam(args, abort.signal, bar);
} catch (error) {
  bar.clear();
  process.exitCode = reportError(error);
}

/** Prints the message of an error and returns the exit code. */
function reportError(error: unknown): number {
  if (abort.signal.aborted) {
    const { message } = error instanceof Interrupted ? error : new Interrupted();
    process.stderr.write(`three-hatching: ${message}\n`);
    return INTERRUPTED;
  }
  process.stderr.write(`three-hatching: ${error instanceof Error ? error.message : String(error)}\n`);
  return error instanceof UsageError ? MISUSED : FAILED;
}
