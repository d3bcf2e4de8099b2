import type { ServerResponse } from 'node:http';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin, type UserConfig } from 'vite';
import { firstPartCheck } from './building/firstPart.js';
import { formSources } from './building/formSources.js';
import { laterParts } from './building/laterParts.js';
import { libraryEntries } from './building/libraryEntries.js';
import { shortShaders } from './building/shortShaders.js';
import { noticeCheck, noticeFile } from './notice/noticePlugin.js';
import { builtPlayground } from './tests/browser/builtPlayground.js';

const page = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Hosts of static files answer `/figures` with `/figures/`, the folder; the development server would not. */
const figuresFolder: Plugin = {
  name: 'figures-folder',
  configureServer: ({ middlewares }) => void middlewares.use(toFolder),
  configurePreviewServer: ({ middlewares }) => void middlewares.use(toFolder),
};

function toFolder({ url }: { url?: string }, response: ServerResponse, next: () => void): void {
  if (url === '/figures') response.writeHead(301, { Location: '/figures/' }).end();
  else next();
}

/**
 * The playground. It imports the library by its package name; `--mode use-build` runs it on the built library.
 * `--mode test` serves the pages of the browser tests: files are not watched, so that an edit in the middle of a run
 * cannot reload a page under test.
 */
export default defineConfig(
  ({ mode }): UserConfig => ({
    // Relative, so that the built playground can lie in any folder of any host.
    base: './',
    plugins: [
      ...[shortShaders, formSources, firstPartCheck, laterParts, figuresFolder, noticeFile, noticeCheck()],
      mode === 'test' && builtPlayground,
    ],
    resolve: {
      // Named in both cases: left alone, the names would be resolved by the paths in tsconfig.json, to the source again.
      alias: mode === 'use-build' ? libraryEntries('./dist/', 'js') : libraryEntries('./src/', 'ts'),
    },
    assetsInclude: ['**/*.ply.gz'],
    worker: { format: 'es', plugins: () => [noticeCheck()] },
    optimizeDeps: {
      entries: [
        'index.html',
        '{figures,fetch}/index.html',
        'examples/**/*.html',
        'tests/**/*.html',
        '!tests/output/**',
      ],
      // Named, because a dependency that is first met while a page runs makes the server reload that page.
      include: [
        'three',
        'three/webgpu',
        'lil-gui',
        'mediabunny',
        'bunny',
        'snowden/lo.js',
        '@pmndrs/assets/models/suzi.glb.js',
        ...[
          'controls/OrbitControls.js',
          'environments/RoomEnvironment.js',
          'loaders/GLTFLoader.js',
          'loaders/OBJLoader.js',
          'loaders/MTLLoader.js',
          'loaders/PLYLoader.js',
          'loaders/TGALoader.js',
          'loaders/STLLoader.js',
          'loaders/DRACOLoader.js',
          'loaders/FBXLoader.js',
          'loaders/TDSLoader.js',
          'loaders/USDLoader.js',
          'loaders/VRMLLoader.js',
          'loaders/ColladaLoader.js',
          'loaders/3MFLoader.js',
          'exporters/GLTFExporter.js',
          'libs/meshopt_decoder.module.js',
          'libs/fflate.module.js',
          'utils/BufferGeometryUtils.js',
          'utils/SkeletonUtils.js',
          'geometries/TeapotGeometry.js',
        ].map((path) => `three/addons/${path}`),
      ],
    },
    build: {
      outDir: 'dist-demo',
      target: 'es2022',
      chunkSizeWarningLimit: 1500,
      // Browsers that fetch no modules ahead fetch them when they are imported.
      modulePreload: { polyfill: false },
      rolldownOptions: { input: ['index.html', 'figures/index.html', 'fetch/index.html'].map(page) },
    },
    ...(mode === 'test' && {
      cacheDir: `node_modules/.vite-test-${process.env.HATCH_PORT ?? 'default'}`,
      server: { hmr: false, watch: null },
    }),
  }),
);
