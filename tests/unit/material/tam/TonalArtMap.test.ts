import {
  CompressedArrayTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RepeatWrapping,
  RGFormat,
  UnsignedByteType,
} from 'three';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { TonalArtMap } from '../../../../src/material/tam/TonalArtMap.js';
import { strokeStyles } from '../../../../src/strokes/strokeStyles.js';
import { eventually } from '../../patience.js';

/** Images of one byte value each, `size` texels at level 0. */
const constantImages = (size: number, values: number[][]): Uint8Array[][] =>
  values.map((row) => row.map((value, level) => new Uint8Array((size >> level) ** 2).fill(value)));

describe('TonalArtMap.fromHatchImages', () => {
  it('returns sizes and bytes, as copies', () => {
    const images = constantImages(4, [
      [255, 254, 253],
      [90, 80, 70],
    ]);
    const map = TonalArtMap.fromHatchImages({ size: 4, images });
    images[1][0].fill(7);
    expect([map.size, map.tones, map.levels]).toEqual([4, 2, 3]);
    expect([...map.image(1, 0)]).toEqual(new Array(16).fill(90));
    expect([...map.image(1, 2)]).toEqual([70]);
    map.image(0, 1).fill(0);
    expect([...map.image(0, 1)]).toEqual(new Array(4).fill(254));
  });

  it('makes a texture that three uploads once, as data, with its own levels', () => {
    const { texture } = TonalArtMap.fromHatchImages({
      size: 2,
      images: constantImages(2, [
        [255, 254],
        [9, 8],
      ]),
    });
    expect(texture).toBeInstanceOf(CompressedArrayTexture);
    expect(texture.version).toBe(1);
    expect(texture.colorSpace).toBe(NoColorSpace);
    expect(texture.generateMipmaps).toBe(false);
    expect(texture.flipY).toBe(false);
    expect([texture.wrapS, texture.wrapT]).toEqual([RepeatWrapping, RepeatWrapping]);
    expect(texture.minFilter).toBe(LinearMipmapLinearFilter);
    expect(texture.mipmaps?.map(({ width, height }) => [width, height])).toEqual([
      [2, 2],
      [1, 1],
    ]);
    expect(texture.image).toMatchObject({ width: 2, height: 2, depth: 1 });
  });

  it('uses no mip levels with a single level', () => {
    const { texture } = TonalArtMap.fromHatchImages({ size: 2, images: constantImages(2, [[255], [0]]) });
    expect(texture.minFilter).toBe(LinearFilter);
  });

  it('dispose tells the renderer to free the textures', () => {
    const map = TonalArtMap.fromHatchImages({ size: 1, images: constantImages(1, [[255], [0]]) });
    let disposed = 0;
    map.texture.addEventListener('dispose', () => disposed++);
    map.thresholdTexture.addEventListener('dispose', () => disposed++);
    map.dispose();
    expect(disposed).toBe(2);
  });

  it('derives thresholds, and returns copies of them', () => {
    const ink = new Uint8Array([0, 255, 255, 255]);
    const map = TonalArtMap.fromHatchImages({ size: 2, images: [[new Uint8Array(4).fill(255)], [ink]] });
    const thresholds = map.thresholds(0);
    expect(thresholds[0]).toBe(0.125);
    expect(thresholds.toSorted()).toEqual(new Float32Array([0.125, 0.375, 0.625, 0.875]));
    thresholds.fill(0);
    expect(map.thresholds(0)[0]).toBe(0.125);
    expect(() => map.thresholds(1)).toThrow(
      'TonalArtMap.thresholds: level is 1, but must be a whole number from 0 to 0.',
    );
  });

  it.each([
    [-1, 0],
    [2, 0],
    [0.5, 0],
    [0, 1],
  ])('has no image (%f, %f)', (tone, level) => {
    const map = TonalArtMap.fromHatchImages({ size: 1, images: constantImages(1, [[255], [0]]) });
    expect(() => map.image(tone, level)).toThrow(/^TonalArtMap\.image: (tone|level) is .* from 0 to \d/);
  });
});

describe('TonalArtMap.generate', () => {
  it('draws without workers, reports progress, and keeps the constraints', async () => {
    const progress: number[] = [];
    const map = await TonalArtMap.generate({ size: 64, tones: 4, onProgress: (value) => progress.push(value) });
    expect([map.size, map.tones, map.levels]).toEqual([64, 4, 3]);
    expect(map.report.consistent).toBe(true);
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
  });

  it('makes a texture of thresholds that three uploads once, as data, without mip levels', async () => {
    const map = await TonalArtMap.generate({ size: 64, tones: 4 });
    const texture = map.thresholdTexture;
    expect(map.thresholdTexture).toBe(texture);
    expect(texture.version).toBe(1);
    expect([texture.format, texture.type, texture.colorSpace]).toEqual([RGFormat, UnsignedByteType, NoColorSpace]);
    expect([texture.minFilter, texture.magFilter]).toEqual([LinearFilter, LinearFilter]);
    expect([texture.generateMipmaps, texture.flipY]).toEqual([false, false]);
    // Levels of 64, 32 and 16 texels, each with a margin.
    const { data, width, height } = texture.image as { data: Uint8Array; width: number; height: number };
    expect([width, height]).toEqual([118, 66]);
    map.thresholds(1).forEach((threshold, i) => {
      const byte = data[2 * ((1 + Math.floor(i / 32)) * width + 67 + (i % 32))];
      // The sign is that of h − ½, the order that of h.
      expect(Math.sign(byte - 127.5)).toBe(Math.sign(threshold - 0.5));
    });
    map.dispose();
  });

  it('stops when aborted', async () => {
    const controller = new AbortController();
    const reports: number[] = [];
    const generated = TonalArtMap.generate({
      size: 1024,
      signal: controller.signal,
      onProgress: (progress) => {
        reports.push(progress);
        controller.abort(new Error('enough'));
      },
    });
    const outcome = await generated.then(
      () => 'drawn',
      (error: Error) => error.message,
    );
    expect(outcome).toBe('enough');
    expect(reports).toHaveLength(1);
  });

  it('names an option out of its range', async () => {
    await expect(TonalArtMap.generate({ syze: 64 } as never)).rejects.toThrow(
      'TonalArtMap.generate: unknown option "syze". The known ones are style, seed, size, ',
    );
    await expect(TonalArtMap.generate(null as never)).rejects.toThrow('TonalArtMap.generate: the options are null.');
    await expect(TonalArtMap.load('map.json', { style: 'ruled' } as never)).rejects.toThrow(
      'TonalArtMap.load: unknown option "style". The known ones are signal, onProgress, createWorker.',
    );
    expect(() => TonalArtMap.fromHatchImages({ size: 4, images: [], levels: 1 } as never)).toThrow(
      'TonalArtMap.fromHatchImages: unknown option "levels". The known ones are size, images, strokeTexels.',
    );
    await expect(TonalArtMap.generate({ size: 100 })).rejects.toThrow('TonalArtMap.generate: size is 100');
  });
});

describe('TonalArtMap.draw', () => {
  afterEach(() => vi.restoreAllMocks());

  it('returns the map at once, with its sizes, and fills its texture when it is drawn', async () => {
    const map = TonalArtMap.draw({ size: 64, tones: 4, style: 'ruled' });
    expect([map.size, map.tones, map.levels, map.strokeTexels]).toEqual([64, 4, 3, strokeStyles.ruled.width]);
    const { texture } = map;
    expect([map.isReady, texture.version]).toEqual([false, 0]);
    expect(await map.ready).toBe(map);
    expect([map.isReady, texture.version, map.texture === texture]).toEqual([true, 1, true]);
    const generated = await TonalArtMap.generate({ size: 64, tones: 4, style: 'ruled' });
    expect(map.image(2, 1)).toEqual(generated.image(2, 1));
    expect(map.thresholds(0)).toEqual(generated.thresholds(0));
  });

  it('throws if the images are read before the map is drawn', async () => {
    const map = TonalArtMap.draw({ size: 64 });
    expect(() => map.image(0, 0)).toThrow('TonalArtMap.image: the map is not drawn yet; await its ready first.');
    expect(() => map.thresholds(0)).toThrow('is not drawn yet');
    expect(() => map.thresholdTexture).toThrow('is not drawn yet');
    await expect(map.save()).rejects.toThrow('is not drawn yet');
    await map.ready;
  });

  it('throws at once for a wrong option, and names itself', () => {
    expect(() => TonalArtMap.draw({ size: 100 })).toThrow('TonalArtMap.draw: size is 100');
    expect(() => TonalArtMap.draw({ style: 'hachures' as never })).toThrow('TonalArtMap.draw: style is hachures');
    expect(() => TonalArtMap.draw({ syze: 64 } as never)).toThrow('TonalArtMap.draw: unknown option "syze".');
  });

  it('becomes ready after it was disposed of, and can be used', async () => {
    const map = TonalArtMap.draw({ size: 64 });
    map.dispose();
    await map.ready;
    expect(map.report.consistent).toBe(true);
  });

  it('reports a failure once in the console if nobody reads its promise, and otherwise rejects', async () => {
    const error = vi.spyOn(console, 'error').mockImplementation(() => {});
    const fails = (): never => {
      throw new Error('no pen');
    };
    TonalArtMap.draw({ size: 64, onProgress: fails });
    await eventually(() =>
      expect(error.mock.calls).toEqual([
        ['TonalArtMap.draw: the map could not be drawn (no pen); surfaces stay blank paper.'],
      ]),
    );
    await expect(TonalArtMap.draw({ size: 64, onProgress: fails }).ready).rejects.toThrow('no pen');
    expect(error).toHaveBeenCalledTimes(1);
  });

  it('stops silently when its signal is aborted', async () => {
    const error = vi.spyOn(console, 'error').mockImplementation(() => {});
    const controller = new AbortController();
    const map = TonalArtMap.draw({ size: 64, signal: controller.signal });
    controller.abort();
    await TonalArtMap.generate({ size: 64 });
    expect([map.isReady, error.mock.calls]).toEqual([false, []]);
    await expect(map.ready).rejects.toThrow('abort');
  });
});

describe('TonalArtMap.strokeTexels', () => {
  const images = [[new Uint8Array([255])], [new Uint8Array(1)]];

  it('is the width the style draws, or the one asked for', async () => {
    expect((await TonalArtMap.generate({ style: 'ruled', size: 64 })).strokeTexels).toBe(strokeStyles.ruled.width);
    expect((await TonalArtMap.generate({ size: 64, strokeTexels: 2.5 })).strokeTexels).toBe(2.5);
  });

  it('is given with your own images, or 2', () => {
    expect(TonalArtMap.fromHatchImages({ size: 1, images }).strokeTexels).toBe(2);
    expect(TonalArtMap.fromHatchImages({ size: 1, images, strokeTexels: 3 }).strokeTexels).toBe(3);
    for (const strokeTexels of [0, -1, Number.NaN, Infinity]) {
      expect(() => TonalArtMap.fromHatchImages({ size: 1, images, strokeTexels })).toThrow('strokeTexels is');
    }
  });
});

describe('a shared map', () => {
  it('is the same for equal options, however they are written', () => {
    const map = TonalArtMap.shared();
    expect(TonalArtMap.shared('hatching')).toBe(map);
    expect(TonalArtMap.shared({ style: undefined, seed: undefined })).toBe(map);
    const small = TonalArtMap.shared({ size: 64, tones: 4 });
    expect(small).not.toBe(map);
    expect(TonalArtMap.shared({ tones: 4, size: 64, style: 'hatching' })).toBe(small);
  });

  it('is drawn again on the next call after a failure', async () => {
    const options = { size: 64, tones: 4, seed: 11 } as const;
    const stop = new AbortController();
    const map = TonalArtMap.shared(options, { signal: stop.signal });
    stop.abort(new Error('no pen'));
    await expect(map.ready).rejects.toThrow('no pen');
    const next = TonalArtMap.shared(options);
    expect(next).not.toBe(map);
    expect((await next.ready).isReady).toBe(true);
  });
});
