import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import {
  COMPANION_EXTENSIONS,
  FORMATS,
  formatNames,
  formatOf,
  MODEL_EXTENSIONS,
} from '../../../../src/viewer/files/formats.js';

test.each(FORMATS.map((format) => [format.name, format] as const))(
  '%s can be recognised, and three.js has the loader that it is said to have',
  (_, format) => {
    expect(format.hasSignature ?? format.looksLike ?? format.isPackage).toBeDefined();
    const { name, module = name } = format.loader ?? { name: `${format.name}Loader` };
    expect(existsSync(`node_modules/three/examples/jsm/loaders/${module}.js`)).toBe(format.loader !== undefined);
    for (const extension of format.extensions) expect(formatOf(extension)).toBe(format);
  },
);

test('no two formats share an extension, and an archive is opened only where there is no model beside it', () => {
  expect(new Set(MODEL_EXTENSIONS).size).toBe(MODEL_EXTENSIONS.length);
  expect(MODEL_EXTENSIONS.at(-1)).toBe('zip');
});

test('users read the names of all formats', () => {
  expect(formatNames('and')).toBe('GLB, glTF, OBJ, FBX, DAE, USDZ, 3MF, 3DS, VRML, PLY, STL and OFF');
});

test('the page names all formats, its picker takes all files that belong to a model, and the development server knows all loaders', () => {
  const page = readFileSync('index.html', 'utf8');
  expect(page).toContain(`Drop a model to have it drawn: ${formatNames('or')}, with its files`);
  const accepted = /id="file-input"[^>]*accept="([^"]*)"/.exec(page)![1].split(',');
  // Descriptions of maps and packed models can be picked, too.
  const wanted = [...MODEL_EXTENSIONS, ...COMPANION_EXTENSIONS, 'json', 'gz'].map((extension) => `.${extension}`);
  expect(accepted.toSorted()).toEqual(wanted.toSorted());
  const config = readFileSync('vite.config.ts', 'utf8');
  for (const { loader } of FORMATS)
    if (loader) expect(config).toContain(`'loaders/${loader.module ?? loader.name}.js'`);
});

test.each(['# \n', ';  \n', '#\t \r\n'])('hundreds of comments in a row are passed over at once: %j', (comment) => {
  const bytes = new TextEncoder().encode(`${comment.repeat(700)}v 0 0 0\n`);
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  expect(FORMATS.filter(({ hasSignature, looksLike }) => (hasSignature ?? looksLike)?.({ bytes, head }))).toEqual([]);
  const stl = `${comment.replace(';', '#').repeat(20)}solid a\nfacet normal 0 0 1\n`;
  expect(
    FORMATS.find(({ name }) => name === 'STL')?.looksLike?.({ bytes: new TextEncoder().encode(stl), head: stl }),
  ).toBe(true);
});
