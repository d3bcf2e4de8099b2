import { expect, test } from 'vitest';
import { sortDrop } from '../../../../src/playground/loading/openDropped.js';
import type { ModelFile } from '../../../../src/viewer/files/readModel.js';

const file = (name: string): ModelFile => ({ name, content: new Blob() });
const NOTHING = { files: [], missing: [] };

const kindOf = (names: string[], isAtMap = false): string => sortDrop(names.map(file), NOTHING, isAtMap).kind;

test('pictures that belong to nothing are asked about', () => {
  expect(kindOf(['photo.png'])).toBe('pictures');
  expect(kindOf(['1.png', '2.PNG'])).toBe('pictures');
});

test('pictures belong to the map if its contact sheet is open, or with the JSON of a saved map', () => {
  expect(kindOf(['photo.png'], true)).toBe('map');
  expect(kindOf(['tone-0-level-0.png', 'map.json'])).toBe('map');
});

test('everything else is a model, also with pictures', () => {
  expect(kindOf(['ball.obj', 'wood.png'], true)).toBe('model');
  expect(kindOf(['photo.jpg'])).toBe('model');
});

test('pictures that the shown model asks for are read together with it', () => {
  const shown = { files: [file('ball.obj'), file('old.png')], missing: ['Wood.png'] };
  const { kind, files } = sortDrop([file('textures/wood.PNG'), file('old.png')], shown, true);
  expect(kind).toBe('model');
  expect(files.map(({ name }) => name)).toEqual(['ball.obj', 'textures/wood.PNG', 'old.png']);
  expect(sortDrop([file('other.png')], shown, false).kind).toBe('pictures');
});
