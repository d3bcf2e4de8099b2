import { expect, test } from '../browser/test.js';

const THREES = [
  /Material "Hatching(Outline)?Material" is not compatible/,
  // The warning about the material that three.js draws instead of that of outlines.
  /Vertex attribute "position" not found on geometry/,
];

test("besides three's error a single message says what to do, and nothing breaks", async ({ page, pageProblems }) => {
  for (const outlines of [false, true]) {
    await page.goto('tests/gpu/webgpu.html');
    await page.waitForFunction(() => window.drawWithWebGPURenderer !== undefined);
    expect(await page.evaluate((l) => window.drawWithWebGPURenderer(l), outlines)).toBe(3);
    const problems = pageProblems.splice(0);
    const ours = problems.filter((problem) => problem.includes('WebGPURenderer draws no materials'));
    expect(ours).toEqual([expect.stringContaining('Draw the scene with WebGLRenderer')]);
    const others = problems.filter((problem) => !ours.includes(problem));
    expect(others.length).toBeGreaterThan(0);
    for (const problem of others)
      expect(
        THREES.some((pattern) => pattern.test(problem)),
        problem,
      ).toBe(true);
  }
});
