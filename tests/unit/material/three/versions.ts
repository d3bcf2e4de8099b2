import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { vi } from 'vitest';

/** A version of three.js that tests draw with. */
export interface ThreeVersion {
  name: string;
  folder: string;
}

const installed = (name: string): ThreeVersion => ({ name, folder: join(process.cwd(), 'node_modules', name) });

/** The oldest, a middle and the installed version; and the newest published one, where `npm run canary` has installed it. */
export const VERSIONS: readonly ThreeVersion[] = [
  ...['three-oldest', 'three-middle', 'three'].map(installed),
  ...(process.env.HATCH_CANARY ? [{ name: 'newest published', folder: process.env.HATCH_CANARY }] : []),
];

/** The text of a shader chunk. */
export function chunkOf({ folder }: ThreeVersion, chunk: string): string {
  const text = readFileSync(join(folder, `src/renderers/shaders/ShaderChunk/${chunk}.glsl.js`), 'utf8');
  return /`([\s\S]*)`/.exec(text)![1];
}

/**
 * Loads a version in the place of `three`, and modules of the library with it. Undo it with {@link withoutVersion}.
 *
 * @param modules gives the modules, by dynamic imports
 */
export async function withVersion<Modules>({ folder }: ThreeVersion, modules: () => Promise<Modules>) {
  vi.resetModules();
  // Old versions need `self` when they are imported.
  vi.stubGlobal('self', globalThis);
  const three: typeof import('three') = await import(
    /* @vite-ignore */ pathToFileURL(join(folder, 'build/three.module.js')).href
  );
  vi.doMock('three', () => three);
  return { three, ...(await modules()) };
}

export function withoutVersion(): void {
  vi.doUnmock('three');
  vi.resetModules();
  vi.unstubAllGlobals();
}
