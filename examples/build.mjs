/** `npm run build:examples`: builds the examples into dist-examples, as static files for any folder of any host. */
import { cpSync, existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';
import { readExamples } from './readExamples.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
/** The modules of three.js that pages without a build step import. */
const THREE_FILES = [
  'build/three.module.js',
  'build/three.core.js',
  ...[
    'controls/OrbitControls.js',
    'geometries/TeapotGeometry.js',
    'libs/meshopt_decoder.module.js',
    'loaders/GLTFLoader.js',
    'utils/BufferGeometryUtils.js',
    'utils/SkeletonUtils.js',
  ].map((path) => `examples/jsm/${path}`),
];

/** @param {string} outDir is emptied first */
export async function buildExamples(outDir) {
  const common = { root, logLevel: 'error' };
  await build({ ...common, configFile: join(root, 'examples/vite.config.ts'), root: undefined, build: { outDir } });
  // Pictures, pages that stand alone, and what those import.
  for (const { folder } of readExamples()) {
    for (const path of ['picture.webp', 'page.html'].map((name) => `${folder}/${name}`)) {
      if (existsSync(join(root, 'examples', path))) cpSync(join(root, 'examples', path), join(outDir, path));
    }
  }
  cpSync(join(root, 'examples/models'), join(outDir, 'models'), { recursive: true });
  for (const path of THREE_FILES) cpSync(join(root, 'node_modules/three', path), join(outDir, 'lib/three', path));
  const dist = join(outDir, 'lib/three-hatching/dist');
  for (const mode of ['production', 'element']) {
    await build({
      ...common,
      configFile: join(root, 'tools/building/vite.lib.config.ts'),
      mode,
      build: { outDir: dist },
    });
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await buildExamples(join(root, 'dist-examples'));
