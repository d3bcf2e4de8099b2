import { fileURLToPath } from 'node:url';

/** Names of the library's entries that the pages import, and the files they stand for. */
const ENTRIES: readonly [name: RegExp, source: string, built: string][] = [
  [/^three-hatching\/facts$/, 'facts', 'facts'],
  [/^three-hatching\/hands$/, 'strokes/hands/index', 'hands'],
  [/^three-hatching\/react$/, 'react/index', 'react'],
  [/^three-hatching\/svg$/, 'vector/svg/index', 'svg'],
  [/^three-hatching\/webgpu$/, 'webgpu/index', 'webgpu'],
  [/^three-hatching\/element$/, 'element/element', 'element'],
  // A query tells Vite how to load the file.
  [/^three-hatching\/svg\.worker(?=$|\?)/, 'vector/svg/svg.worker', 'svg.worker'],
  [/^three-hatching\/hand\.worker(?=$|\?)/, 'worker/hand.worker', 'hand.worker'],
  [/^three-hatching\/bake\.worker(?=$|\?)/, 'worker/bake.worker', 'bake.worker'],
];

/**
 * Lets the pages import the library by its package name.
 *
 * @param folder of the sources, or of what is built from them, from the root of the project
 * @param main the file that the name of the package stands for
 */
export const libraryEntries = (folder: './src/' | './dist/', ending: 'ts' | 'js', main: 'index' | 'development') =>
  [[/^three-hatching$/, main, main] as const, ...ENTRIES].map(([find, source, built]) => ({
    find,
    replacement: fileURLToPath(
      new URL(`../../${folder}${ending === 'ts' ? source : built}.${ending}`, import.meta.url),
    ),
  }));
