import { testOnOnePage } from '../browser/test.js';

/** Tests on the page that draws, with WebGLRenderer, what the reference in double precision is asked for. */
export const referencePage = testOnOnePage('tests/gpu/harness.html', {
  begin: (page) => page.waitForFunction(() => window.renderHatching !== undefined),
});
