import { follow, openPlayground } from '../../tools/browser/playground.js';
import { expect, test } from '../browser/test.js';

test.use({ viewport: { width: 640, height: 420 } });

test('programs of another technique are ready before anything is drawn with them', { tag: '@all' }, async ({
  page,
}) => {
  await openPlayground(page, 'model=cube&technique=triangle&outlines=off&mapSize=64&mapTones=4');
  await page.evaluate(() => {
    const gl = document.querySelector<HTMLCanvasElement>('#drawing')!.getContext('webgl2')!;
    const seen = { linked: 0, early: 0 };
    const building = new Set<WebGLProgram>();
    /** The programs given to the driver before each fence. */
    const before = new Map<WebGLSync, WebGLProgram[]>();
    const { linkProgram, fenceSync, getSyncParameter, useProgram } = gl;
    gl.linkProgram = (program) => {
      seen.linked++;
      building.add(program);
      linkProgram.call(gl, program);
    };
    gl.fenceSync = (condition, flags) => {
      const fence = fenceSync.call(gl, condition, flags);
      if (fence) before.set(fence, [...building]);
      return fence;
    };
    gl.getSyncParameter = (fence, name) => {
      const value: unknown = getSyncParameter.call(gl, fence, name);
      if (value === gl.SIGNALED) for (const program of before.get(fence) ?? []) building.delete(program);
      return value;
    };
    gl.useProgram = (program) => {
      if (program && building.has(program)) {
        const [shader] = gl.getAttachedShaders(program)!;
        // three builds those of shadow maps where it draws them. They are short.
        if (!gl.getShaderSource(shader)!.includes('MeshDepthMaterial')) seen.early++;
      }
      useProgram.call(gl, program);
    };
    Object.assign(window, { __programs: seen });
  });
  const seen = () => page.evaluate(() => ({ ...(window as unknown as { __programs: object }).__programs }));
  const frames = await page.evaluate(() => window.__playground!.framesDrawn);
  await follow(page, 'model=cube&technique=engraving&shadows=on&ground=floor');
  expect(await seen()).toMatchObject({ early: 0 });
  await follow(page, 'model=cube&technique=adjacency&compare=hatching&outlines=on&mapSize=64&mapTones=4');
  const { linked, early } = (await seen()) as { linked: number; early: number };
  expect(linked).toBeGreaterThan(3);
  expect(early).toBe(0);
  expect(await page.evaluate(() => window.__playground!.framesDrawn)).toBeGreaterThan(frames);
});
