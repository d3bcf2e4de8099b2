import { join } from 'node:path';
import { type BuildOptions, build } from 'vite';
import { projectFolder } from './packedLibrary.js';

/** Builds a page of the consumers' project and returns its folder. @param options of the build, beside what all pages share */
export async function viteBuild(name: string, options: BuildOptions = {}): Promise<string> {
  const outDir = join(projectFolder, `dist-${name}`);
  await build({
    configFile: false,
    root: projectFolder,
    base: './',
    logLevel: 'error',
    worker: { format: 'es' },
    build: {
      outDir,
      emptyOutDir: true,
      chunkSizeWarningLimit: 4000,
      ...options,
      rolldownOptions: { input: join(projectFolder, `${name}.html`), ...options.rolldownOptions },
    },
  });
  return outDir;
}
