import { describe, expect, test } from 'vitest';
import { DRAW_HELP, FORMAT_ENDINGS, parseDrawing, sheetOf } from '../../../src/command/parseDrawing.js';
import { UsageError } from '../../../src/command/readOptions.js';
import { FORMATS, MODEL_EXTENSIONS } from '../../../src/viewer/files/formats.js';

const drawing = (...args: string[]) => {
  const request = parseDrawing(args);
  if (request.action !== 'draw') throw new Error('It asks for help.');
  return request;
};
const refusal = (...args: string[]): string => {
  try {
    parseDrawing(args);
  } catch (error) {
    expect(error).toBeInstanceOf(UsageError);
    return (error as Error).message;
  }
  return '';
};
const OUT = ['a.obj', '--out', 'a.svg'];

describe('the command line of draw', () => {
  test('the example of the help', () => {
    const line = 'model.glb --preset engraving --sheet A4 --margin 12 --pen 0.3 --out drawing.svg'.split(' ');
    const { models, out, options } = drawing(...line, '--view', '25 8', '--light', '-45 40');
    expect([models, out]).toEqual([['model.glb'], 'drawing.svg']);
    expect(options).toMatchObject({
      ...{
        preset: 'engraving',
        kind: 'pen',
        pen: 0.3,
        sheet: { size: [210, 297], suits: true },
        margin: 12,
        dpi: 96,
        order: 'travel',
      },
      view: { azimuth: 25, elevation: 8 },
      light: { azimuth: -45, elevation: 40 },
      shadows: undefined,
      frames: undefined,
    });
  });

  test('what is left as the file says, and both sides', () => {
    expect(drawing(...OUT).options).toMatchObject({ asWritten: [], bothSides: false });
    expect(drawing('--as-written', 'Hidden, up,up', '--both-sides', ...OUT).options).toMatchObject({
      asWritten: ['hidden', 'up'],
      bothSides: true,
    });
    expect(refusal('--as-written', 'up,sides', ...OUT)).toBe(
      '--as-written is sides, but must be orientation, up, hidden or ceiling.',
    );
  });

  test('cameras, lights, variants and clips of the file', () => {
    expect(drawing(...OUT).options).toMatchObject({ camera: undefined, variant: undefined, usesFileLights: true });
    const line = ['--camera', 'hero', '--variant', '2', '--clip', 'walk', '--no-file-lights'];
    expect(drawing(...OUT, ...line).options).toMatchObject({
      ...{ camera: 'hero', variant: '2', clip: 'walk', usesFileLights: false },
    });
    expect(refusal(...OUT, '--camera', '1', '--view', '0 0')).toBe(
      '--camera and --view exclude each other; pass only one of them.',
    );
  });

  test('parts of the file, any number of them', () => {
    expect(drawing(...OUT).options).toMatchObject({ hide: [], only: [] });
    const line = ['--hide', 'Roof', '--only', 'Wall*', '--hide', 'Door'];
    expect(drawing(...OUT, ...line).options).toMatchObject({ hide: ['Roof', 'Door'], only: ['Wall*'] });
    expect(refusal(...OUT, '--only', ' ')).toBe('--only is "", but must be the name of a part.');
  });

  test('names ignore case, the last of two values counts, and arguments after -- are models', () => {
    const line = ['--preset', 'CROSSHATCHING', '--kind', 'Pen', '--up', '-Z', '--pen', '1', '--pen', '2'];
    const { models, options } = drawing(...OUT, ...line, '--', '-1.obj');
    expect(models).toEqual(['a.obj', '-1.obj']);
    expect(options).toMatchObject({ preset: 'crossHatching', kind: 'pen', up: '-z', pen: 2 });
  });

  test('every format that is read can be named', () => {
    expect([...FORMAT_ENDINGS].sort()).toEqual([...MODEL_EXTENSIONS].sort());
    for (const { name } of FORMATS) {
      const format = drawing(...OUT, '--format', name).options.format;
      expect(MODEL_EXTENSIONS).toContain(format);
    }
  });

  test('values may begin with a dash, also after an equals sign', () => {
    expect(drawing(...OUT, '--view=-10,-20', '--up', '-z').options).toMatchObject({
      view: { azimuth: -10, elevation: -20 },
      up: '-z',
    });
  });

  test.each([
    ['front', 0, 0],
    [' Top ', 0, 90],
    ['bottom', 0, -90],
    ['left', -90, 0],
    ['right', 90, 0],
    ['back', 180, 0],
    ['0 90', 0, 90],
    ['30,-90', 30, -90],
  ])('the view %j', (view, azimuth, elevation) => {
    expect(drawing(...OUT, '--view', view).options.view).toEqual({ azimuth, elevation });
  });

  test('the view iso shows the three axes equally long', () => {
    const { azimuth, elevation } = drawing(...OUT, '--view', 'iso').options.view as {
      azimuth: number;
      elevation: number;
    };
    expect(azimuth).toBe(45);
    expect(Math.sin((elevation * Math.PI) / 180)).toBeCloseTo(Math.sqrt(1 / 3), 12);
  });

  test('the view may be one of those that are found for the model', () => {
    const ranks = ['auto', ' AUTO2 ', 'auto3', 'auto4'].map((view) => drawing(...OUT, '--view', view).options.view);
    expect(ranks).toEqual([{ rank: 1 }, { rank: 2 }, { rank: 3 }, { rank: 4 }]);
    expect(() => drawing(...OUT, '--view', 'auto5')).toThrow(/or auto to auto4, front,/);
    expect(() => drawing(...OUT, '--light', 'auto')).toThrow(/or front, back,/);
    expect(drawing(...OUT).options.view).toBeUndefined();
  });

  test('- is a model, and a file to write to; a format is an ending', () => {
    const { models, out, options } = drawing('-', '--format', '.STL', '--out', '-');
    expect([models, out, options.format]).toEqual([['-'], '-', 'stl']);
  });

  test('without a pen the drawing is for print, with or without shadows', () => {
    expect(drawing(...OUT).options).toMatchObject({
      kind: 'print',
      pen: 0.3,
      shortest: undefined,
      maxPasses: undefined,
    });
    expect(drawing(...OUT, '--pen', '0.3', '--max-passes', '3').options.maxPasses).toBe(3);
    expect(drawing(...OUT, '--pen', '0.3', '--shortest', '0').options).toMatchObject({ kind: 'pen', shortest: 0 });
    expect(drawing(...OUT, '--kind', 'pen').options).toMatchObject({ kind: 'pen', lines: undefined });
    expect(drawing(...OUT, '--kind', 'pen', '--lines', 'canvas').options.lines).toBe('canvas');
    expect(drawing(...OUT, '--no-shadows').options.shadows).toBe(false);
    expect(drawing(...OUT, '--shadows').options.shadows).toBe(true);
  });

  test('a link may be given as its hash alone', () => {
    expect(drawing(...OUT, '--link', 'https://example.org/p/#technique=engraving&ink=%23203080').options.link).toBe(
      'technique=engraving&ink=%23203080',
    );
    expect(refusal(...OUT, '--link', 'https://example.org/p/')).toMatch(/--link holds no drawing/);
    // Without a technique, a link means that of its preset, or the one that is drawn with a map.
    expect(refusal(...OUT, '--link', '#ink=%23203080')).toMatch(/--link is drawn with strokes that are a picture/);
    expect(refusal(...OUT, '--link', '#preset=banknote&ink=%23203080')).toBe('');
    expect(refusal(...OUT, '--link', '#ink=%23203080', '--preset', 'engraving')).toBe('');
    // Dots leave as dots.
    expect(refusal(...OUT, '--preset', 'stipple')).toBe('');
    expect(refusal(...OUT, '--link', '#preset=stipple')).toBe('');
    expect(refusal(...OUT, '--link', '#technique=stipple')).toBe('');
    expect(refusal(...OUT, '--link', '#preset=stipple&technique=hatching')).toMatch(/strokes that are a picture/);
  });

  test('nothing at all, or --help, asks for help, which names every option', () => {
    expect([parseDrawing([]), parseDrawing(['a.obj', '-h'])]).toEqual([{ action: 'help' }, { action: 'help' }]);
    expect(parseDrawing(['--version'])).toEqual({ action: 'version' });
    for (const name of ['preset', 'link', 'view', 'light', 'pen', 'frames', 'jobs', 'format', 'out', 'force'])
      expect(DRAW_HELP).toContain(`--${name} `);
    for (const name of ['A0', 'A6', 'Letter', 'Legal', 'Tabloid', 'iso', 'bottom']) expect(DRAW_HELP).toContain(name);
  });
});

test.each([
  [['a.obj'], '--out is missing; name the file to write the drawing to.'],
  [['--out', 'a.svg'], 'There is no model to draw; name a file after draw.'],
  [
    [...OUT, '--preset', 'pencil'],
    '--preset is pencil, whose strokes are a picture and cannot leave as lines; use one of',
  ],
  [[...OUT, '--preset', 'toString'], '--preset is toString, which is not a preset; use one of pen, crossHatching'],
  [[...OUT, '--view', '25'], '--view is "25", but must be two numbers in quotes'],
  [[...OUT, '--view', '25 8 3'], '--view is "25 8 3", but must be two numbers'],
  [[...OUT, '--view', 'behind'], '--view is "behind", but must be two numbers in quotes'],
  [
    [...OUT, '--view', '0 90.5'],
    'and degrees above it, from -90 to 90; or auto to auto4, front, back, left, right, top, bottom or iso.',
  ],
  [[...OUT, '--light', '25 91'], '--light is "25 91", but must be two numbers'],
  [[...OUT, '--format', ''], '--format is "", but must be glb, gltf, obj'],
  [[...OUT, '--pen', 'thin'], '--pen is thin, but must be a number from 0.01 to 20, or several as "0.3, outlines 0.5"'],
  [[...OUT, '--pen', '0.3', '--kind', 'print'], '--pen and --kind print exclude each other'],
  [[...OUT, '--lines', 'even'], '--lines is for a pen'],
  [[...OUT, '--pen', '0.3', '--lines', 'odd'], '--lines is odd'],
  [[...OUT, '--shortest', '2'], '--shortest is for a pen'],
  [[...OUT, '--max-passes', '2'], '--max-passes is for a pen'],
  [[...OUT, '--pen', '0.3', '--max-passes', '4'], '--max-passes is 4'],
  [[...OUT, '--pen', '0.3', '--paper', '#ffffff'], '--paper is for print'],
  [[...OUT, '--paper', 'white'], '--paper is white, but must be a colour as "#f4f1e6"'],
  [[...OUT, '--shadows', '--no-shadows'], '--shadows and --no-shadows exclude each other'],
  [
    [...OUT, '--sheet', 'B4'],
    '--sheet is B4, but must be A0, A1, A2, A3, A4, A5, A6, Letter, Legal, Tabloid, one of them',
  ],
  [[...OUT, '--margin', '105'], '--margin is 105, which leaves nothing of a sheet of 210 × 297 mm.'],
  [[...OUT, '--frames', '0'], '--frames is 0, but must be a whole number from 1 to 9999.'],
  [[...OUT, '--jobs', '1.5'], '--jobs is 1.5, but must be a whole number from 1 to 64.'],
  [[...OUT, '--order', 'random'], '--order is random, but must be travel or drawn.'],
  [[...OUT, '--turn'], '--turn is not an option. See draw --help.'],
  [[...OUT, '--presett', 'pen'], '--presett is not an option; --preset may be meant. See draw --help.'],
  [['a.obj', '--oot=a.svg'], '--oot is not an option; --out may be meant.'],
  [[...OUT, '--No-Shadows'], '--No-Shadows is not an option; --no-shadows may be meant.'],
  [[...OUT, '--ortho'], '--ortho is not an option; --orthographic may be meant.'],
  [['-dash.obj', '--out', 'a.svg'], '-dash.obj is not an option; write ./ before the name of a file that begins'],
  [['a.obj', '--out'], '--out needs a value after it. See draw --help.'],
  [['a.obj', '--out', '--force'], '--out needs a value after it. See draw --help.'],
  [['a.obj', '--out', ' '], '--out is missing; name the file to write the drawing to.'],
  [[...OUT, '--force=yes'], '--force takes no value. See draw --help.'],
  [[...OUT, '--view', '400 0'], 'degrees around the model, from -360 to 360, and degrees above it'],
  [[...OUT, '--view', '0x10 0'], '--view is "0x10 0", but must be two numbers'],
  [[...OUT, '--sheet', ''], '--sheet is "", but must be A0'],
  [[...OUT, '--pens', '0.3'], '--pens is 0.3, but must be layer, ink, material or part, or colours with widths'],
  [['a.glb', '--out', 'a.dxf', '--note'], '--note is text of an SVG file; leave it out'],
  [[...OUT, '--refill', 'full'], '--refill is full, but must be a number of metres above 0, as 40m.'],
  [[...OUT, '--split', 'ink'], '--split is ink, but must be pen.'],
  [[...OUT, '--kind', 'print', '--pens', 'ink'], '--pens and --kind print exclude each other; pass only one of them.'],
  [['a.obj', '--out', 'a.dxf', '--kind', 'print'], 'A DXF file holds lines of a pen, not areas of a print'],
  [['a.obj', '--out', '-', '--split', 'pen'], '--split pen writes several SVG files'],
  [[...OUT, '--pen', '0x1'], '--pen is 0x1, but must be a number from 0.01 to 20, or several as "0.3, outlines 0.5"'],
  [[...OUT, '--dpi', '2400'], '--dpi is 2400, but must be a number from 10 to 1200.'],
  [[...OUT, '--format', 'step'], '--format is step, but must be glb, gltf, obj'],
])('%j is refused in one sentence', (args, sentence) => {
  const message = refusal(...args);
  expect(message).toContain(sentence);
  expect(message).toMatch(/^\S[^\n]*\.$/);
});

test.each([
  ['A4', [210, 297], true],
  ['a0', [841, 1189], true],
  ['letter', [215.9, 279.4], true],
  ['Legal', [215.9, 355.6], true],
  ['TABLOID', [279.4, 431.8], true],
  ['A4 portrait', [210, 297], false],
  ['a3 landscape', [420, 297], false],
  ['A5-landscape', [210, 148], false],
  ['Letter landscape', [279.4, 215.9], false],
  ['200x150', [200, 150], false],
  ['200x150mm', [200, 150], false],
  ['99.5 × 10', [99.5, 10], false],
  ['8.5x11in', [215.9, 279.4], false],
  ['8.5 in x 11 in', [215.9, 279.4], false],
])('the sheet %s', (name, [width, height], suits) => {
  const sheet = sheetOf(name);
  expect(sheet.size[0]).toBeCloseTo(width, 9);
  expect(sheet.size[1]).toBeCloseTo(height, 9);
  expect(sheet.suits).toBe(suits);
});

test.each(['', 'A4 upside', '0x100', '100', '1e9x1', 'x', '8.5inx11', '9000x10', '300x1in x', 'toString', 'A7'])(
  'no sheet: %j',
  (name) => {
    expect(() => sheetOf(name)).toThrow(UsageError);
  },
);
