import { defineConfig, type Plugin, type UserConfig } from 'vite';
import { bundledWorker } from './bundledWorker.js';
import { shortShaders } from './shortShaders.js';

/** Further entries, by the mode that builds them. */
const ENTRIES: Record<string, Record<string, string>> = {
  worker: { 'bake.worker': 'src/worker/bake.worker.ts' },
  svgWorker: { 'svg.worker': 'src/vector/svg/svg.worker.ts' },
  handWorker: { 'hand.worker': 'src/worker/hand.worker.ts' },
  command: { command: 'src/command/main.ts' },
  draw: { 'draw.worker': 'src/command/draw/drawWorker.ts' },
  hands: { hands: 'src/strokes/hands/index.ts' },
  react: { react: 'src/react/index.ts' },
  element: { element: 'src/element/element.ts' },
};

const modules = (...paths: readonly string[]): RegExp => new RegExp(`/src/(?:${paths.join('|')})\\.ts$`);

/**
 * The files that pages load at once and those that they load later, from the first on: each has all its imports that earlier ones do not
 * have. Bundlers move whole files between what a page loads at once and what it loads later, and each file that two later ones share is
 * one more request: so what these share lies in files that are there at once, or that all of them need.
 */
const SEPARATE = [
  {
    name: 'HatchingMaterial',
    test: modules(
      'material/HatchingMaterial',
      // Shared by the techniques, by outlines and by what hatches scenes.
      ...['look/vectors', 'scene/GivenValues', 'material/fieldFrameName', 'material/geometry/(?:formAngles|lineFades)'],
      ...['material/three/(?:batches|posing)', 'material/deformation/laterDeformations', 'mesh/bake/pullLayout'],
      ...['material/outlines/(?:IntersectingOutlines|loadIntersections)', 'mesh/occlusion/occlusionSides'],
    ),
  },
  // Shared by materials and bakes, whose files are loaded later.
  { name: 'layouts', test: modules('mesh/bake/attributeLayouts') },
  // Checks that run at once, for work that is loaded later, and what bakes share with workers and outlines.
  {
    name: 'checks',
    test: modules(
      ...[
        'material/geometry/(?:PrepareHatchingGeometryOptions|OutlineData|PulledVertices|identityOf)',
        'material/diagnostics/assertGeometry',
        'material/tam/checkHatchImageOptions',
        'material/readImage',
        'strokes/(?:blurToroidal|random)',
        'mesh/(?:corners|phases|runSliced)',
        'mesh/bake/vertexWords',
        'mesh/form/FormField',
      ],
      'worker/(?:runTask|workerFrom)',
    ),
  },
  { name: 'describeObject', test: modules('material/diagnostics/describeObject') },
  // Checks of vertices, which are read later.
  { name: 'checkGeometry', test: modules('material/geometry/checkGeometry') },
  { name: 'prepareHatchingGeometry', test: modules('material/geometry/prepareHatchingGeometry') },
  { name: 'toothMap', test: modules('material/tam/toothMap') },
  { name: 'TonalArtMap', test: modules('material/tam/TonalArtMap') },
  { name: 'hatchScene', test: modules('scene/hatchScene') },
  { name: 'applyHatching', test: modules('scene/applyHatching') },
  { name: 'outlineProperties', test: modules('material/outlines/outlineProperties') },
].map((group, i, all) => ({ ...group, priority: 10 + all.length - i }));

/**
 * The files of nodes, after what they share with WebGLRenderer's lines and outlines: a file takes all that it imports, and pages without
 * nodes must load neither these nor three's own.
 */
const OF_NODES = [
  {
    name: 'linesShared',
    test: modules('look/(?:constants/\\w+|relativeOcclusion)', 'material/parts/fieldFrame'),
    priority: 8,
  },
  {
    name: 'outlinesShared',
    test: modules('material/outlines/(?:MeshOutlines|outlineUniforms)', 'material/three/clipping'),
    priority: 6,
  },
  { name: 'deformations', test: modules('material/deformation/Deformations'), priority: 6 },
  { name: 'exposure', test: modules('material/parts/exposure'), priority: 6 },
  // What all parts of materials and outlines need, in GLSL.
  {
    name: 'surface',
    test: /\/src\/material\/(?:parts\/surface|shaders\/\w+)\.ts$|\/shaders\/(?:chunks|perFragment)\/(?:lineCoverage|screenGradient|tooth|deformVertex)\.glsl|\/shaders\/perTriangle\/turns\.glsl/,
    priority: 5,
  },
  { name: 'HatchingNodeMaterial', test: modules('webgpu/HatchingNodeMaterial'), priority: 2 },
  { name: 'outlines', test: modules('material/outlines/HatchingOutlines'), priority: 3 },
  { name: 'nodeOutlines', test: modules('webgpu/outlines/HatchingOutlines'), priority: 1 },
];

/** Fails a build that bundles code of others, so that users of the library have nobody else to credit. */
const nothingOfOthers: Plugin = {
  name: 'nothing-of-others',
  generateBundle(_options, bundle) {
    for (const chunk of Object.values(bundle)) {
      const strangers = chunk.type === 'chunk' ? chunk.moduleIds.filter((id) => id.includes('/node_modules/')) : [];
      if (strangers.length > 0) this.error(`The library would hold code of others: ${strangers.join(', ')}.`);
    }
  },
};

/** Paths of the library's entries, for entries that import the library as any page does. */
const OWN_ENTRIES = {
  'three-hatching': './index.js',
  'three-hatching/facts': './facts.js',
  'three-hatching/svg': './svg.js',
};

/**
 * The library: ES modules, three external. Built in passes, so that each result stands alone: `index` with the worker
 * inlined; with `--mode worker`, `--mode svgWorker` and `--mode handWorker` the same workers as one file each, which a page under a strict Content-Security-Policy
 * can serve from its own origin; with `--mode command` the command for Node and its threads; with `--mode hands` the twelve hands, with `--mode react` the components and with `--mode element` the web
 * component, which import `index` as any page does, so that there is one copy of it.
 */
export default defineConfig(
  ({ mode }): UserConfig => ({
    // The default base would turn the worker's address into an absolute one, broken for every consumer.
    base: './',
    plugins: [shortShaders, bundledWorker(() => [nothingOfOthers]), nothingOfOthers],
    publicDir: false,
    build: {
      target: 'es2022',
      // The output is readable and needs no source map.
      minify: false,
      sourcemap: false,
      emptyOutDir: ENTRIES[mode] === undefined,
      lib: {
        entry: ENTRIES[mode] ?? {
          index: 'src/index.ts',
          development: 'src/development.ts',
          facts: 'src/facts.ts',
          svg: 'src/vector/svg/index.ts',
          webgpu: 'src/webgpu/index.ts',
        },
        formats: ['es'],
      },
      rolldownOptions: {
        external: [
          /^three($|\/)/,
          /^node:/,
          /^@jsquash\//,
          /^react($|\/)/,
          '@react-three/fiber',
          /^three-hatching($|\/(facts|svg)$)/,
        ],
        // Chunks that are loaded when they are needed keep their names, those of the command's threads after its own; code that several files need has a chunk of its own.
        output: {
          chunkFileNames: ({ name }) => `${mode === 'draw' ? 'draw.' : ''}${name === 'src' ? 'library' : name}.js`,
          // Tells frameworks that run components on the server that these run in the browser.
          ...(mode === 'react' && { banner: "'use client';" }),
          // A page without a bundler then needs no entry in its import map for the library, and the command finds it anywhere.
          ...((mode === 'element' || mode === 'draw') && { paths: OWN_ENTRIES }),
          // Passes lie in one folder: each further one names what its files share after itself.
          codeSplitting: {
            groups: mode in ENTRIES ? [{ name: `${mode}Shared`, minShareCount: 2 }] : [...SEPARATE, ...OF_NODES],
          },
        },
      },
    },
  }),
);
