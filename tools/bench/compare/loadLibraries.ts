export type Library = typeof import('three-hatching');

/** The built libraries that are compared; `buildLibrary.mjs` has put them there. Both draw with the same three. */
export async function loadLibraries(): Promise<Record<'old' | 'new', Library>> {
  const load = (name: string): Promise<Library> =>
    import(/* @vite-ignore */ `/tests/output/bench/compare/${name}/index.js`);
  return { old: await load('old'), new: await load('new') };
}
