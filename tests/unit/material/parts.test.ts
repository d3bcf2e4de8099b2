import { afterEach, describe, expect, test, vi } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { fetchedPart, partNameOf } from '../../../src/material/parts/parts.js';
import { plainShaders } from '../../../src/material/shaders/plainShaders.js';

afterEach(() => vi.restoreAllMocks());

const isPlain = (material: HatchingMaterial): boolean =>
  material.vertexShader === plainShaders().vertexShader && material.fragmentShader === plainShaders().fragmentShader;

// Each test is the first to use its part: parts are fetched once.
describe('code that is fetched when a material first uses it', () => {
  test.each([
    ['hatching', 'latticeSpacing'],
    ['engraving', 'lineSpacing'],
  ] as const)(
    'leaves the surface plain until it has loaded, and then changes the program: %s',
    async (technique, of) => {
      const material = new HatchingMaterial({ technique });
      expect(isPlain(material)).toBe(true);
      const { version } = material;
      await material.ready;
      expect(isPlain(material)).toBe(false);
      expect(material.fragmentShader).toContain(of);
      expect(material.version).toBe(version + 1);
      expect(isPlain(new HatchingMaterial({ technique }))).toBe(false);
    },
  );

  test('leaves a material unchanged until it has loaded', async () => {
    const material = new HatchingMaterial({ technique: 'hatching' });
    const { fragmentShader, version } = material;
    const defines = { ...material.defines };
    material.technique = 'dryMedia';
    expect([material.fragmentShader, material.version]).toEqual([fragmentShader, version]);
    expect(material.defines).toEqual(defines);
    await material.ready;
    expect(material.fragmentShader).toContain('smudge');
    expect(material.defines).not.toEqual(defines);
    expect(material.version).toBe(version + 1);
  });

  test('is not awaited if the look changes back in the meantime', async () => {
    const material = new HatchingMaterial({ technique: 'hatching' });
    const { fragmentShader, version } = material;
    material.technique = 'stipple';
    const stippled = material.ready;
    material.technique = 'hatching';
    await Promise.all([stippled, material.ready]);
    expect([material.fragmentShader, material.version]).toEqual([fragmentShader, version]);
  });

  test('reaches a copy that was made in the meantime', async () => {
    const material = new HatchingMaterial({ technique: 'adjacency' });
    expect(isPlain(material)).toBe(true);
    const copy = material.clone();
    await copy.ready;
    expect(isPlain(copy)).toBe(false);
    expect(copy.fragmentShader).toBe(material.fragmentShader);
  });

  test('is complete after preload', async () => {
    await HatchingMaterial.preload();
    for (const technique of ['triangle', 'adjacency', 'dryMedia', 'stipple', 'engraving', 'woodcut'] as const) {
      expect(isPlain(new HatchingMaterial({ technique }))).toBe(false);
      expect(fetchedPart(partNameOf({ technique }))).toBeDefined();
    }
  });

  test('is reported in one sentence if it cannot be fetched, and fetched again on next use', async () => {
    vi.resetModules();
    vi.doMock('../../../src/material/parts/lines.js', () => {
      throw new Error('offline');
    });
    const errors = vi.spyOn(console, 'error').mockImplementation(() => {});
    const { HatchingMaterial } = await import('../../../src/material/HatchingMaterial.js');
    const material = new HatchingMaterial({ technique: 'engraving' });
    const sentence = /^HatchingMaterial: the code that draws "lines" could not be fetched \(.*\)\. Serve all/s;
    await expect(material.ready).rejects.toThrow(sentence);
    expect(errors.mock.calls).toEqual([[expect.stringMatching(sentence)]]);
    vi.doUnmock('../../../src/material/parts/lines.js');
    await material.ready;
    expect(material.fragmentShader).toContain('lineSpacing');
  });
});
