import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parseArguments } from '../../../src/command/parseArguments.js';
import { UsageError } from '../../../src/command/readOptions.js';
import { ProgressBar } from '../../../src/command/standardStreams.js';
import { tam } from '../../../src/command/tam.js';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { readMap } from '../../../src/strokes/mapFiles/readMapFiles.js';
import { generateHatchImages } from '../../../src/strokes/tamImages/generateHatchImages.js';
import { finish, requestOf } from '../strokes/draw.js';
import { drawSwatch } from '../strokes/hand/drawSwatch.js';

const hand = learnHand(drawSwatch({ rows: 8, taperEnd: 0.3, curvature: 0.05 }));
let work: string;
const place = (name: string): string => join(work, name);

beforeAll(() => {
  work = mkdtempSync(join(tmpdir(), 'three-hatching-hand-'));
  writeFileSync(place('hand.json'), JSON.stringify(hand));
  writeFileSync(place('text.json'), 'no json');
  writeFileSync(place('list.json'), '[1]');
  writeFileSync(place('empty.json'), JSON.stringify({ ...hand, strokes: [] }));
});
afterAll(() => rmSync(work, { recursive: true, force: true }));

describe('tam --hand', () => {
  it('reads the hand', () => {
    const request = parseArguments(['tam', '--hand', place('hand.json'), '--size', '64', '--out', 'x']);
    expect(request).toMatchObject({ action: 'draw', map: { hand, size: 64 } });
  });

  it.each<[string[], string]>([
    [['none.json'], 'none.json is not there; check the path after --hand.'],
    [['.'], 'is a folder; name the JSON file of a hand after --hand.'],
    [['text.json'], 'text.json is not JSON; --hand needs a file with { version, strokes, numbers }.'],
    [['list.json'], 'list.json: hand is an array, but must be { version, strokes, numbers }'],
    [['empty.json'], 'empty.json: hand: there are no strokes; draw at least one.'],
    [['hand.json', '--style', 'ruled'], '--hand and --style exclude each other; pass only one of them.'],
    [['hand.json', '--preset', 'pencil'], '--hand and --preset exclude each other; pass only one of them.'],
    [
      ['hand.json', '--stroke-texels', '9'],
      '--stroke-texels is 9, but must be a number from 1.2 to 2.6 texels for a hand.',
    ],
  ])('%s ends in a sentence', ([file, ...others], sentence) => {
    const call = () => parseArguments(['tam', '--hand', place(file), '--out', 'x', ...others]);
    expect(call).toThrow(UsageError);
    expect(call).toThrow(sentence);
  });

  it('writes the map that the library draws', async () => {
    const out = place('map');
    const args = ['tam', '--hand', place('hand.json'), '--size', '64', '--tones', '4', '--out', out];
    await tam(args, new AbortController().signal, new ProgressBar(process.stderr));
    const drawn = finish(generateHatchImages(requestOf({ hand, size: 64, tones: 4 })));
    const { images, strokeTexels } = await readMap(
      'map.json',
      async (name) => readFileSync(join(out, name)),
      () => {},
    );
    expect(images).toEqual(drawn.images);
    expect(strokeTexels).toBe(drawn.strokeTexels);
  });
});
