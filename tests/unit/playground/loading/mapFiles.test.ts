import { expect, it } from 'vitest';
import { loadMapFiles } from '../../../../src/playground/loading/mapFiles.js';

it('says of a dropped map that is too large what to do, and reads none of its pictures', async () => {
  const description = {
    format: 'three-hatching tonal art map',
    version: 1,
    size: 4096,
    images: Array(40).fill('huge.png'),
  };
  const content = new Blob([JSON.stringify(description)]);
  const loading = loadMapFiles([{ name: 'map.json', content }], {
    signal: new AbortController().signal,
    onProgress: () => {},
  });
  await expect(loading).rejects.toThrow(
    /^map\.json has 40 tones of 4096 × 4096 texels, but at most 4 of that size are allowed; make the images smaller/,
  );
});
