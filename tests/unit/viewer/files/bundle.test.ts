import { expect, test } from 'vitest';
import { zipDrawing } from '../../../../src/playground/export/zip.js';
import { describeBundle } from '../../../../src/viewer/files/bundle.js';
import {
  colorsOf,
  colouredBoxMtl,
  colouredBoxObj,
  file,
  read,
  refusal,
} from '../../../../tools/modelFiles/modelWriters.js';
import { threeMf, zip } from '../../../../tools/modelFiles/sceneWriters.js';

const LINK = 'technique=engraving&ink=%237a2e1d&view=framed';
const model = { 'model/box.obj': colouredBoxObj, 'model/box.mtl': colouredBoxMtl };
const description = 'three-hatching.json';
const bytesOf = async (blob: Blob): Promise<Uint8Array> => new Uint8Array(await blob.arrayBuffer());

test('a bundle restores a model with its files, look and strokes, also if it came from an archive', async () => {
  const files = [file('parts/box.obj', colouredBoxObj), file('box.mtl', colouredBoxMtl), file('Box.mtl', 'rubbish')];
  const strokes = [file('map.json', '{}'), file('tone-0.png', 'a picture')];
  const bundle = await bytesOf(await zipDrawing({ model: files, strokes, link: LINK }));
  const box = await read(['for-you.zip', bundle]);
  expect([box.name, box.notes]).toEqual(['box.obj', []]);
  expect(new Set(colorsOf(box)).size).toBe(3);
  expect(box.drawing?.link).toBe(LINK);
  expect(box.drawing?.strokes.map(({ name }) => name)).toEqual(['map.json', 'tone-0.png']);
  expect(await box.drawing?.strokes[1].content.text()).toBe('a picture');
  const again = await zipDrawing({ model: box.unpacked!, strokes: [], link: 'ink=%23000000' });
  const other = await read(['again.zip', await bytesOf(again)]);
  expect(other.drawing).toEqual({ link: 'ink=%23000000', strokes: [] });
  expect(new Set(colorsOf(other)).size).toBe(3);
});

test('nor does it matter if another program has packed it, with its folder, or what the model is called', async () => {
  const packed = zip({
    '__MACOSX/mine/._three-hatching.json': 'rubbish',
    [`mine/${description}`]: describeBundle(LINK),
    'mine/model/.DS_Store': 'rubbish',
    'mine/model/box': colouredBoxObj,
    'mine/strokes/readme.exe': 'rubbish',
  });
  const box = await read(['mine.zip', packed]);
  expect([box.name, box.drawing]).toEqual(['box', { link: LINK, strokes: [] }]);
  const archived = await read(['m.zip', zip({ [description]: describeBundle(LINK), 'model/box.zip': threeMf() })]);
  expect(archived.drawing?.link).toBe(LINK);
});

test('an archive without a look has none', async () => {
  const box = await read(['box.zip', zip({ 'box.obj': colouredBoxObj })]);
  expect(box.drawing).toBeUndefined();
  expect(box.unpacked?.map(({ name }) => name)).toEqual(['box.obj']);
});

test('rejects a damaged or hostile one with one sentence', async () => {
  const of = (text: string, rest: object = model) => refusal(['b.zip', zip({ [description]: text, ...rest })]);
  const damaged = 'b.zip could not be read; what says how its model is drawn (three-hatching.json) is damaged.';
  const whole = describeBundle(LINK);
  for (const text of [
    '',
    '{',
    'null',
    '[]',
    '{"drawing":"ink=1"}',
    whole.slice(0, 60),
    whole.replace(/"drawing": ".*"/, '"drawing": 7'),
    whole.replace('"version": 1', '"version": "1"'),
    `${whole}${' '.repeat(70_000)}`,
  ])
    expect(await of(text), text.slice(0, 80)).toBe(damaged);
  expect(await of(whole.replace('"version": 1', '"version": 2'))).toBe(
    'b.zip was saved by a later version of this page, which this one cannot read.',
  );
  expect(await of(whole, {})).toBe('b.zip says how a model is drawn, but holds no model.');
  expect(await of(whole, { 'model/readme.txt': 'Hello.' })).toMatch(/^readme\.txt is not a model this page can read/);
  // One that holds itself would never end.
  const inner = zip({ [description]: whole, ...model });
  expect(await of(whole, { 'model/box.glb': inner })).toBe(
    'box.glb is an archive in an archive, which this page does not unpack.',
  );
  expect(await refusal(['a.zip', zip({ 'a.glb': zip({ 'b.obj': colouredBoxObj }) })])).toBe(
    'a.glb is an archive in an archive, which this page does not unpack.',
  );
});
