/**
 * Recipes for a page of the packed library with each bundler: packages to install, files beside those of `pages`, commands,
 * and where the page then lies. `serve` is a command that serves the page itself.
 *
 * @typedef {object} Recipe
 * @property {string} name
 * @property {Record<string, string>} packages beside the library and three.js
 * @property {Record<string, string>} files
 * @property {string[][]} commands
 * @property {string} [folder] of the page that was built
 * @property {string[]} [serve] `PORT` stands for the port
 * @property {string} [path] of the page
 * @property {object} [manifest] what else package.json says
 * @property {string[]} [loading] builds the three lines of the README, without three.js, into the folder `loading`
 * @property {{ atOnce: number, later: number, requests: number, waves: number }} [most] the most that these load: bytes after gzip at
 *   once and from then on, requests and waves of them
 */

const html = (script) => `<!doctype html>
<html lang="en">
  <head><meta charset="utf-8" /><title>bundled</title><link rel="icon" href="data:," /></head>
  <body><script type="module" src="${script}"></script></body>
</html>
`;

const webpackLoading = `export default {
  mode: 'production',
  entry: './threeLines.js',
  experiments: { outputModule: true },
  externals: { three: 'module three' },
  externalsType: 'module',
  output: { path: import.meta.dirname + '/loading', filename: 'threeLines.js', module: true, chunkFormat: 'module' },
};
`;

const importMap = `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" /><title>import map</title><link rel="icon" href="data:," />
    <script type="importmap">
      { "imports": { "three": "/three/build/three.module.js", "three-hatching": "/three-hatching/dist/index.js" } }
    </script>
  </head>
  <body><script type="module" src="./plain.js"></script></body>
</html>
`;

/** Imported on the server too, where it must do nothing; the components are prerendered, without a canvas. */
const nextPage = `'use client';
import { Canvas } from '@react-three/fiber';
import { useEffect } from 'react';
import { applyHatching, presets } from 'three-hatching';
import { Hatched } from 'three-hatching/react';
import { renderHatchedCube } from '../renderHatchedCube.js';

export default function Page() {
  useEffect(() => {
    window.rendering = renderHatchedCube();
  }, []);
  return (
    <main data-presets={Object.keys(presets).length} data-apply={typeof applyHatching}>
      <Canvas flat style={{ width: 64, height: 64 }}>
        <directionalLight position={[1, 1, 1]} intensity={Math.PI} />
        <Hatched preset="technical" onHatched={(hatched) => { window.hatchedMaterials = hatched.materials.length; }}>
          <mesh><boxGeometry /><meshStandardMaterial /></mesh>
        </Hatched>
      </Canvas>
    </main>
  );
}
`;

const nextLayout = `export const metadata = { title: 'Next', icons: 'data:,' };
export default function Layout({ children }) {
  return <html lang="en"><body>{children}</body></html>;
}
`;

const copyOfPackages = `import { cpSync } from 'node:fs';
for (const name of ['three', 'three-hatching']) cpSync('node_modules/' + name, 'out/' + name, { recursive: true });
for (const name of ['index.html', 'plain.js', 'renderHatchedCube.js']) cpSync(name, 'out/' + name);
`;

/** @type {Recipe[]} */
export const recipes = [
  {
    name: 'import map',
    packages: {},
    files: { 'index.html': importMap, 'copy.mjs': copyOfPackages },
    commands: [['node', 'copy.mjs']],
    folder: 'out',
  },
  {
    name: 'Vite, development',
    packages: { vite: '*' },
    files: { 'index.html': html('./plain.js') },
    commands: [],
    serve: ['npx', 'vite', '--host', '127.0.0.1', '--strictPort', '--port', 'PORT'],
  },
  {
    name: 'Vite, build',
    packages: { vite: '*' },
    files: { 'index.html': html('./plain.js') },
    commands: [['npx', 'vite', 'build', '--outDir', 'out']],
    folder: 'out',
  },
  {
    name: 'webpack',
    packages: { webpack: '5', 'webpack-cli': '*' },
    files: { 'out/index.html': html('./main.js'), 'loading.mjs': webpackLoading },
    loading: ['npx', 'webpack', '--config', 'loading.mjs'],
    most: { atOnce: 30_000, later: 97_000, requests: 5, waves: 1 },
    commands: [['npx', 'webpack', '--mode', 'production', '--entry', './plain.js', '--output-path', 'out']],
    folder: 'out',
  },
  {
    name: 'esbuild',
    packages: { esbuild: '*' },
    files: { 'out/index.html': html('./plain.js') },
    loading: [
      ...['npx', 'esbuild', 'threeLines.js', '--bundle', '--minify', '--splitting', '--format=esm'],
      ...['--external:three', '--outdir=loading'],
    ],
    // It loads at once what other exports of the package share with what comes later.
    most: { atOnce: 87_000, later: 54_000, requests: 4, waves: 1 },
    commands: [['npx', 'esbuild', 'plain.js', '--bundle', '--minify', '--splitting', '--format=esm', '--outdir=out']],
    folder: 'out',
  },
  {
    name: 'Rollup',
    packages: { rollup: '*', '@rollup/plugin-node-resolve': '*', '@rollup/plugin-terser': '*' },
    files: { 'out/index.html': html('./plain.js') },
    loading: [
      ...['npx', 'rollup', 'threeLines.js', '--dir', 'loading', '--format', 'es', '--external', 'three'],
      ...['--plugin', 'node-resolve', '--plugin', 'terser'],
    ],
    // Its pages fetch what a script imports when that has come.
    most: { atOnce: 30_000, later: 97_000, requests: 5, waves: 2 },
    commands: [['npx', 'rollup', 'plain.js', '--dir', 'out', '--format', 'es', '--plugin', 'node-resolve']],
    folder: 'out',
  },
  {
    name: 'Parcel',
    packages: { parcel: '2' },
    manifest: { '@parcel/resolver-default': { packageExports: true } },
    files: { 'index.html': html('./plain.js') },
    commands: [['npx', 'parcel', 'build', 'index.html', '--dist-dir', 'out', '--no-source-maps']],
    folder: 'out',
  },
  {
    name: 'Next, prerendered and in the browser',
    packages: { next: '*', react: '19.2', 'react-dom': '19.2', '@react-three/fiber': '9' },
    files: {
      'next.config.mjs': "export default { output: 'export', distDir: 'out' };\n",
      'app/layout.jsx': nextLayout,
      'app/page.jsx': nextPage,
    },
    commands: [['npx', 'next', 'build']],
    folder: 'out',
  },
];
