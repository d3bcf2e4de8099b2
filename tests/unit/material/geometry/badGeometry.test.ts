import {
  BufferAttribute,
  type BufferGeometry,
  Float32BufferAttribute,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three';
import { describe, expect, test } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { quad, snapshot } from './quad.js';

describe('bad input is rejected', () => {
  const changed = (change: (geometry: BufferGeometry) => void) => {
    const geometry = quad();
    geometry.name = 'Quad';
    change(geometry);
    return geometry;
  };
  const positions = (values: number[]) => new Float32BufferAttribute(values, 3);
  const beginning = 'prepareHatchingGeometry: the geometry "Quad"';

  test.each<[string, BufferGeometry, string, RegExp]>([
    [
      'no geometry',
      undefined as never,
      'prepareHatchingGeometry: expected a THREE.BufferGeometry, got undefined',
      /mesh\.geometry/,
    ],
    [
      'a mesh',
      { type: 'Mesh' } as never,
      'prepareHatchingGeometry: expected a THREE.BufferGeometry, got Mesh',
      /mesh\.geometry/,
    ],
    [
      'no position',
      changed((g) => g.deleteAttribute('position')),
      `${beginning} has no attribute "position"`,
      /Set one/,
    ],
    [
      'normalized floats of 64 bits',
      changed((g) => g.setAttribute('uv', new BufferAttribute(new Float64Array(8), 2, true))),
      `${beginning}: attribute "uv" is normalized, but a Float64Array`,
      /Set normalized to false/,
    ],
    [
      'freed arrays',
      changed((g) => Reflect.set(g.attributes.position, 'array', null)),
      `${beginning}: the data of attribute "position" is not in memory`,
      /Pass a geometry/,
    ],
    [
      'positions whose buffer was transferred',
      changed((g) =>
        structuredClone(g.attributes.position.array, { transfer: [g.attributes.position.array.buffer as ArrayBuffer] }),
      ),
      `${beginning}: the data of attribute "position" is gone: 0 values for 4 entries`,
      /Pass a geometry whose arrays are still there/,
    ],
    [
      'an index whose buffer was transferred',
      changed((g) => structuredClone(g.index!.array, { transfer: [g.index!.array.buffer as ArrayBuffer] })),
      `${beginning}: the data of the index is gone: 0 values for 6 entries`,
      /Pass a geometry whose arrays are still there/,
    ],
    ['empty index', changed((g) => g.setIndex([])), `${beginning} has no triangles`, /skip it/],
    [
      'no vertices',
      changed((g) => g.setIndex(null).setAttribute('position', positions([]))),
      `${beginning} has no triangles`,
      /skip it/,
    ],
    ['empty draw range', changed((g) => g.setDrawRange(6, 6)), `${beginning} has no triangles`, /skip it/],
    [
      'incomplete triangle',
      changed((g) => g.setIndex([0, 1, 2, 3])),
      `${beginning}: the index count is 4, which is not a multiple of three`,
      /Remove/,
    ],
    [
      'incomplete soup',
      changed((g) => g.setIndex(null)),
      `${beginning}: the vertex count is 4, which is not a multiple of three`,
      /Remove/,
    ],
    [
      'index out of range',
      changed((g) => g.setIndex([0, 1, 4])),
      `${beginning}: corner 2 refers to vertex 4, but there are only 4 vertices`,
      /Fix the index/,
    ],
    [
      'negative index',
      changed((g) => g.setIndex(new BufferAttribute(new Int16Array([0, 1, -1]), 1))),
      `${beginning}: corner 2 refers to vertex 4294967295`,
      /Fix the index/,
    ],
    [
      'NaN',
      changed((g) => g.setAttribute('position', positions([0, 0, 0, 1, 0, 0, 0, Number.NaN, 0, 1, 1, 0]))),
      `${beginning}: the position of vertex 2 is (0, NaN, 0)`,
      /repair or remove/,
    ],
    [
      'infinity',
      changed((g) => g.setAttribute('position', positions([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, Infinity, 0]))),
      `${beginning}: the position of vertex 3 is (1, Infinity, 0)`,
      /repair or remove/,
    ],
    [
      'short attribute',
      changed((g) => g.setAttribute('uv', new Float32BufferAttribute([0, 0], 2))),
      `${beginning}: attribute "uv" has 1 entries, but there are 4 positions`,
      /or delete the attribute/,
    ],
    [
      'short morph target',
      changed((g) => Reflect.set(g.morphAttributes, 'position', [positions([1, 2, 3])])),
      `${beginning}: attribute "position, morph target 0" has 1 entries`,
      /delete/,
    ],
    ...([BigInt64Array, BigUint64Array] as const).map((Big): [string, BufferGeometry, string, RegExp] => [
      `positions of ${Big.name}`,
      changed((g) => g.setAttribute('position', new BufferAttribute(new Big(12) as never, 3))),
      `${beginning}: attribute "position" has a ${Big.name}, which WebGL cannot read`,
      /Use a Float32Array/,
    ]),
    [
      'an attribute of BigInt64Array',
      changed((g) => g.setAttribute('mine', new BufferAttribute(new BigInt64Array(4) as never, 1))),
      `${beginning}: attribute "mine" has a BigInt64Array`,
      /Use a Float32Array/,
    ],
    [
      'an index of BigUint64Array',
      changed((g) => g.setIndex(new BufferAttribute(new BigUint64Array(6) as never, 1))),
      `${beginning}: the index has a BigUint64Array`,
      /a Uint32Array for an index/,
    ],
    [
      'interleaved numbers of a plain array',
      changed((g) => {
        const plain = new InterleavedBuffer(new Array(12).fill(0) as never, 3);
        g.setAttribute('color', new InterleavedBufferAttribute(plain, 3, 0));
      }),
      `${beginning}: attribute "color" has a Array, which WebGL cannot read`,
      /Use a Float32Array/,
    ],
    [
      'an index on the graphics card',
      changed((g) => Reflect.set(g, 'index', { isGLBufferAttribute: true, count: 6, itemSize: 1 })),
      `${beginning}: the data of the index is not in memory (a GLBufferAttribute`,
      /Pass a geometry/,
    ],
    [
      'an attribute without an itemSize',
      changed((g) => g.setAttribute('uv', new BufferAttribute(new Float32Array(8), undefined as never))),
      `${beginning}: attribute "uv" has NaN entries of undefined numbers each`,
      /Give it an itemSize/,
    ],
    ...[null, undefined, 5, {}].map((nothing): [string, BufferGeometry, string, RegExp] => [
      `an attribute that is ${nothing}`,
      changed((g) => Reflect.set(g.attributes, 'uv', nothing)),
      `${beginning}: attribute "uv" is ${typeof nothing === 'object' && nothing ? 'Object' : nothing}, but must be a THREE.BufferAttribute`,
      /Set one, or delete it/,
    ]),
    [
      'a morph target that is null',
      changed((g) => Reflect.set(g.morphAttributes, 'position', [null])),
      `${beginning}: attribute "position, morph target 0" is null, but must be a THREE.BufferAttribute`,
      /Set one, or delete it/,
    ],
    [
      'morph targets that are no list',
      changed((g) => Reflect.set(g.morphAttributes, 'position', {})),
      `${beginning}: morphAttributes.position is Object, but must be a list of THREE.BufferAttribute`,
      /Set one, or delete it/,
    ],
    ...(['attributes', 'morphAttributes', 'drawRange'] as const).map(
      (name): [string, BufferGeometry, string, RegExp] => [
        `${name} that are null`,
        changed((g) => Reflect.set(g, name, null)),
        `${beginning}: ${name} is null`,
        /Keep the object that three\.js has created/,
      ],
    ),
    ...[null, [null]].map((groups): [string, BufferGeometry, string, RegExp] => [
      `groups that are ${JSON.stringify(groups)}`,
      changed((g) => Reflect.set(g, 'groups', groups)),
      `${beginning}: its groups are not an array of groups`,
      /Use addGroup\(\)/,
    ]),
    [
      'group inside a triangle',
      changed((g) => g.addGroup(1, 5, 0)),
      `${beginning}: group 0 starts at index 1, inside a triangle`,
      /multiples of three/,
    ],
  ])('%s', async (_, geometry, message, remedy) => {
    const before = geometry?.isBufferGeometry ? snapshot(geometry) : null;
    const error: Error = await prepareHatchingGeometry(geometry, { adjacency: true }).then(
      () => expect.fail('resolved'),
      (reason) => reason,
    );
    expect(error).toSatisfy((value) => value instanceof TypeError || value instanceof RangeError);
    expect(error.message.slice(0, message.length)).toBe(message);
    expect(error.message).toMatch(remedy);
    if (before) expect(snapshot(geometry)).toEqual(before);
  });

  test.each([
    [{ layout: 'other' }, /unknown layout 'other'.*Use 'auto', 'corner', 'pull' or 'indexed'/],
    [{ creaseAngle: -1 }, /creaseAngle is -1.*radians/],
    [{ creaseAngle: 60 }, /creaseAngle is 60.*radians/],
    [{ creaseAngle: Number.NaN }, /creaseAngle is NaN/],
    [{ smoothingRadius: -1 }, /smoothingRadius is -1\. Pass a length/],
    [{ smoothingRadius: Infinity }, /smoothingRadius is Infinity/],
    [{ smoothingRadius: Number.NaN }, /smoothingRadius is NaN/],
    [
      { layot: 'pull' },
      /^prepareHatchingGeometry: unknown option "layot"\. The known ones are orient, technique, adjacency, layout, /,
    ],
    [{ adjacency: 'yes' }, /^prepareHatchingGeometry: adjacency is yes\./],
    [
      { technique: 'adjacent' },
      /unknown technique 'adjacent'\. Use one of triangle, adjacency, hatching, .*, woodcut\./,
    ],
    [{ technique: 'triangle', layout: 'indexed' }, /^prepareHatchingGeometry: the layout 'indexed' has no adjacency\./],
    [{ adjacency: true, layout: 'indexed' }, /^prepareHatchingGeometry: the layout 'indexed' has no adjacency\./],
    [null, /^prepareHatchingGeometry: the options are null\. Pass an object/],
    ['pull', /^prepareHatchingGeometry: the options are pull\. Pass an object/],
    [{ signal: {} }, /^prepareHatchingGeometry: signal is an object \(Object\), but must be an AbortSignal/],
    [{ signal: new AbortController() }, /signal is an object \(AbortController\).*AbortSignal/],
    [{ onProgress: 5 }, /onProgress is 5, but must be a function/],
    [{ createWorker: {} }, /createWorker is an object \(Object\), but must be a function/],
    [{ weldTolerance: -1e-6 }, /weldTolerance is -0\.000001\. Pass a share of the bounding radius/],
    [{ weldTolerance: Infinity }, /weldTolerance is Infinity/],
    [{ weldTolerance: Number.NaN }, /weldTolerance is NaN/],
  ])('options %o', async (options, message) => {
    await expect(prepareHatchingGeometry(quad(), options as never)).rejects.toThrow(message);
  });
});
