import { deflateSync } from 'node:zlib';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { TonalArtMap } from '../../../../src/material/tam/TonalArtMap.js';
import { encodePng } from '../../../../src/strokes/mapFiles/writeMapFiles.js';
import { hatchImages } from '../../strokes/draw.js';

const png = async (name: string, size: number, image: Uint8Array): Promise<File> => {
  const bytes = await encodePng({ width: size, height: size, channels: 1, data: image });
  return new File([bytes as Uint8Array<ArrayBuffer>], name);
};

/** The finest images of a map of 64 texels, without its blank paper, darkest name first. */
const artistsFiles = (): Promise<File[]> =>
  Promise.all(
    hatchImages({ style: 'hatching', size: 64, tones: 4 })
      .images.slice(1)
      .map(([image], i) => png(`${9 - i}.png`, 64, image)),
  );

/** Serves files under http://maps.test/set/; anything else is not found. */
function serve(files: readonly File[]): void {
  vi.stubGlobal('fetch', async (url: URL) => {
    const file = files.find(({ name }) => `http://maps.test/set/${name}` === url.href);
    return file ? new Response(file) : new Response('', { status: 404 });
  });
}
afterEach(() => vi.unstubAllGlobals());

const imagesOf = (map: TonalArtMap): Uint8Array[][] =>
  Array.from({ length: map.tones }, (_, tone) =>
    Array.from({ length: map.levels }, (_, level) => map.image(tone, level)),
  );
const thresholdsOf = (map: TonalArtMap): Float32Array[] =>
  Array.from({ length: map.levels }, (_, level) => map.thresholds(level));

describe('TonalArtMap.save and load', () => {
  it.each(['crossHatching', 'charcoal'] as const)('restore every byte of a generated map: %s', async (style) => {
    const map = await TonalArtMap.generate({ style, size: 64, tones: 5 });
    const again = await TonalArtMap.load(await map.save());
    expect(imagesOf(again)).toEqual(imagesOf(map));
    expect(thresholdsOf(again)).toEqual(thresholdsOf(map));
    expect(again.strokeTexels).toBe(map.strokeTexels);
    expect(again.thresholdTexture.mipmaps).toEqual(map.thresholdTexture.mipmaps);
  });

  it('restore every byte of a map of hand-drawn levels, through URLs', async () => {
    const images = [
      [255, 255],
      [200, 90],
      [17, 3],
    ].map((row) => row.map((byte, level) => new Uint8Array(64 >> (2 * level)).fill(byte)));
    const map = TonalArtMap.fromHatchImages({ size: 8, images });
    const files = await map.save();
    expect(files.map(({ name }) => name)).toEqual([
      'map.json',
      ...[0, 1, 2].flatMap((tone) => [0, 1].map((level) => `tone-${tone}-level-${level}.png`)),
    ]);
    serve(files);
    const again = await TonalArtMap.load('http://maps.test/set/map.json');
    expect(imagesOf(again)).toEqual(images);
    expect(thresholdsOf(again)).toEqual(thresholdsOf(map));
    expect(again.strokeTexels).toBe(map.strokeTexels);
  });

  it('saves a loaded map unchanged', async () => {
    const bytesOf = (files: File[]) => Promise.all(files.map(async (file) => [file.name, await file.text()]));
    const files = await (await TonalArtMap.generate({ size: 64, tones: 4 })).save();
    expect(await bytesOf(await (await TonalArtMap.load(files)).save())).toEqual(await bytesOf(files));
  });
});

describe("TonalArtMap.load of an artist's images", () => {
  it('sorts files by darkness, adds paper and makes levels', async () => {
    const map = await TonalArtMap.load((await artistsFiles()).toReversed());
    expect([map.size, map.tones, map.levels]).toEqual([64, 4, 3]);
    expect(map.image(0, 0).every((byte) => byte === 255)).toBe(true);
    expect(map.image(3, 0)).toEqual(hatchImages({ style: 'hatching', size: 64, tones: 4 }).images[3][0]);
    expect(map.report.meansOutOfOrder).toEqual([]);
  });

  it('takes a list of URLs, and a JSON that names one image per tone', async () => {
    const files = await artistsFiles();
    const json = JSON.stringify({
      format: 'three-hatching tonal art map',
      version: 1,
      size: 64,
      images: files.map(({ name }) => name),
    });
    serve([...files, new File([json], 'mine.json')]);
    const listed = await TonalArtMap.load(files.map(({ name }) => `http://maps.test/set/${name}`));
    const described = await TonalArtMap.load(new URL('http://maps.test/set/mine.json'));
    expect(imagesOf(listed)).toEqual(imagesOf(described));
    expect(listed.tones).toBe(4);
  });

  it('adds no paper where there is some', async () => {
    const paper = await png('0.png', 64, new Uint8Array(4096).fill(255));
    expect((await TonalArtMap.load([...(await artistsFiles()), paper])).tones).toBe(4);
  });

  it('reports progress that rises to 1', async () => {
    const progress: number[] = [];
    await TonalArtMap.load(await artistsFiles(), { onProgress: (value) => progress.push(value) });
    expect(progress).toEqual(progress.toSorted((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
  });

  it('stops when aborted', async () => {
    const controller = new AbortController();
    const loading = TonalArtMap.load(await artistsFiles(), {
      signal: controller.signal,
      onProgress: () => controller.abort(new Error('enough')),
    });
    await expect(loading).rejects.toThrow('enough');
    await expect(TonalArtMap.load('map.json', { signal: AbortSignal.abort(new Error('early')) })).rejects.toThrow(
      'early',
    );
  });

  it.each([new Error('enough'), new DOMException('enough', 'TimeoutError'), 'enough'])(
    'rejects with the reason of the abort, at any stage: %s',
    async (reason) => {
      const controller = new AbortController();
      // As in browsers: the fetch rejects with the reason or, without one, with an AbortError.
      vi.stubGlobal('fetch', async () => {
        controller.abort(reason);
        throw new DOMException('The operation was aborted.', 'AbortError');
      });
      const { signal } = controller;
      await expect(TonalArtMap.load('http://maps.test/set/map.json', { signal })).rejects.toBe(reason);
      const files = await artistsFiles();
      const late = new AbortController();
      const onProgress = (): void => {
        if (!late.signal.aborted) late.abort(reason);
      };
      await expect(TonalArtMap.load(files, { signal: late.signal, onProgress })).rejects.toBe(reason);
    },
  );

  it('names a file that can no longer be read', async () => {
    const [file] = await artistsFiles();
    file.arrayBuffer = () => Promise.reject(new DOMException('The file was changed', 'NotReadableError'));
    await expect(TonalArtMap.load([file])).rejects.toThrow(/^TonalArtMap\.load: 9\.png The file was changed/);
  });

  it('resolves addresses against the script in a worker, which has no document', async () => {
    vi.stubGlobal('location', { href: 'http://maps.test/set/worker.js' });
    serve(await (await TonalArtMap.generate({ size: 64, tones: 4, levels: 1 })).save());
    expect((await TonalArtMap.load('map.json')).tones).toBe(4);
    expect((await TonalArtMap.load(['tone-1-level-0.png', 'tone-2-level-0.png'])).tones).toBe(3);
  });

  it.each(['blob:http://maps.test/5c1a', undefined])('throws if there is no base URL: %s', async (href) => {
    vi.stubGlobal('location', href && { href });
    await expect(TonalArtMap.load('map.json')).rejects.toThrow(
      /TonalArtMap\.load: "map\.json" is a URL that cannot be resolved here .*pass an absolute URL/,
    );
  });
});

describe('misuse', () => {
  it.each<[unknown, RegExp]>([
    [null, /: the options are null\. Pass an object/],
    ['hatching', /: the options are hatching\. Pass an object/],
    [{ signal: {} }, /: signal is .* but must be an AbortSignal/],
    [{ onProgress: 5 }, /: onProgress is 5, but must be a function, or left out/],
    [{ createWorker: 'worker.js' }, /: createWorker is worker.js, but must be a function, or left out/],
  ])('is named at once: options %j', async (options, says) => {
    for (const call of [TonalArtMap.generate(options as object), TonalArtMap.load([], options as object)]) {
      const error = await call.catch((reason) => reason);
      expect(error).toBeInstanceOf(TypeError);
      expect(error.message).toMatch(says);
    }
  });

  it('names images whose buffers were transferred, and values that are no images', () => {
    const images = [255, 0].map((byte) => [new Uint8Array(16).fill(byte)]);
    structuredClone(images[1][0], { transfer: [images[1][0].buffer] });
    expect(() => TonalArtMap.fromHatchImages({ size: 4, images })).toThrow(
      /^TonalArtMap\.fromHatchImages: images\[1\]\[0\] is empty: its buffer was transferred.*Pass a copy/,
    );
    expect(() => TonalArtMap.fromHatchImages(null as never)).toThrow(
      'TonalArtMap.fromHatchImages: the hatch images are null.',
    );
  });
});

describe('TonalArtMap.load refuses', () => {
  const description = {
    format: 'three-hatching tonal art map',
    version: 1,
    size: 64,
    images: ['9.png', '8.png', '7.png'],
  };
  const json = (changes: object): File => new File([JSON.stringify({ ...description, ...changes })], 'map.json');
  const odd = (size: number): Promise<File> => png('odd.png', size, new Uint8Array(size * size).fill(99));

  it.each<[string, (files: File[]) => unknown, RegExp]>([
    ['nothing', () => [], /source is empty, but must be a URL/],
    [
      'a file that is missing',
      (files) => [json({}), ...files.slice(1)],
      /9\.png is missing among the files; choose it/,
    ],
    ['text', (files) => [...files, new File(['hello'], 'note.png')], /note\.png is not a PNG image; save it as PNG/],
    [
      'an image that is not square',
      async (files) => [
        ...files,
        new File(
          [
            (await encodePng({
              width: 64,
              height: 32,
              channels: 1,
              data: new Uint8Array(2048),
            })) as Uint8Array<ArrayBuffer>,
          ],
          'wide.png',
        ),
      ],
      /wide\.png has 64 × 32 pixels, but a tile must be square/,
    ],
    [
      'a side that is no power of two',
      async () => [await odd(48)],
      /odd\.png has 48 × 48 pixels, but a tile must be square with a power of two/,
    ],
    [
      'images of several sizes',
      async (files) => [...files, await odd(32)],
      /(odd|\d)\.png has (32|64) pixels per side, but .*; give every tone the same/,
    ],
    [
      'a wrong size in a set',
      (files) => [json({ size: 128 }), ...files],
      /\d\.png has 64 × 64 pixels, but level 0 of size 128 needs 128 × 128/,
    ],
    [
      'a set from dark to light',
      (files) => [json({ images: ['7.png', '8.png', '9.png'] }), ...files],
      /7\.png is the darkest image but comes first; list the lightest first/,
    ],
    ['broken JSON', () => [new File(['{"format": '], 'map.json')], /map\.json is not valid JSON; save the map again/],
    [
      'JSON of something else',
      () => [new File(['[1]'], 'data.json')],
      /data\.json does not describe a tonal art map; its "format" must be/,
    ],
    ['null', () => [new File(['null'], 'data.json')], /data\.json does not describe a tonal art map/],
    [
      'another version',
      () => [json({ version: 2 })],
      /map\.json is of version 2, but this three-hatching reads version 1; update/,
    ],
    ['an odd size', () => [json({ size: 65 })], /map\.json has "size" 65, but it must be a power of two/],
    ['one tone', () => [json({ images: ['9.png'] })], /map\.json must name at least two "images"/],
    ['names that are none', () => [json({ images: ['9.png', 5] })], /must name at least two "images"/],
    ['levels for some tones only', () => [json({ images: [['9.png'], '8.png'] })], /must name at least two "images"/],
    [
      'different levels',
      () => [json({ images: [['9.png'], ['8.png', '7.png']] })],
      /must name the same number of levels for every tone/,
    ],
    [
      'grey thresholds',
      (files) => [json({ images: [['9.png'], ['8.png']], thresholds: ['7.png'] }), ...files],
      /7\.png holds no thresholds: it is grey/,
    ],
    ['one image alone', async () => [await png('0.png', 64, new Uint8Array(4096).fill(255))], /at least two tones/],
  ])('%s', async (_, make, message) => {
    const source = (await make(await artistsFiles())) as File[];
    const loading = TonalArtMap.load(source);
    await expect(loading).rejects.toThrow(message);
    await expect(loading).rejects.toThrow(/^TonalArtMap\.(load|fromHatchImages): /);
  });

  it('an address that is not found, and one that cannot be reached', async () => {
    serve([json({})]);
    await expect(TonalArtMap.load('http://maps.test/set/map.json')).rejects.toThrow(
      /^TonalArtMap\.load: \d\.png could not be fetched \(404\); check the address/,
    );
    vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')));
    await expect(TonalArtMap.load('http://elsewhere.test/map.json')).rejects.toThrow(
      /^TonalArtMap\.load: http:\/\/elsewhere\.test\/map\.json could not be fetched \(Failed to fetch\); check the address/,
    );
  });

  it('a list from dark to light', async () => {
    const files = (await artistsFiles()).toReversed();
    serve(files);
    await expect(TonalArtMap.load(files.map(({ name }) => `http://maps.test/set/${name}`))).rejects.toThrow(
      /7\.png is the darkest image but comes first; list the lightest first/,
    );
  });
});

describe('TonalArtMap.load stays within bounds', () => {
  /** 4096 × 4096 pixels of one bit, all ink: 2 kB. */
  const huge = async (name: string): Promise<File> => {
    const small = Buffer.from(await encodePng({ width: 1, height: 1, channels: 1, data: Uint8Array.of(0) }));
    const header = Buffer.from(small.subarray(0, 33));
    header.writeUInt32BE(4096, 16);
    header.writeUInt32BE(4096, 20);
    header.writeUInt8(1, 24);
    const data = deflateSync(Buffer.alloc(4096 * (4096 / 8 + 1)));
    const chunk = Buffer.alloc(12 + data.length);
    chunk.writeUInt32BE(data.length);
    chunk.write('IDAT', 4, 'latin1');
    data.copy(chunk, 8);
    return new File([Buffer.concat([header, chunk, small.subarray(-12)])], name);
  };
  const describing = (size: number, images: unknown): File =>
    new File([JSON.stringify({ format: 'three-hatching tonal art map', version: 1, size, images })], 'map.json');

  /** Serves files, and counts fetches and decoded images. */
  function counting(files: readonly File[]): { fetched: string[]; decoded(): number } {
    serve(files);
    const fetched: string[] = [];
    const { fetch: served } = globalThis;
    vi.stubGlobal('fetch', (url: URL) => {
      fetched.push(url.href.split('/').at(-1)!);
      return served(url);
    });
    const decoders = vi.fn(function (this: unknown, format: CompressionFormat) {
      return new Native(format);
    });
    const Native = DecompressionStream;
    vi.stubGlobal('DecompressionStream', decoders);
    return { fetched, decoded: () => decoders.mock.calls.length };
  }
  const address = (name: string): string => `http://maps.test/set/${name}`;

  it('refuses forty tones of 4096 texels before it reads any, and a list of them after the first', async () => {
    const picture = await huge('huge.png');
    const says = /has 40 tones of 4096 × 4096 texels, but at most 4 of that size are allowed; make the images smaller/;
    const many = counting([picture, describing(4096, Array(40).fill('huge.png'))]);
    await expect(TonalArtMap.load(address('map.json'))).rejects.toThrow(says);
    expect([many.fetched, many.decoded()]).toEqual([['map.json'], 0]);
    await expect(TonalArtMap.load(Array(40).fill(address('huge.png')))).rejects.toThrow(says);
    expect([many.fetched, many.decoded()]).toEqual([['map.json', 'huge.png'], 1]);
  });

  it('decodes no more pictures after one of a wrong size', async () => {
    const names = Array.from({ length: 40 }, (_, i) => `${i}.png`);
    const pictures = await Promise.all(names.map(huge));
    const many = counting([...pictures, describing(64, names)]);
    await expect(TonalArtMap.load(address('map.json'))).rejects.toThrow(
      /0\.png has 4096 × 4096 pixels, but level 0 of size 64 needs 64 × 64/,
    );
    expect(many.decoded()).toBe(1);
  });

  it('refuses more than 64 tones of any size', async () => {
    const names = Array.from({ length: 65 }, (_, i) => `${i}.png`);
    const says = /has 65 tones, but at most 64 are allowed; leave some out/;
    const none = counting([describing(1, names)]);
    await expect(TonalArtMap.load(address('map.json'))).rejects.toThrow(says);
    await expect(TonalArtMap.load(names.map(address))).rejects.toThrow(says);
    expect(none.fetched).toEqual(['map.json']);
    const images = names.map(() => [new Uint8Array(1)]);
    expect(() => TonalArtMap.fromHatchImages({ size: 1, images })).toThrow(says);
  });

  it('decodes a picture once, however often it is named', async () => {
    const [light, dark] = await artistsFiles();
    const many = counting([
      light,
      dark,
      describing(
        64,
        [light, light, dark, dark, dark].map(({ name }) => name),
      ),
    ]);
    const map = await TonalArtMap.load(address('map.json'));
    expect([many.fetched, many.decoded()]).toEqual([['map.json', light.name, dark.name], 2]);
    // Including the blank paper that was added.
    expect([1, 3, 5].map((tone) => map.image(tone, 0))).toEqual(
      [1, 2, 2].map((tone) => hatchImages({ style: 'hatching', size: 64, tones: 4 }).images[tone][0]),
    );
  });
});
