import { PNG } from 'pngjs';
import { ClampToEdgeWrapping, RepeatWrapping } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { NodeSurroundings } from '../../../../../src/command/draw/NodeSurroundings.js';
import type { PixelPicture } from '../../../../../src/viewer/files/common/Surroundings.js';
import { type ReadMesh, readModel } from '../../../../../src/viewer/files/readModel.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../../tools/modelFiles/box.js';
import {
  colorsOf,
  colouredBoxMtl,
  colouredBoxObj,
  file,
  measure,
  read,
  triangles,
} from '../../../../../tools/modelFiles/modelWriters.js';

const RED = '255,0,0';
const GREEN = '0,255,0';
const BLUE = '0,0,255';
const rgb = [RED, RED, RED, RED, GREEN, GREEN, GREEN, GREEN, BLUE, BLUE, BLUE, BLUE];

describe('OBJ', () => {
  test('every material of a group is drawn', async () => {
    const box = await read(['box.obj', colouredBoxObj], ['box.mtl', colouredBoxMtl]);
    expect(colorsOf(box)).toEqual(rgb);
    expect(box.notes).toEqual([]);
    const { area, volume } = measure(box);
    const side = 2 / Math.sqrt(3);
    expect(area).toBeCloseTo(6 * side ** 2, 4);
    expect(volume).toBeCloseTo(side ** 3, 4);
  });

  test('materials are found in several files, with names in any spacing, and what is missing is named', async () => {
    const obj = colouredBoxObj
      .replace('mtllib box.mtl', 'mtllib my red.mtl\n\tmtllib  green.mtl blue.mtl')
      .replaceAll('usemtl ', ' usemtl\t');
    const box = await read(
      ['box.obj', obj],
      ['my red.mtl', 'newmtl\tred\r\n\tKd 1 0 0\r\n'],
      ['green.mtl', 'newmtl green\nKd 0 1 0'],
    );
    expect(colorsOf(box)).toEqual([...rgb.slice(0, 8), ...new Array(4).fill('255,255,255')]);
    expect(box.notes).toEqual(['blue.mtl is missing: drop it along']);
  });

  test('materials of polished metal mirror, in the colour of their gloss', async () => {
    const metal = 'newmtl red\nKd 0 0 0\n\tKs 0.8\r\nNs 200\n';
    const renamed = (text: string): string => text.replaceAll('red', 'metal');
    const mirrors = async (mtl: string): Promise<number[]> => {
      const { mesh } = await read(['box.obj', renamed(colouredBoxObj)], ['box.mtl', renamed(mtl)]);
      return (mesh.ranges ?? []).filter((range) => range.mirrors).map(({ count }) => count);
    };
    expect(await mirrors(metal)).toEqual([12]);
    expect(await mirrors(metal.replace('Ns 200', 'Ns 5'))).toEqual([]);
    expect(await mirrors(metal.replace('Ks 0.8', 'Ks spectral gloss.rfl 1'))).toEqual([]);
  });

  test('a name of materials with spaces is one name, also where its file is missing', async () => {
    const named = (names: string): string => colouredBoxObj.replace('mtllib box.mtl', `mtllib ${names}`);
    const missing = async (names: string, ...files: [string, string][]): Promise<string[]> =>
      (await read(['box.obj', named(names)], ...files)).missing;
    expect(await missing('my red  box.mtl')).toEqual(['my red  box.mtl']);
    expect(await missing('my red.mtl materials/my green.MTL')).toEqual(['my red.mtl', 'my green.MTL']);
    expect(await missing('my red.mtl my green.mtl', ['my green.mtl', 'newmtl green'])).toEqual(['my red.mtl']);
    expect(await missing('no extension')).toEqual(['no extension']);
    // Two names after all.
    expect(await missing('a b.mtl', ['b.mtl', 'newmtl green'])).toEqual(['a']);
    const colours = await read(['box.obj', named('my box.mtl')], ['My Box.mtl', colouredBoxMtl]);
    expect(colorsOf(colours)).toEqual(rgb);
  });

  test.each(['', ' 1', ' 0.5'])('colours of a part of its vertices, the others (%s) white', async (weight) => {
    const corners = BOX_CORNERS.map((corner, i) => `v ${corner.join(' ')}${i < 4 ? ' 1 0 0' : `${weight} `}`).join(
      '\n',
    );
    const faces = BOX_FACES.map((face) => `f ${face.map((v) => v + 1).join(' ')}`).join('\n');
    const box = await read(['box.obj', `${corners}\n${faces}`]);
    expect(new Set(colorsOf(box))).toEqual(new Set([RED, '255,255,255']));
    expect(triangles(box)).toBe(12);
    const { positions, colors } = box.mesh;
    for (let vertex = 0; vertex < positions.length / 3; vertex++) {
      expect([...colors!.subarray(3 * vertex, 3 * vertex + 3)]).toEqual(
        positions[3 * vertex + 2] < 0 ? [1, 0, 0] : [1, 1, 1],
      );
    }
  });

  test('a colour of one number is grey, one that is no number is white', async () => {
    const box = await read(
      ['box.obj', colouredBoxObj],
      ['box.mtl', 'newmtl red\nKd 0.5\nnewmtl green\nKd spectral a.rfl 1\nnewmtl blue\nKd x y z'],
    );
    expect(new Set(colorsOf(box))).toEqual(new Set(['128,128,128', '255,255,255']));
  });

  test('comments, lines, points and unknown words take no triangles away', async () => {
    const obj = colouredBoxObj
      .replace(/^v .*$/gm, '$& # a corner 7 8 9')
      .replace(/^f .*$/gm, '$& # a face\nl 1 2 3\np 4\ncurv 0 1 2')
      .replace('usemtl green', 'usemtl #25')
      .replace(/\n/g, '\r');
    const box = await read(['box.obj', `# box\r${obj}`], ['box.mtl', colouredBoxMtl.replace('green', '#25')]);
    expect(triangles(box)).toBe(12);
    expect(box.notes).toEqual(['points and lines left out']);
    expect(colorsOf(box)).toEqual(rgb);
  });

  test('faces go on in the next line after a backslash', async () => {
    const box = await read(['box.obj', colouredBoxObj.replace(/^(f \d+ \d+) /gm, '$1\\\n')]);
    expect(triangles(box)).toBe(12);
  });

  test.each(['utf16le', 'utf16be'])('%s is read, with and without a mark', async (encoding) => {
    const encode = (text: string): Uint8Array => {
      const bytes = Buffer.from(text, 'utf16le');
      return encoding === 'utf16le' ? bytes : bytes.swap16();
    };
    for (const mark of ['', '\uFEFF']) {
      const box = await read(['box.obj', encode(mark + colouredBoxObj)], ['box.mtl', encode(mark + colouredBoxMtl)]);
      expect(colorsOf(box)).toEqual(rgb);
    }
  });

  test('normals that are missing, zero or not there leave no normal that is not a number', async () => {
    const corners = BOX_CORNERS.map((corner) => `v ${corner.join(' ')}`).join('\n');
    const faces = BOX_FACES.map(
      (face, i) => `f ${face.map((v) => `${v + 1}${['//1', '//2', '//9', ''][i % 4]}`).join(' ')}`,
    );
    const { mesh, notes } = await read(['box.obj', `${corners}\nvn 0 0 0\nvn 0 0 2\n${faces.join('\n')}`]);
    expect(mesh.normals!.every(Number.isFinite)).toBe(true);
    const lengths = new Set(
      Array.from({ length: 36 }, (_, i) => Math.hypot(...mesh.normals!.subarray(3 * i, 3 * i + 3))),
    );
    expect(lengths).toEqual(new Set([0, 1]));
    expect(notes).toEqual([]);
  });

  test('a vertex without coordinates keeps its index, so that faces keep their corners', async () => {
    const [a, b, c, d] = ['v 0 0 0', 'v 2 0 0', 'v 0 3 0', 'v 0 0 4'];
    const whole = await read(['a.obj', [a, b, c, d, 'vn 0 0 1', 'f 1//1 2//1 3//1', 'f 1 2 4'].join('\n')]);
    const obj = [a, 'v', b, c, 'v ', d, 'vn', 'vn 0 0 1', 'f 1//2 3//2 4//2', 'f 1 3 6', 'f 1 2 6'].join('\n');
    const lacking = await read(['a.obj', obj]);
    expect(measure(lacking)).toEqual(measure(whole));
    expect(lacking.details).toEqual(['1 triangle without three valid corners left out']);
    expect(lacking.changes).toMatchObject([{ kind: 'orientation' }]);
  });

  test('triangles with a corner that does not exist are left out, and counted', async () => {
    const box = await read(['box.obj', colouredBoxObj.replace(/^f 1 .*$/m, 'f 1 2 99')]);
    expect(triangles(box)).toBe(10);
    expect(box.notes).toEqual(['box.mtl is missing: drop it along']);
    expect(box.details).toEqual(['1 triangle without three valid corners left out']);
  });
});

describe('OBJ with pictures', () => {
  afterEach(() => vi.unstubAllGlobals());

  const picture = (): Buffer => PNG.sync.write(new PNG({ width: 8, height: 4 }));
  const texturedObj = colouredBoxObj
    .replace(/^f .*$/gm, (line) => line.replace(/\d+/g, (corner, at) => `${corner}/${1 + (at % 4)}`))
    .replace('o box', 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1');

  test('the triangles of every picture lie in a range of their own', async () => {
    const asked: unknown[] = [];
    vi.stubGlobal('createImageBitmap', async (_: Blob, options: unknown) => {
      asked.push(options);
      return { close() {} };
    });
    const box = await read(
      ['box.obj', texturedObj],
      [
        'box.mtl',
        'newmtl red\nKd 0 0 0\nmap_Kd -clamp on -s 2 3 1 wood.png\nnewmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\nmap_Kd textures\\WOOD.png\nmap_d leaf.png',
      ],
      ['Wood.PNG', picture()],
    );
    const { mesh, pictures, notes } = box;
    expect(notes).toEqual(['leaf.png is missing: drop it along']);
    expect(mesh.ranges).toEqual([
      { start: 0, count: 12, picture: -1, paint: '00ff00' },
      { start: 12, count: 12, picture: 0, paint: 'ffffff' },
      { start: 24, count: 12, picture: 1, paint: '0000ff' },
    ]);
    expect(pictures.map((one) => [one!.wrapS, one!.wrapT, one!.cutOut])).toEqual([
      [ClampToEdgeWrapping, ClampToEdgeWrapping, 0],
      [RepeatWrapping, RepeatWrapping, 0.5],
    ]);
    // One bitmap for both, the right way up.
    expect(asked).toEqual([expect.objectContaining({ resizeWidth: 8, resizeHeight: 4, imageOrientation: 'flipY' })]);
    expect(pictures[0]!.bitmap).toBe(pictures[1]!.bitmap);
    // Black would hide the picture. Its scale is in the texture coordinates.
    expect(colorsOf(box)).toEqual([
      ...new Array(4).fill(GREEN),
      ...new Array(4).fill('255,255,255'),
      ...new Array(4).fill(BLUE),
    ]);
    const [first] = mesh.indices!.subarray(12);
    const corners = Array.from({ length: 12 }, (_, i) => [...mesh.uvs!.subarray(2 * (first + i), 2 * (first + i) + 2)]);
    expect(Math.max(...corners.map(([u]) => u))).toBe(2);
    expect(Math.max(...corners.map(([, v]) => v))).toBe(3);
  });

  test('an alpha map cuts out the colour map or the surface, by its lightness or its alpha', async () => {
    const pngOf = (...pixels: number[][]): Buffer => {
      const png = new PNG({ width: pixels.length, height: 1 });
      png.data = Buffer.from(pixels.flat());
      return PNG.sync.write(png);
    };
    const drawnWith = async (mtl: string): Promise<[pixels: number[], cutOut: number]> => {
      const files = {
        'box.obj': texturedObj,
        'box.mtl': `newmtl blue\n${mtl}`,
        'wood.png': pngOf([10, 20, 30, 255], [40, 50, 60, 255]),
        'leaf.png': pngOf([10, 20, 30, 0], [40, 50, 60, 255]),
        'soft.png': pngOf([10, 20, 30, 90], [40, 50, 60, 160]),
        'empty.png': pngOf([10, 20, 30, 0], [40, 50, 60, 0]),
        'light.png': pngOf([0, 0, 0, 255], [255, 255, 255, 255]),
        'clear.png': pngOf([255, 255, 255, 0], [255, 255, 255, 255], [255, 255, 255, 255], [255, 255, 255, 255]),
      };
      const model = await readModel(
        Object.entries(files).map(([name, content]) => file(name, content)),
        () => {},
        new NodeSurroundings('.'),
      );
      const [picture] = (model as ReadMesh).pictures;
      return [[...(picture!.bitmap as PixelPicture).data], picture!.cutOut];
    };
    expect(await drawnWith('map_Kd wood.png')).toEqual([[10, 20, 30, 255, 40, 50, 60, 255], 0]);
    expect(await drawnWith('map_Kd wood.png\nmap_d light.png')).toEqual([[10, 20, 30, 0, 40, 50, 60, 255], 0.5]);
    expect(await drawnWith('map_Kd wood.png\nmap_d clear.png')).toEqual([[10, 20, 30, 0, 40, 50, 60, 255], 0.5]);
    expect(await drawnWith('map_d light.png')).toEqual([[255, 255, 255, 0, 255, 255, 255, 255], 0.5]);
    expect(await drawnWith('map_Kd wood.png\nmap_d wood.png')).toEqual([[10, 20, 30, 255, 40, 50, 60, 255], 0]);
    // Without an alpha map, only a colour map that is all or nothing cuts.
    expect((await drawnWith('map_Kd leaf.png'))[1]).toBe(0.5);
    expect((await drawnWith('map_Kd soft.png'))[1]).toBe(0);
    expect((await drawnWith('map_Kd empty.png'))[1]).toBe(0);
  });

  test('pictures are judged by their headers, all together, before one is decoded', async () => {
    const widths: number[] = [];
    vi.stubGlobal('createImageBitmap', async (_: Blob, { resizeWidth }: ImageBitmapOptions) => {
      widths.push(resizeWidth!);
      return { close() {} };
    });
    const large = picture();
    large.writeUInt32BE(8192, 16);
    large.writeUInt32BE(8192, 20);
    const tga = Buffer.alloc(18);
    tga[2] = 10;
    tga.writeUInt16LE(65535, 12);
    tga.writeUInt16LE(65535, 14);
    const names = ['a.png', 'b.png', 'c.png', 'd.png', 'e.png', 'f.tga'];
    const faces = names.map((_, i) => `usemtl m${i}\nf 1/1 2/2 ${3 + (i % 2)}/3`);
    const { pictures, notes } = await read(
      ['box.obj', ['mtllib a.mtl', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1', ...faces].join('\n')],
      ['a.mtl', names.map((name, i) => `newmtl m${i}\nmap_Kd ${name}`).join('\n')],
      ...names.map((name): [string, Buffer] => [name, name.endsWith('tga') ? tga : large]),
    );
    expect(widths).toEqual([2048, 2048, 2048, 2048]);
    expect(pictures.map(Boolean)).toEqual([true, true, true, true, false, false]);
    expect(notes.slice(-2)).toEqual(['without e.png and f.tga: too large', 'pictures reduced to 2,048 pixels']);
  });

  test('pictures that are missing or none are named once, and colours stay', async () => {
    vi.stubGlobal('createImageBitmap', async () => {
      throw new Error('not a picture');
    });
    const box = await read(
      ['box.obj', texturedObj],
      [
        'box.mtl',
        'newmtl red\nKd 1 0 0\nmap_Kd a.png\nnewmtl green\nKd 0 1 0\nmap_Kd a.png\nnewmtl blue\nKd 0 0 1\nmap_Kd b.tif',
      ],
      ['b.tif', 'II*'],
    );
    expect(box.pictures).toEqual([undefined, undefined]);
    expect(new Set(colorsOf(box))).toEqual(new Set([RED, GREEN, BLUE]));
    expect(box.notes).toEqual(['a.png is missing: drop it along', 'without b.tif: no picture that a browser reads']);
  });
});

describe('what an OBJ file holds beside faces', () => {
  test.each([
    ['l -3 -2 -1', 'points and lines left out'],
    ['  p 1 2', 'points and lines left out'],
    ['surf 0 1 0 1 1 2 3', 'curved surfaces left out'],
  ])('"%s" is said', async (line, note) => {
    const { notes, mesh } = await read(['box.obj', `${colouredBoxObj.replace(/^mtllib.*\n/, '')}\n${line}\n`]);
    expect([notes, mesh.indices!.length]).toEqual([[note], 36]);
  });

  test('names and comments that begin so are not', async () => {
    const { notes } = await read(['box.obj', colouredBoxObj.replace('mtllib box.mtl', 'o l 1\n# l 1 2\ng p 1')]);
    expect(notes).toEqual([]);
  });
});

describe('options of pictures', () => {
  const texturedObj = 'mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3';
  const options: [line: string, scale: number[], offset: number[]][] = [
    ['-s 2 3 1 -o 0.5 0.25 0', [2, 3], [0.5, 0.25]],
    ['-s 2', [2, 1], [0, 0]],
    ['-o .5 -.25', [1, 1], [0.5, -0.25]],
    ['-clamp on -bm 0.3 -blendu off -mm 0 1 -texres 512 -imfchan l -S 2 3', [2, 3], [0, 0]],
    ['-t 1 1 1 -o 1e-1 2E-1 0', [1, 1], [0.1, 0.2]],
  ];
  test.each(options)('%s before the name of the file, which has spaces', async (text, scale, offset) => {
    vi.stubGlobal('createImageBitmap', async () => ({ close() {} }));
    const mtl = `newmtl m\n\tmap_Kd ${text} my  2. wood.png\n`;
    const { mesh, notes, pictures } = await read(
      ['a.obj', texturedObj],
      ['a.mtl', mtl],
      ['My  2. Wood.png', PNG.sync.write(new PNG({ width: 8, height: 4 }))],
    );
    expect(notes).toEqual([]);
    const [a, b, c] = [0, 1, 2].map((k) => [...mesh.uvs!.subarray(2 * mesh.indices![k], 2 * mesh.indices![k] + 2)]);
    [b[0] - a[0], c[1] - a[1]].forEach((value, i) => {
      expect(value).toBeCloseTo(scale[i], 6);
    });
    a.forEach((value, i) => {
      expect(value).toBeCloseTo(offset[i], 6);
    });
    const wrap = text.includes('-clamp on') ? ClampToEdgeWrapping : RepeatWrapping;
    expect([pictures[0]!.wrapS, pictures[0]!.wrapT]).toEqual([wrap, wrap]);
  });

  test.each(['"my wood.png"', 'my wood.png -s 1 1 1', '-type sphere C:\\pictures\\my wood.png'])(
    'the name in %s is found',
    async (text) => {
      expect((await read(['a.obj', texturedObj], ['a.mtl', `newmtl m\nmap_Kd ${text}\n`])).missing).toEqual([
        'my wood.png',
      ]);
    },
  );
});

describe('OBJ without normals', () => {
  const corners = BOX_CORNERS.map((corner) => `v ${corner.join(' ')}`);
  const faceOf = (face: readonly number[]): string => `f ${face.map((i) => i + 1).join(' ')}`;
  const normalsOf = async (...lines: string[]): Promise<string[]> => {
    const { mesh } = await read(['box.obj', [...corners, ...lines].join('\n')]);
    const normals = mesh.normals ?? [];
    return [...mesh.indices!].map((i) => [0, 1, 2].map((k) => Math.round(100 * (normals[3 * i + k] ?? 0))).join());
  };
  const axes = ['-100,0,0', '100,0,0', '0,-100,0', '0,100,0', '0,0,-100', '0,0,100'];

  test('gets them later where it says nothing of smoothing', async () => {
    expect(new Set(await normalsOf(...BOX_FACES.map(faceOf)))).toEqual(new Set(['0,0,0']));
  });

  test.each(['s off', 's 0'])('is flat where smoothing is off: %s', async (off) => {
    const normals = await normalsOf(off, ...BOX_FACES.map(faceOf));
    expect(new Set(normals)).toEqual(new Set(axes));
  });

  test.each(['s 1', 's on', ' s  3 '])('is smooth within a group: %s', async (group) => {
    const normals = new Set(await normalsOf(group, ...BOX_FACES.map(faceOf)));
    expect(normals.size).toBe(8);
    for (const normal of normals) expect(normal.split(',').map((x) => Math.abs(Number(x)))).toEqual([58, 58, 58]);
  });

  test('has edges between groups, whatever the materials, and groups last until the next one', async () => {
    const apart = await normalsOf(...BOX_FACES.flatMap((face, i) => [`s ${i + 1}`, faceOf(face)]));
    expect(new Set(apart)).toEqual(new Set(axes));
    const together = await normalsOf('s 7', ...BOX_FACES.flatMap((face, i) => [`usemtl m${i}`, faceOf(face)]));
    expect(new Set(together).size).toBe(8);
    const [first, ...others] = BOX_FACES.map(faceOf);
    const mixed = new Set(await normalsOf(first, 's 1', others[0], 's off', ...others.slice(1)));
    expect(mixed.has('0,0,0')).toBe(true);
  });

  test('keeps those that it has, whichever way they are counted', async () => {
    const normals = await normalsOf(
      'vn 0 0 1',
      's 1',
      'f 1//1 2//1 3//1',
      'vn 0 1 0',
      'f -8//-1 -7//-1 -3//-1',
      'f -8//-2 2//-2 4//-2',
      's off',
      'f 1 2 7',
    );
    // Triangles whose windings contradict each other are turned, with their normals.
    expect(normals.slice(0, 9).map((normal) => normal.replace('-', ''))).toEqual([
      ...Array(3).fill('0,0,100'),
      ...Array(3).fill('0,100,0'),
      ...Array(3).fill('0,0,100'),
    ]);
    expect(normals[9]).not.toBe('0,0,0');
  });
});
