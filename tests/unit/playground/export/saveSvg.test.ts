import { drawSVG } from 'three-hatching/svg';
import { beforeEach, expect, test, vi } from 'vitest';
import { download } from '../../../../src/playground/export/download.js';
import { saveSvg } from '../../../../src/playground/export/saveSvg.js';
import { planPrint } from '../../../../src/playground/print/print.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

vi.mock('three-hatching/svg', () => ({ drawSVG: vi.fn(), plottingTime: () => 'about 5 min' }));
vi.mock('../../../../src/playground/export/download.js', () => ({ download: vi.fn() }));
vi.mock('../../../../src/playground/export/drawCovered.js', () => ({
  drawCovered: (_stage: unknown, settings: Settings, _signal: AbortSignal, draw: CallableFunction) =>
    draw({ restoreScene: () => {} }, planPrint(settings, { width: 600, height: 400, isWide: true })),
}));

const drawn = vi.mocked(drawSVG);

beforeEach(() => {
  vi.clearAllMocks();
  drawn.mockResolvedValue({ svg: '<svg/>', paths: 1200, plotSeconds: null, leftOut: [] } as never);
});

const camera = { clone: () => ({ setViewOffset: () => {} }) };
const viewport = { camera, scenery: { scene: 'the scene' } };

/** Saves a drawing of lines, and returns what is asked of it, with what is said in the end. */
async function saved(settings: Partial<Settings>) {
  const look = { ...defaultSettings(), technique: 'engraving', pictureSize: 'a5', ...settings } as Settings;
  const said = await saveSvg(viewport as never, look, 'cube', () => {}, new AbortController().signal);
  return { said, asked: drawn.mock.lastCall![2]! };
}

test('a print has filled paths on its paper, and a pen has lines of its width on none', async () => {
  const print = await saved({ pictureSvg: 'print', paper: '#f4ead6' });
  expect(print.asked).toMatchObject({ kind: 'print', paper: '#f4ead6' });
  expect(print.asked).not.toHaveProperty('penWidth');
  expect(print.said).toBe('Saved as SVG: 210 × 148 mm, 1,200 paths.');
  expect(vi.mocked(download).mock.lastCall![1]).toBe('cube.svg');
  const pen = await saved({ pictureSvg: 'pen', picturePen: 0.5 });
  expect(pen.asked).toMatchObject({ kind: 'pen', penWidth: 0.5 });
  expect(pen.asked).not.toHaveProperty('paper');
  expect(pen.asked.note).toBe(false);
  const noted = await saved({ pictureSvg: 'pen', pictureNote: 'pens' });
  expect(noted.asked.note).toBe('cube');
});

test('the layers of a plot are chosen, or its pens by their colours and widths, each once', async () => {
  const plot: Partial<Settings> = {
    pictureSvg: 'pen',
    picturePenWidthA: 0.4,
    picturePenWidthB: 0.7,
    picturePenWidthC: 0.2,
    picturePenA: '#000000',
    picturePenB: '#ff0000',
    picturePenC: '#000000',
  };
  const pens = async (picturePens: Settings['picturePens']) => (await saved({ ...plot, picturePens })).asked.pens;
  expect(await pens('material')).toBe('material');
  const [black, red] = [
    { color: '#000000', width: 0.4 },
    { color: '#ff0000', width: 0.7 },
  ];
  expect(await pens('two')).toEqual([black, red]);
  expect(await pens('three')).toEqual([black, red]);
  const blue = await saved({ ...plot, picturePens: 'three', picturePenC: '#0000ff' });
  expect(blue.asked.pens).toEqual([black, red, { color: '#0000ff', width: 0.2 }]);
  expect((await saved({ pictureSvg: 'print', picturePens: 'two' })).asked).not.toHaveProperty('pens');
});

test('strokes of a map are left out for a pen with a message; without anything else, nothing is saved', async () => {
  const { said, asked } = await saved({ technique: 'hatching', pictureSvg: 'pen' });
  expect(said).toMatch(/^Saved as SVG without its strokes, which a pen cannot draw: /);
  expect(asked.picture).toBeUndefined();
  drawn.mockResolvedValue({ svg: '<svg/>', paths: 0, plotSeconds: null, leftOut: [] } as never);
  vi.mocked(download).mockClear();
  await expect(saved({ technique: 'hatching', pictureSvg: 'pen' })).rejects.toThrow(
    'there are no lines: the strokes come from a map, which a pen cannot draw.',
  );
  expect(download).not.toHaveBeenCalled();
});
