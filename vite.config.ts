import { fileURLToPath } from 'node:url';
import { defineConfig, type UserConfig } from 'vite';
import { builtPlayground } from './tools/browser/builtPlayground.js';
import { bundledWorker } from './tools/building/bundledWorker.js';
import { fetchedAhead } from './tools/building/fetchedAhead.js';
import { firstPartCheck } from './tools/building/firstPart.js';
import { formSources } from './tools/building/formSources.js';
import { laterParts } from './tools/building/laterParts.js';
import { libraryEntries } from './tools/building/libraryEntries.js';
import { occlusionAhead } from './tools/building/occlusionAhead.js';
import { pageInputs, pages } from './tools/building/pages.js';
import { shortShaders } from './tools/building/shortShaders.js';
import { noticeCheck, noticeFile } from './tools/notice/noticePlugin.js';

const inRoot = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * The playground. It imports the library by its package name; `--mode use-build` runs it on the built library.
 * `--mode test` serves the pages of the browser tests: files are not watched, so that an edit in the middle of a run
 * cannot reload a page under test.
 */
export default defineConfig(
  ({ mode, command }): UserConfig => ({
    // Relative, so that the built playground can lie in any folder of any host.
    base: './',
    plugins: [
      ...[
        shortShaders,
        bundledWorker(() => [noticeCheck()]),
        formSources,
        occlusionAhead,
        firstPartCheck,
        laterParts,
        fetchedAhead,
        pages(),
      ],
      ...[noticeFile, noticeCheck()],
      mode === 'test' && builtPlayground,
    ],
    resolve: {
      // Named in both cases: left alone, the names would be resolved by the paths in tsconfig.json, to the source again.
      alias: libraryEntries(
        mode === 'use-build' ? './dist/' : './src/',
        mode === 'use-build' ? 'js' : 'ts',
        command === 'serve' ? 'development' : 'index',
      ),
    },
    assetsInclude: ['**/*.ply.gz'],
    worker: { format: 'es', plugins: () => [noticeCheck()] },
    optimizeDeps: {
      entries: [
        'index.html',
        'src/playground/fetch/index.html',
        'tools/figures/index.html',
        'examples/**/*.html',
        'tests/**/*.html',
        '!tests/output/**',
      ],
      // Named, because a dependency that is first met while a page runs makes the server reload that page.
      include: [
        'three',
        'three/webgpu',
        'three/tsl',
        'lil-gui',
        'mediabunny',
        'meshoptimizer/simplifier',
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
          'geometries/ParametricGeometry.js',
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
      rolldownOptions: { input: pageInputs.map(inRoot) },
    },
    ...(mode === 'test' && {
      cacheDir: `node_modules/.vite-test-${process.env.HATCH_PORT ?? 'default'}`,
      server: { hmr: false, watch: null },
    }),
  }),
);
