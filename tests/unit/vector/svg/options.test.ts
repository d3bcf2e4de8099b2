import { type Camera, Object3D, PerspectiveCamera, Scene, SphereGeometry } from 'three';
import { describe, expect, test } from 'vitest';
import type { DrawSVGOptions } from '../../../../src/vector/svg/DrawSVGOptions.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';

const draw = (options: unknown, scene: unknown = new Scene(), camera: unknown = new PerspectiveCamera()) =>
  drawSVG(scene as Scene, camera as Camera, options as DrawSVGOptions);

describe('wrong options end in one sentence that names them', () => {
  test.each<[unknown, string]>([
    [null, 'drawSVG: the options are null.'],
    [{ size: 3 }, 'drawSVG: unknown option "size".'],
    [{ kind: 'plot' }, "drawSVG: kind is plot, but must be 'print' or 'pen'."],
    [{ order: 'short' }, "drawSVG: order is short, but must be 'travel' or 'drawn'."],
    [
      { sheet: 'A9' },
      'drawSVG: sheet is "A9", but must be A0, A1, A2, A3, A4, A5, A6, Letter, Legal, Tabloid, one of them with',
    ],
    [{ sheet: [100] }, 'drawSVG: sheet is [100]'],
    [{ sheet: [100, -1] }, 'drawSVG: sheet is [100,-1]'],
    [{ sheet: ['200', '100'] }, 'drawSVG: sheet is ["200","100"]'],
    [{ sheet: [1e9, 100] }, 'with sides from 1 to 5000 mm, or [width, height] in millimetres.'],
    [{ margin: -1 }, 'drawSVG.margin: -1 is not a number in [0, ∞).'],
    [{ sheet: [40, 90], margin: 20 }, 'drawSVG: a margin of 20 mm leaves nothing of a sheet of 40 × 90 mm.'],
    [{ kind: 'pen', penWidth: 0 }, 'drawSVG.penWidth: 0 is not a number in (0, ∞).'],
    [{ penWidth: 0.3 }, "drawSVG: penWidth is only for kind: 'pen'."],
    [{ leastWidth: -1 }, 'drawSVG.leastWidth: -1 is not a number in [0, ∞).'],
    [{ kind: 'pen', shortest: -1 }, 'drawSVG.shortest: -1 is not a number in [0, ∞).'],
    [{ kind: 'pen', lines: 'odd' }, "drawSVG: lines is odd, but must be 'even' or 'canvas'."],
    [{ lines: 'even' }, "drawSVG: lines is only for kind: 'pen'."],
    [{ kind: 'pen', maxPasses: 4 }, 'drawSVG.maxPasses: 4 is not 1, 2 or 3.'],
    [{ kind: 'pen', maxPasses: 1.5 }, 'drawSVG.maxPasses: 1.5 is not 1, 2 or 3.'],
    [{ kind: 'pen', note: 3 as never }, 'drawSVG: note is 3, but must be true, false or a text.'],
    [{ kind: 'pen', before: {} as never }, 'drawSVG: before must be a drawing that was itself made with before'],
    [{ before: null }, "drawSVG: before is only for kind: 'pen'."],
    [{ maxPasses: 1 }, "drawSVG: maxPasses is only for kind: 'pen'."],
    [{ shortest: 2 }, "drawSVG: shortest is only for kind: 'pen'."],
    [{ kind: 'pen', leastWidth: 0.1 }, "drawSVG: leastWidth is only for kind: 'print'."],
    [{ kind: 'pen', paper: 'white' }, "drawSVG: paper is only for kind: 'print'."],
    [{ paper: {} }, 'drawSVG: paper'],
    [{ dpi: Number.NaN }, 'drawSVG.dpi: NaN is not a number in (0, 2400].'],
    [{ dpi: 4800 }, 'drawSVG.dpi: 4800 is not a number in (0, 2400].'],
    [{ shadows: 1 }, "drawSVG: shadows must be true, 'soft', 'hard' or false"],
    [{ signal: 3 }, 'drawSVG: signal is 3'],
    [{ onProgress: 3 }, 'drawSVG: onProgress is 3'],
  ])('%j', async (options, sentence) => {
    const error = await draw(options).catch((reason: Error) => reason);
    expect(error).toBeInstanceOf(Error);
    expect((error as Error).message).toContain(sentence);
  });

  test('an invalid scene, and an invalid camera', async () => {
    await expect(draw({}, {})).rejects.toThrow('drawSVG: scene must be an Object3D');
    await expect(draw({}, new Scene(), new Object3D())).rejects.toThrow('drawSVG: camera must be');
    await expect(draw({}, new Scene(), null)).rejects.toThrow('drawSVG: camera must be');
  });
});

test.each([
  ['A5', 1, '148mm', '210mm'],
  ['A5', 2, '210mm', '148mm'],
  ['A5 portrait', 2, '148mm', '210mm'],
  ['a5 landscape', 0.5, '210mm', '148mm'],
  ['Letter', 0.5, '215.9mm', '279.4mm'],
  ['9x4in', 0.5, '228.6mm', '101.6mm'],
  [[50, 40], 0.5, '50mm', '40mm'],
])('the sheet %j for a picture of the aspect %f', async (sheet, aspect, width, height) => {
  const { svg } = await draw({ sheet }, new Scene(), new PerspectiveCamera(30, aspect));
  expect(svg).toContain(`width="${width}" height="${height}"`);
});

test('an empty scene is an empty sheet', async () => {
  const { svg, paths, leftOut } = await draw({ paper: '#fff' });
  expect([paths, leftOut]).toEqual([0, []]);
  expect(svg).toContain('<rect width="210" height="297" fill="#ffffff"/>');
  expect(svg).not.toContain('<g');
});

describe('a drawing goes on in slices', () => {
  test('its progress rises to the end', { tags: ['all'] }, async () => {
    const seen: number[] = [];
    const scene = sceneOf(await hatchedMesh(new SphereGeometry(1, 48, 32)));
    await drawSVG(scene, cameraAt(0, 1, 2), { onProgress: (progress) => seen.push(progress) });
    expect(seen.length).toBeGreaterThan(5);
    for (const [i, progress] of seen.entries()) expect(progress).toBeGreaterThan(i === 0 ? 0 : seen[i - 1]);
    expect(seen[seen.length - 1]).toBeLessThanOrEqual(1);
  });

  test('and can be aborted: before it begins, and on the way', async () => {
    const scene = sceneOf(await hatchedMesh(new SphereGeometry(1, 48, 32)));
    const reason = new Error('enough');
    await expect(drawSVG(scene, cameraAt(0, 1, 2), { signal: AbortSignal.abort(reason) })).rejects.toBe(reason);
    const controller = new AbortController();
    let calls = 0;
    const drawing = drawSVG(scene, cameraAt(0, 1, 2), {
      signal: controller.signal,
      onProgress: () => {
        if (++calls === 2) controller.abort(reason);
      },
    });
    await expect(drawing).rejects.toBe(reason);
    expect(calls).toBe(2);
  });
});
