import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const source = new URL('./driver/', import.meta.url);
const { dependencies } = JSON.parse(readFileSync(new URL('package.json', source), 'utf8'));
const VERSION = dependencies['puppeteer-core'];
const cache = fileURLToPath(new URL(`../../node_modules/.cache/three-hatching/firefox-${VERSION}`, import.meta.url));

/**
 * Installs puppeteer-core (by a lockfile with its hash), once. It is no dependency of the project: it brings eighty packages, which only
 * these tests need.
 *
 * @returns {Promise<{ launch(options: object): Promise<object> }>}
 */
export async function installDriver() {
  if (!existsSync(join(cache, 'node_modules', 'puppeteer-core', 'package.json'))) {
    console.log(`Fetching puppeteer-core ${VERSION} into node_modules/.cache ...`);
    mkdirSync(cache, { recursive: true });
    for (const file of ['package.json', 'package-lock.json']) copyFileSync(new URL(file, source), join(cache, file));
    execFileSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
      cwd: cache,
      stdio: ['ignore', 'ignore', 'inherit'],
    });
  }
  const path = createRequire(join(cache, 'package.json')).resolve('puppeteer-core');
  return (await import(pathToFileURL(path).href)).default;
}
