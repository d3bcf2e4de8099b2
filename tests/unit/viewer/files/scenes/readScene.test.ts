import { PNG } from 'pngjs';
import { FileLoader, ImageLoader, TextureLoader } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { withFakeDocument, XmlParser } from '../../../../../src/viewer/files/scenes/fakeDocument.js';
import {
  type Content,
  colorsOf,
  colouredBoxMtl,
  colouredBoxObj,
  measure,
  read,
  refusal,
  triangles,
} from '../../../../../tools/modelFiles/modelWriters.js';
import { dae, fbx, tds, threeMf, usda, wrl, zip } from '../../../../../tools/modelFiles/sceneWriters.js';

const SIDE = 2 / Math.sqrt(3);
const picture = (): Uint8Array => PNG.sync.write(new PNG({ width: 8, height: 4 }));

afterEach(() => vi.unstubAllGlobals());

const formats: [name: string, content: Content, upAxis: string][] = [
  ['box.fbx', fbx(), 'y'],
  ['box.dae', dae(), 'y'],
  ['box.dae', dae().replace(/^[\s\S]*?(?=<COLLADA)/, ''), 'y'],
  ['box.wrl', wrl(), 'y'],
  ['box.usda', usda(), 'y'],
  ['box.usdz', zip({ 'box.usda': usda() }, 0), 'y'],
  ['box.3mf', threeMf(), 'z'],
  ['box.3ds', tds(), 'z'],
];

describe.each(formats)('%s', (name, content, upAxis) => {
  test('is drawn with its colours, whatever it is called', async () => {
    vi.stubGlobal('fetch', () => expect.unreachable('nothing is fetched'));
    const message = vi.spyOn(console, 'error');
    for (const called of [name, 'box.obj']) {
      const box = await read([called, content]);
      expect(triangles(box)).toBe(12);
      expect(measure(box).volume).toBeCloseTo(SIDE ** 3, 3);
      expect(measure(box).area).toBeCloseTo(6 * SIDE ** 2, 3);
      const counts = new Map<string, number>();
      for (const colour of colorsOf(box)) counts.set(colour, (counts.get(colour) ?? 0) + 1);
      expect(counts).toEqual(
        new Map([
          ['255,0,0', 4],
          ['0,255,0', 4],
          ['0,0,255', 4],
        ]),
      );
      expect(box.upAxis).toBe(upAxis);
      expect(box.notes).toEqual([]);
    }
    expect(message).not.toHaveBeenCalled();
  });

  test('is refused with a sentence without JavaScript when it is cut short', async () => {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
    for (const share of [0.2, 0.5, 0.9, 0.97]) {
      const sentence = await refusal([name, bytes.slice(0, share * bytes.length)]);
      expect(sentence).not.toMatch(/undefined|null|function|reading|Error|THREE|Loader/);
      expect(sentence).toMatch(/^(It was read|The file|None of|box\.[\w.]+ (could|is|needs|seems|holds)).*\.$/);
    }
  });
});

describe('pictures and motion', () => {
  test('are found beside the model or inside of it', async () => {
    vi.stubGlobal('createImageBitmap', async () => ({ close() {} }));
    const inside = zip({ 'box.usda': usda('wood.png'), 'wood.png': picture() }, 0);
    const cases: [string, Content][][] = [
      [
        ['box.dae', dae('textures/wood.png')],
        ['wood.png', picture()],
      ],
      [['box.usdz', inside]],
      [['box.zip', zip({ 'a/box.dae': dae('wood.png'), 'a/wood.png': picture() })]],
    ];
    for (const files of cases) {
      const box = await read(...files);
      expect(box.pictures).toEqual([expect.objectContaining({ cutOut: 0 })]);
      expect(box.mesh.ranges!.map(({ count, picture: index }) => [count, index])).toEqual([
        [12, -1],
        [12, -1],
        [12, 0],
      ]);
      expect(box.notes).toEqual([]);
      // Each corner of the picture is on one of a face: the triangles of both cover it once.
      const corners = [...box.mesh.indices!.subarray(24)].map((i) =>
        [...box.mesh.uvs!.subarray(2 * i, 2 * i + 2)].join(),
      );
      expect(new Set(corners)).toEqual(new Set(['0,0', '1,0', '1,1', '0,1']));
    }
  });

  test.each(['wood.png', 'wood.tga'])('nothing is fetched for %s, which nobody dropped', async (name) => {
    vi.stubGlobal('fetch', () => expect.unreachable('nothing is fetched'));
    expect((await read(['box.dae', dae(`https://example.org/${name}`)])).notes).toEqual([
      `${name} is missing: drop it along`,
    ]);
  });

  test('no loader of three can fetch', () => {
    vi.stubGlobal('fetch', () => expect.unreachable('nothing is fetched'));
    withFakeDocument(() => {
      new FileLoader().load('https://example.org/a.bin', () => {});
      new TextureLoader().load('https://example.org/a.png');
    });
  });

  test('the objects of a page are restored afterwards', async () => {
    const { load } = ImageLoader.prototype;
    const { createObjectURL } = URL;
    await read(['box.dae', dae()]);
    await refusal(['box.dae', dae().slice(0, 900)]);
    expect([ImageLoader.prototype.load, URL.createObjectURL]).toEqual([load, createObjectURL]);
    expect('DOMParser' in globalThis || 'window' in globalThis).toBe(false);
  });
});

/** An archive of one file that announces another size of it. */
function announcing(archive: Uint8Array, size: number): Uint8Array {
  const view = new DataView(archive.buffer);
  // The directory of files begins where the archive's last 22 bytes say, and has the size at 24.
  view.setUint32(view.getUint32(archive.length - 6, true) + 24, size, true);
  return archive;
}

test('a 3DS chunk of length 0 causes no endless loop', async () => {
  const box = tds();
  // The chunk of materials is the third: after the outermost and the version.
  for (const at of [6 + 10, 6 + 10 + 6, 6 + 10 + 6 + 6]) {
    const broken = box.slice();
    broken.set([0, 0, 0, 0], at + 2);
    expect(await refusal(['box.3ds', broken])).toBe(
      'box.3ds is damaged or cut short: one of its parts has a wrong length.',
    );
  }
});

test('edges of 3DS stay sharp', async () => {
  expect((await read(['box.3ds', tds()])).mesh.normals).toBe(null);
});

describe('archives', () => {
  test('the best model in one is read, with what belongs to it', async () => {
    const archive = zip({
      '__MACOSX/models/._box.obj': 'rubbish',
      'models/box.mtl': colouredBoxMtl,
      'models/box.obj': colouredBoxObj,
      'models/readme.txt': 'v 1 2 3',
    });
    const box = await read(['box.zip', archive]);
    expect(new Set(colorsOf(box))).toEqual(new Set(['255,0,0', '0,255,0', '0,0,255']));
    expect([box.name, box.notes]).toEqual(['box.obj', []]);
    const two = await read(['all.zip', zip({ 'b.wrl': wrl(), 'a.fbx': fbx() })]);
    expect([two.name, two.notes]).toEqual(['a.fbx', ['one of 2 models in all.zip']]);
    const along = await read(['box.zip', zip({ 'box.obj': colouredBoxObj })], ['box.mtl', colouredBoxMtl]);
    expect(new Set(colorsOf(along)).size).toBe(3);
  });

  test('what cannot be used is said so', async () => {
    expect(await refusal(['a.zip', zip({ 'a.txt': 'a' })])).toBe('a.zip holds no model that this page can read.');
    expect(await refusal(['a.zip', zip({ 'a.zip': 'a' })])).toBe('a.zip holds no model that this page can read.');
    const whole = zip({ 'box.obj': colouredBoxObj });
    expect(await refusal(['a.zip', whole.slice(0, whole.length - 30)])).toBe(
      'a.zip could not be unpacked: it is damaged, was cut short or is locked.',
    );
  });

  test('decompression bombs are not unpacked', async () => {
    const bomb = announcing(zip({ 'box.obj': colouredBoxObj }), 100_000_000);
    expect(await refusal(['a.zip', bomb])).toBe('a.zip unpacks to more than 64 MB, which is too much for its size.');
    const threeMfBomb = announcing(zip({ '3D/a.model': '<model/>' }), 100_000_000);
    expect(await refusal(['a.3mf', threeMfBomb])).toBe(
      'a.3mf unpacks to more than 64 MB, which is too much for its size.',
    );
    const many = zip(Object.fromEntries(Array.from({ length: 10_001 }, (_, i) => [`${i}.obj`, ''])));
    expect(await refusal(['many.zip', many])).toBe('many.zip holds more than 10,000 files, too many for a page.');
    // An archive that announces less than it holds gives no more than that.
    const lying = announcing(zip({ 'box.obj': colouredBoxObj + ' '.repeat(1_000_000) }), 100);
    expect(await refusal(['a.zip', lying])).toMatch(/^The file holds no triangles/);
  });
});

describe('other files are called by their names', () => {
  test('pictures', async () => {
    for (const bytes of [picture(), Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 0, 0, 0)]) {
      expect(await refusal(['photo.obj', bytes])).toBe('photo.obj is a picture, not a 3D model.');
    }
  });

  test.each([
    ['a.splat', 'xxxxxxxx', 'a.splat holds Gaussian splats, not triangles; only surfaces can be hatched.'],
    ['a.pcd', '# .PCD v0.7', 'a.pcd holds a cloud of points, not triangles; only surfaces can be hatched.'],
    ['a.las', 'LASF', 'a.las holds a cloud of points, not triangles; only surfaces can be hatched.'],
    ['a.blend', 'BLENDER-v300', 'a.blend is a Blender file, which this page does not read; save it as GLB, say.'],
    ['a.stp', 'ISO-10303-21;', 'a.stp is a STEP file, which this page does not read; save it as GLB, say.'],
    [
      'a.wrl',
      '#VRML V1.0 ascii',
      'a.wrl is a VRML file of version 1, which this page does not read; save it as GLB, say.',
    ],
    [
      'a.x3d',
      '<?xml version="1.0"?><X3D>',
      'a.x3d is an X3D file, which this page does not read; save it as GLB, say.',
    ],
    ['a.x3d', '<X3D>', 'a.x3d is an X3D file, which this page does not read; save it as GLB, say.'],
    ['a.amf', '<amf unit="millimeter">', 'a.amf is an AMF file, which this page does not read; save it as GLB, say.'],
    ['a.svg', '<svg>', 'a.svg is an XML file, not a 3D model.'],
    ['a.fbx', fbx(6100), 'a.fbx is FBX version 6.1; this page reads version 7 and newer.'],
    ['a.fbx', fbx().replace('FBXVersion', 'Version'), 'a.fbx is damaged: it does not say its version.'],
    ['a.tif', 'MM\0*\0\0\0\b------------------', 'a.tif is not a model this page can read; it takes'],
  ])('%s', async (name, content, sentence) => {
    expect((await refusal([name, content])).startsWith(sentence)).toBe(true);
  });
});

describe('XML', () => {
  test('names with prefixes, quotes, entities, comments, declarations and CDATA', () => {
    const { documentElement } = new XmlParser().parseFromString(
      '\n<?xml version="1.0"?><!DOCTYPE a [<!ENTITY x "y">]><a x:b=\'"1" > 0\' c = "&lt;&#65;&#x42;&x;"><!-- <b> --><x:b>1<c/>2</x:b><![CDATA[<3>]]></a>',
    );
    expect(documentElement.getAttribute('x:b')).toBe('"1" > 0');
    expect(documentElement.getAttributeNS('any', 'b')).toBe('"1" > 0');
    expect(documentElement.getAttribute('c')).toBe('<AB&x;');
    expect(documentElement.getAttribute('d')).toBe(null);
    expect(documentElement.querySelector('b c')?.nodeName).toBe('c');
    expect(documentElement.getElementsByTagName('b')).toEqual([]);
    expect(documentElement.getElementsByTagName('x:b')[0].textContent).toBe('12');
  });

  test.each(['', 'text', '<a>', '<a></b>', '<a b="c>', '<!-- ', '< a/>', '<a/>'.padStart(5000, '<a>')])(
    '%s is refused',
    (text) => {
      expect(() => new XmlParser().parseFromString(text)).toThrow(/^its XML/);
    },
  );
});
