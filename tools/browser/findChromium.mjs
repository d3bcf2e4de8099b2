import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from '@playwright/test';
import { installNpmChromium, npmChromiumSupported } from './installNpmChromium.mjs';

/**
 * Finds a Chromium, in this order: the one named by the environment variable HATCH_CHROMIUM; the one that npm carries, whose version is pinned, so
 * that pictures and limits are the same everywhere; Playwright's own; one installed on the system. HATCH_CHROMIUM may also be a route, `npm`,
 * `playwright` or `system`, and then only that route is tried.
 *
 * @returns {Promise<{ executablePath: string, route: string, version: string }>}
 * @throws when there is none, naming the remedies.
 */
export async function findChromium() {
  const wish = process.env.HATCH_CHROMIUM;
  const routes = {
    npm: async () => (npmChromiumSupported ? [await installNpmChromium()] : []),
    playwright: () => [chromium.executablePath()],
    system: systemCandidates,
  };
  const tried = [];
  const firstUsable = async (route, candidates) => {
    for (const executablePath of await candidates()) {
      if (!existsSync(executablePath)) continue;
      try {
        return { executablePath, route, version: versionOf(executablePath) };
      } catch (error) {
        tried.push(`${executablePath} does not start (${firstLine(error)})`);
      }
    }
    return undefined;
  };

  if (wish && !(wish in routes)) {
    const found = await firstUsable('HATCH_CHROMIUM', () => [wish]);
    if (found) return found;
    throw new Error(
      `findChromium: HATCH_CHROMIUM names ${wish}, which ${tried.length ? 'does not start' : 'does not exist'}; give the path of a Chromium or unset it.`,
    );
  }
  for (const [route, candidates] of Object.entries(routes)) {
    if (wish && wish !== route) continue;
    try {
      const found = await firstUsable(route, candidates);
      if (found) return found;
    } catch (error) {
      tried.push(`the ${route} route failed (${firstLine(error)})`);
    }
  }
  throw new Error(
    'findChromium: no Chromium found; set HATCH_CHROMIUM to the path of one, or run "npx playwright install chromium", ' +
      `or install your system's chromium package.${tried.map((reason) => ` Tried: ${reason}.`).join('')}`,
  );
}

/** Paths where operating systems install a Chromium, the most common first. */
function systemCandidates() {
  if (process.platform === 'darwin') {
    return ['/Applications', join(process.env.HOME ?? '', 'Applications')].flatMap((folder) => [
      `${folder}/Chromium.app/Contents/MacOS/Chromium`,
      `${folder}/Google Chrome.app/Contents/MacOS/Google Chrome`,
    ]);
  }
  if (process.platform === 'win32') {
    const roots = [process.env.LOCALAPPDATA, process.env.PROGRAMFILES, process.env['PROGRAMFILES(X86)']];
    return roots
      .filter((root) => root !== undefined)
      .flatMap((root) => [
        join(root, 'Chromium', 'Application', 'chrome.exe'),
        join(root, 'Google', 'Chrome', 'Application', 'chrome.exe'),
      ]);
  }
  const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chromium-headless-shell'];
  const folders = [...(process.env.PATH ?? '').split(delimiter), '/usr/bin', '/usr/local/bin', '/snap/bin'];
  return names.flatMap((name) => folders.filter(Boolean).map((folder) => join(folder, name)));
}

/** The version that the browser prints, which also shows that it starts. Chrome on Windows would open a window instead. */
function versionOf(executablePath) {
  if (process.platform === 'win32') return 'Chromium';
  const output = execFileSync(executablePath, ['--version'], {
    encoding: 'utf8',
    timeout: 30_000,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  return output.trim().split('\n').at(-1) ?? '';
}

function firstLine(error) {
  const text = String(error?.stderr || error?.message || error).trim();
  return text.split('\n')[0];
}
