import { describe, expect, test } from 'vitest';
import { colorsOf, measure, read, refusal, triangles } from '../../../../../tools/modelFiles/modelWriters.js';
import { usda, zip } from '../../../../../tools/modelFiles/sceneWriters.js';

/** A square, one unit to the right of the one before it, of `faces` of three corners. */
const square = (name: string, x: number, more = '', faces = '0, 1, 2, 0, 2, 3'): string => `
    def Mesh "${name}"
    {
        int[] faceVertexCounts = [3, 3]
        int[] faceVertexIndices = [${faces}]
        point3f[] points = [(${x}, 0, 0), (${x + 1}, 0, 0), (${x + 1}, 1, 0), (${x}, 1, 0)]
        ${more}
    }`;
const layer = (...prims: string[]): string =>
  `#usda 1.0\n(\n    defaultPrim = "Root"\n)\n\ndef Xform "Root"\n{\n${prims.join('\n')}\n}\n`;
const usd = (...prims: string[]) => read(['a.usda', layer(square('first', 0), ...prims)]);
const shader = (inputs: string): string => `
    def Material "m"
    {
        token outputs:surface.connect = </Root/m/s.outputs:surface>
        def Shader "s"
        {
            uniform token info:id = "UsdPreviewSurface"
            ${inputs}
            token outputs:surface
        }
    }`;

describe('USD', () => {
  test.each([
    ['invisible', square('b', 2, 'token visibility = "invisible"')],
    ['a guide', square('b', 2, 'uniform token purpose = "guide"')],
    ['inactive', square('b', 2).replace('"b"', '"b" (\n        active = false\n    )')],
    [
      'below what is invisible',
      `\n    def Xform "x"\n    {\n        token visibility = "invisible"${square('b', 2)}\n    }`,
    ],
  ])('what is %s is not drawn', async (_, prim) => {
    expect(triangles(await usd(square('b', 2)))).toBe(4);
    const seen = await usd(prim);
    expect([triangles(seen), seen.notes]).toEqual([2, []]);
  });

  test('proxy prims are drawn if there is nothing else', async () => {
    const proxy = square('b', 2, 'uniform token purpose = "proxy"');
    expect(triangles(await usd(proxy))).toBe(4);
    expect(triangles(await usd(proxy, square('c', 4, 'uniform token purpose = "render"')))).toBe(4);
  });

  test('left-handed meshes are not turned inside out', async () => {
    const left = usda()
      .replace(
        /faceVertexIndices = \[(.*)\]/g,
        (_, list: string) => `faceVertexIndices = [${list.split(', ').reverse().join(', ')}]`,
      )
      .replace(/(point3f\[\] points)/g, 'uniform token orientation = "leftHanded"\n        $1');
    expect(measure(await read(['box.usda', left])).volume).toBeCloseTo(
      measure(await read(['box.usda', usda()])).volume,
      5,
    );
  });

  test('files that are read at once do not change how the others are read', async () => {
    const hidden = layer(square('first', 0), square('b', 2, 'token visibility = "invisible"'));
    const seen = await Promise.all(Array.from({ length: 4 }, () => read(['a.usda', hidden])));
    expect(seen.map(triangles)).toEqual([2, 2, 2, 2]);
  });

  test('faces in no subset are drawn with the material of their mesh', async () => {
    const subset = (material: string): string => `
        def GeomSubset "part"
        {
            uniform token elementType = "face"
            int[] indices = [1]
            ${material}
        }`;
    const blue = shader('color3f inputs:diffuseColor = (0, 0, 1)');
    const parts = await usd(square('b', 2, subset('rel material:binding = </Root/m>')), blue);
    expect(colorsOf(parts).sort()).toEqual(['0,0,255', '255,255,255', '255,255,255', '255,255,255']);
    expect(triangles(await usd(square('b', 2, subset(''))))).toBe(4);
  });

  test.each([
    ['    def BasisCurves "k"\n    {\n    }', 'points and lines left out'],
    ['    def Points "k"\n    {\n    }', 'points and lines left out'],
    ['    def NurbsPatch "k"\n    {\n    }', 'curved surfaces left out'],
    ['    def PointInstancer "k"\n    {\n    }', 'instances left out'],
    ['    def Xform "k" (\n        references = @other.usda@\n    )\n    {\n    }', 'parts in other files left out'],
    ['    def Xform "k" (\n        payload = @other.usdc@\n    )\n    {\n    }', 'parts in other files left out'],
    ['    def Xform "k" (\n        append references = </Root/first>\n    )\n    {\n    }', 'repeated parts left out'],
    [shader('float inputs:displacement = 0.3'), 'displacement left out'],
    [
      square(
        'b',
        2,
        'color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] (\n            interpolation = "uniform"\n        )',
      ),
      'colours of single faces and points left out',
    ],
  ])('what is not drawn is said: %s', async (prim, note) => {
    expect((await usd(prim)).notes).toEqual([note]);
  });

  test('parts in the files of a package are drawn', async () => {
    const root = layer('    def Xform "k" (\n        prepend references = @b.usda@\n    )\n    {\n    }');
    const packed = await read(['a.usdz', zip({ 'a.usda': root, 'b.usda': layer(square('b', 2)) }, 0)]);
    expect([triangles(packed), packed.notes]).toEqual([2, []]);
  });

  test('a file with nothing visible is refused', async () => {
    const hidden = layer(square('b', 2, 'token visibility = "invisible"'));
    expect(await refusal(['a.usda', hidden])).toMatch(/^The file holds no triangles/);
  });
});
