import { existsSync } from 'node:fs';
import { expect, test } from 'vitest';
import { FORMATS, formatNames, formatOf, MODEL_EXTENSIONS } from '../../../../src/demo/files/formats.js';

test.each(FORMATS.map((format) => [format.name, format] as const))(
  '%s can be recognised, and three.js has its loader',
  (_, format) => {
    expect(format.hasSignature ?? format.looksLike ?? format.isPackage).toBeDefined();
    const { name, module = name } = format.loader;
    expect(existsSync(`node_modules/three/examples/jsm/loaders/${module}.js`)).toBe(true);
    for (const extension of format.extensions) expect(formatOf(extension)).toBe(format);
  },
);

test('no two formats share an extension, and an archive is opened only where there is no model beside it', () => {
  expect(new Set(MODEL_EXTENSIONS).size).toBe(MODEL_EXTENSIONS.length);
  expect(MODEL_EXTENSIONS.at(-1)).toBe('zip');
});

test('users read the names of all formats', () => {
  expect(formatNames('and')).toBe('GLB, glTF, OBJ, FBX, DAE, USDZ, 3MF, 3DS, VRML, PLY and STL');
});
