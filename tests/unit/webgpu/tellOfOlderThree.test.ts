import { beforeEach, expect, test, vi } from 'vitest';

const error = vi.spyOn(console, 'error').mockImplementation(() => {});

/** Anew for each test, since it says its sentence once. */
let tellOfOlderThree: typeof import('../../../src/webgpu/outlines/tellOfOlderThree.js').tellOfOlderThree;

beforeEach(async () => {
  vi.resetModules();
  error.mockClear();
  ({ tellOfOlderThree } = await import('../../../src/webgpu/outlines/tellOfOlderThree.js'));
});

test('three.js 0.186 draws no outlines of nodes, which is said once', () => {
  tellOfOlderThree('186');
  tellOfOlderThree('186');
  expect(error.mock.calls).toEqual([[expect.stringMatching(/need three\.js 0\.187 or newer, but this is 0\.186: /)]]);
});

test.each(['187', '187dev', '200'])('0.%s draws them', (revision) => {
  tellOfOlderThree(revision);
  expect(error).not.toHaveBeenCalled();
});
