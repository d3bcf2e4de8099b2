import { spawn } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';

/** The path of a program of one of these names, or undefined. */
export function findProgram(...names) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return names.flatMap((name) => folders.map((folder) => join(folder, name))).find(isProgram);
}

/** The Firefox in the environment variable HATCH_FIREFOX, or one of the system. */
export function findFirefox() {
  return process.env.HATCH_FIREFOX ?? findProgram('firefox-esr', 'firefox');
}

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/**
 * Starts a display without a screen: Firefox has no WebGL where it shows no window.
 *
 * @param {string} xvfb its path
 * @returns {Promise<{ display: string, close(): void }>}
 */
export async function startDisplay(xvfb) {
  const server = spawn(xvfb, ['-displayfd', '3', '-screen', '0', '1280x1024x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const display = await new Promise((resolve, reject) => {
    // Xvfb writes its display number when it is ready.
    server.stdio[3].once('data', (number) => resolve(`:${String(number).trim()}`));
    server.once('error', reject);
    server.once('exit', () => reject(new Error('startDisplay: Xvfb ended before it was ready.')));
  });
  return { display, close: () => void server.kill() };
}
