import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { readAmd } from './readAmd.mjs';
import { readIntel } from './readIntel.mjs';

/**
 * @typedef {import('./readIntel.mjs').Listing & { registers: number | null }} Compiled
 */

/** The chips that are compiled for, and the groups of pixels that they shade, by width. */
export const CHIPS = {
  intel: {
    name: 'Tiger Lake',
    shim: 'intel.so',
    env: { INTEL_STUB_GPU_PLATFORM: 'tgl', INTEL_DEBUG: 'fs' },
    blocks: { 8: [4, 2], 16: [4, 4], 32: [8, 4] },
  },
  amd: {
    name: 'RDNA 2',
    shim: 'amd.so',
    env: { AMDGPU_GPU_ID: 'navi21', AMD_DEBUG: 'useaco,ps,asm,nooptvariant' },
    blocks: { 32: [8, 4], 64: [8, 8] },
  },
};

/** The driver lists from several threads, so that lines can be lost: a listing counts once it has come twice. */
const ATTEMPTS = 6;

/**
 * Compiles the shaders of a program for a chip with what `build.sh` has built.
 *
 * @param {string} folder - that of `build.sh`
 * @param {keyof typeof CHIPS} chip
 * @param {{ vertex: string, fragment: string }} shaders - in GLSL ES 3.00
 * @param {readonly number[]} [bits] - of the numbers that mark branches
 * @returns {Compiled}
 * @throws if the folder was not built, or the shaders do not compile
 */
export function compile(folder, chip, { vertex, fragment }, bits = []) {
  const program = resolve(folder, 'printCode');
  if (!existsSync(program))
    throw new Error(
      `tools/instructions: ${folder} holds no compilers; build them with tools/instructions/compilers/build.sh ${folder}.`,
    );
  const { shim, env } = CHIPS[chip];
  const sources = mkdtempSync(join(tmpdir(), 'hatching-instructions-'));
  try {
    const files = [join(sources, 'shader.vert'), join(sources, 'shader.frag')];
    writeFileSync(files[0], vertex);
    writeFileSync(files[1], fragment);
    const list = () => {
      const { stdout, stderr } = spawnSync(program, files, {
        env: {
          ...process.env,
          ...env,
          GALLIUM_THREAD: '0',
          MESA_SHADER_CACHE_DISABLE: '1',
          LD_LIBRARY_PATH: resolve(folder, 'libraries'),
          LD_PRELOAD: resolve(folder, 'shims', shim),
        },
        encoding: 'utf8',
        maxBuffer: 2 ** 28,
      });
      if (!stdout.includes('\nDONE'))
        throw new Error(`tools/instructions: ${CHIPS[chip].name} does not compile: ${stdout.slice(-2000)}`);
      return chip === 'intel' ? ofIntel(stderr, bits) : ofAmd(stdout, stderr, bits);
    };
    let before = '';
    for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
      const listing = list();
      const text = JSON.stringify(listing);
      if (text === before) return listing;
      before = text;
    }
    throw new Error(`tools/instructions: no two listings of ${CHIPS[chip].name} agree.`);
  } finally {
    rmSync(sources, { recursive: true, force: true });
  }
}

/** Intel's registers are shared out by the width that fits them. */
const ofIntel = (stderr, bits) => ({ ...readIntel(stderr, new Set(bits)), registers: null });

function ofAmd(stdout, stderr, bits) {
  const [, registers, width] = /VGPRS: (\d+) .*\(PS, W(\d+)\)/.exec(stdout) ?? [];
  if (!registers) throw new Error('tools/instructions: RDNA 2 tells no registers.');
  return { width: Number(width), ...readAmd(stderr, new Set(bits)), registers: Number(registers) };
}
