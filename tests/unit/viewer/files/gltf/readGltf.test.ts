import { PNG } from 'pngjs';
import {
  AnimationMixer,
  type Group,
  type InstancedMesh,
  type Mesh,
  type MeshStandardMaterial,
  type SkinnedMesh,
} from 'three';
import { describe, expect, test } from 'vitest';
import { parseGltf } from '../../../../../src/viewer/files/gltf/parseGltf.js';
import { type ReadModel, type ReadParts, readModel } from '../../../../../src/viewer/files/readModel.js';
import { addTrack, type GltfBuilder, type Json, tetrahedron } from '../../../../../tools/modelFiles/GltfBuilder.js';

const read = (builder: GltfBuilder, others: { name: string; content: Blob }[] = []): Promise<ReadModel> =>
  readModel([{ name: 'a.glb', content: new Blob([builder.glb() as Uint8Array<ArrayBuffer>]) }, ...others], () => {});

const readParts = async (builder: GltfBuilder): Promise<ReadParts> => {
  const model = await read(builder);
  if (model.kind !== 'parts') throw new Error('It was read as one mesh.');
  return model;
};

/** The scene as three's loader makes it. */
const scene = async (builder: GltfBuilder) => {
  const model = await readParts(builder);
  return { ...(await parseGltf(model.parts)), notes: model.notes };
};

const changed = (change: (json: Json) => void): GltfBuilder => {
  const builder = tetrahedron();
  change(builder.json);
  return builder;
};

const picture = (width: number, height = width): Uint8Array => {
  const header = new Uint8Array(40);
  header.set(PNG.sync.write(new PNG({ width: 1, height: 1 })).subarray(0, 33));
  new DataView(header.buffer).setUint32(16, width);
  new DataView(header.buffer).setUint32(20, height);
  return header;
};

const addPicture = (builder: GltfBuilder, use: string, image: object): void => {
  const { json } = builder;
  json.images = [...(json.images ?? []), image];
  json.textures = [...(json.textures ?? []), { source: json.images.length - 1 }];
  const place = { index: json.textures.length - 1 };
  const material = use === 'baseColorTexture' ? { pbrMetallicRoughness: { [use]: place } } : { [use]: place };
  json.materials = [...(json.materials ?? []), material];
  json.meshes[0].primitives[0].material = json.materials.length - 1;
};

describe('values of the wrong type are refused with the place where they are', () => {
  test.each([
    ['a negative count', (json: Json) => (json.accessors[0].count = -4), /accessors\[0\]\.count is -4, not a whole/],
    ['a count in words', (json: Json) => (json.accessors[0].count = '4'), /accessors\[0\]\.count is "4"/],
    ['a fraction', (json: Json) => (json.accessors[0].count = 1.5), /count is 1\.5/],
    ['a list', (json: Json) => (json.accessors[0].bufferView = [0]), /bufferView is \[0\], not one of its 2/],
    ['beyond the end', (json: Json) => (json.nodes[0].mesh = 7), /nodes\[0\]\.mesh is 7, not one of its 1 meshes/],
    [
      'an inherited name',
      (json: Json) => (json.accessors[0].type = 'constructor'),
      /type is "constructor", not one of/,
    ],
    ['no list', (json: Json) => (json.materials = { length: 1e9 }), /materials is \{"length":1000000000\}, not a list/],
    ['missing', (json: Json) => (json.accessors[0].componentType = undefined), /componentType is missing/],
    ['before the buffer', (json: Json) => (json.bufferViews[0].byteOffset = -8), /byteOffset is -8/],
    [
      'an endless matrix',
      (json: Json) => (json.nodes[0].scale = [1, 1]),
      /nodes\[0\]\.scale is \[1,1\], not 3 numbers/,
    ],
  ])('%s', async (_, change, sentence) => {
    const failure = read(changed(change));
    await expect(failure).rejects.toThrow(sentence);
    await expect(failure).rejects.toThrow(/^a\.glb is damaged: .*\.$/);
  });
});

describe('memory', () => {
  test('values without data are limited, also with required Draco compression', async () => {
    for (const extensionsRequired of [[], ['KHR_draco_mesh_compression']]) {
      const builder = changed((json) => {
        json.accessors.push({ componentType: 5126, count: 1e9, type: 'VEC3' });
        json.meshes[0].primitives[0].attributes.NORMAL = 2;
        json.extensionsRequired = extensionsRequired;
      });
      await expect(read(builder)).rejects.toThrow('asks for more memory than its content explains');
    }
  });

  test('overlapping buffer views do not multiply the size of the file', { tags: ['all'] }, async () => {
    const builder = tetrahedron();
    const bytes = new Uint8Array(4_000_000);
    const view = builder.view(bytes);
    builder.json.accessors.push(
      ...Array.from({ length: 200 }, () => ({
        bufferView: view,
        componentType: 5121,
        count: 4_000_000,
        type: 'SCALAR',
      })),
    );
    builder.json.meshes[0].primitives = Array.from({ length: 200 }, (_, i) => ({
      attributes: { POSITION: 0 },
      indices: i + 2,
    }));
    await expect(read(builder)).rejects.toThrow('asks for more memory than its content explains');
  });

  test('data that is not there', async () => {
    for (const change of [
      (json: Json) => (json.accessors[0].count = 5),
      (json: Json) => (json.accessors[0].byteOffset = 4),
      (json: Json) => (json.bufferViews[0].byteStride = 200),
      (json: Json) => (json.bufferViews[0].byteLength = 1e6),
    ]) {
      await expect(read(changed(change))).rejects.toThrow(
        'a.glb is cut short: its buffer ends before the data it lists.',
      );
    }
  });
});

describe('values in every form are unpacked', () => {
  const positionsOf = async (builder: GltfBuilder): Promise<number[]> => {
    addTrack(
      builder,
      'translation',
      builder.accessor(Float32Array.of(0), 'SCALAR'),
      builder.accessor(new Float32Array(3), 'VEC3'),
    );
    const { root } = await scene(builder);
    return [...(root.children[0] as Mesh).geometry.getAttribute('position').array];
  };
  const plain = [1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1];

  test('interleaved, at an odd offset', async () => {
    const builder = tetrahedron();
    const bytes = new Uint8Array(1 + 4 * 14);
    const view = new DataView(bytes.buffer);
    for (const [i, value] of plain.entries()) view.setFloat32(1 + 14 * Math.floor(i / 3) + 4 * (i % 3), value, true);
    const bufferView = builder.view(bytes);
    Object.assign(builder.json.bufferViews[bufferView], { byteStride: 14 });
    Object.assign(builder.json.accessors[0], { bufferView, byteOffset: 1 });
    expect(await positionsOf(builder)).toEqual(plain);
  });

  test('sparse, over zeros', async () => {
    const builder = tetrahedron();
    const indices = { bufferView: builder.view(Uint8Array.of(1, 3)), componentType: 5121 };
    const values = { bufferView: builder.view(new Uint8Array(Float32Array.of(1, 2, 3, 4, 5, 6).buffer)) };
    builder.json.accessors[0].bufferView = undefined;
    builder.json.accessors[0].sparse = { count: 2, indices, values };
    expect(await positionsOf(builder)).toEqual([0, 0, 0, 1, 2, 3, 0, 0, 0, 4, 5, 6]);
  });

  test('normalized bytes', async () => {
    const builder = tetrahedron();
    const bufferView = builder.view(Uint8Array.from(new Int8Array(plain.map((value) => 127 * value))));
    Object.assign(builder.json.accessors[0], { bufferView, componentType: 5120, normalized: true });
    expect(await positionsOf(builder)).toEqual(plain);
  });

  test('strips and fans', async () => {
    for (const [mode, corners] of [
      [5, [0, 1, 2, 1, 3, 2]],
      [6, [1, 2, 0, 2, 3, 0]],
    ] as const) {
      const builder = tetrahedron();
      builder.json.meshes[0].primitives[0].indices = builder.accessor(Uint16Array.of(0, 1, 2, 3), 'SCALAR');
      builder.json.meshes[0].primitives[0].mode = mode;
      const model = await read(builder);
      expect(model.kind === 'mesh' && [...model.mesh.indices!]).toEqual(corners);
    }
  });

  test('triangles with a corner that is missing or not a number are left out and counted', async () => {
    const builder = tetrahedron();
    builder.json.meshes[0].primitives[0].indices = builder.accessor(
      Uint16Array.of(0, 2, 1, 0, 1, 9, 3, 4, 1),
      'SCALAR',
    );
    builder.json.meshes[0].primitives[0].attributes.POSITION = builder.accessor(
      Float32Array.of(...plain, Number.NaN, 0, 0),
      'VEC3',
    );
    const model = await read(builder);
    expect([model.notes, model.details]).toEqual([[], ['2 triangles without three valid corners left out']]);
    expect(model.kind === 'mesh' && [...model.mesh.indices!]).toEqual([0, 2, 1]);
  });
});

describe('tracks are checked before they are played', () => {
  const turn = Float32Array.of(0, 0, 0, 1, 0, 1, 0, 0);
  const tracks: [
    name: string,
    path: string,
    times: number[],
    values: Float32Array,
    type: string,
    interpolation?: string,
  ][] = [
    ['a rotation of three values', 'rotation', [0, 1], turn.slice(0, 6), 'VEC3'],
    ['a rotation with values missing', 'rotation', [0, 1, 2], turn, 'VEC4'],
    ['a translation of single values', 'translation', [0, 1], Float32Array.of(0, 1), 'SCALAR'],
    ['times that fall', 'rotation', [1, 0], turn, 'VEC4'],
    ['times that are not numbers', 'rotation', [0, Number.NaN], turn, 'VEC4'],
    ['values that are not numbers', 'rotation', [0, 1], turn.map(() => Number.NaN), 'VEC4'],
    ['a spline without tangents', 'rotation', [0, 1], turn, 'VEC4', 'CUBICSPLINE'],
    ['no keys', 'scale', [], new Float32Array(0), 'VEC3'],
    ['weights of a mesh without shapes', 'weights', [0, 1], Float32Array.of(0, 1), 'SCALAR'],
    ['an unknown property', 'colour', [0, 1], turn, 'VEC4'],
    ['an unknown interpolation', 'rotation', [0, 1], turn, 'VEC4', 'BOUNCE'],
  ];

  test.each(tracks)('%s', async (_, path, times, values, type, interpolation) => {
    const builder = tetrahedron();
    const input = builder.accessor(Float32Array.from(times), 'SCALAR');
    addTrack(builder, path, input, builder.accessor(values, type), interpolation);
    const model = await read(builder);
    expect(model).toMatchObject({ kind: 'mesh' });
    expect(model.notes.join()).toMatch(/^1 damaged animation track left out$/);
  });

  test('a missing output is left out, and the other tracks play', async () => {
    const builder = tetrahedron();
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'rotation', times, 99);
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 2, 0, 0), 'VEC3'));
    const { root, animations, notes } = await scene(builder);
    const mixer = new AnimationMixer(root);
    mixer.clipAction(animations[0]).play();
    mixer.update(0.5);
    expect(root.children[0].position.x).toBeCloseTo(1);
    expect(notes).toEqual(['1 damaged animation track left out']);
  });

  test('good tracks of every kind are kept', async () => {
    const builder = tetrahedron();
    const { json } = builder;
    const shape = builder.accessor(
      Float32Array.from({ length: 12 }, () => 1),
      'VEC3',
    );
    json.meshes[0].primitives[0].targets = [{ POSITION: shape }, { POSITION: shape }];
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'rotation', times, builder.accessor(turn, 'VEC4'));
    addTrack(builder, 'scale', times, builder.accessor(new Float32Array(18), 'VEC3'), 'CUBICSPLINE');
    addTrack(builder, 'weights', times, builder.accessor(Float32Array.of(0, 0, 1, 0), 'SCALAR'), 'STEP');
    addTrack(
      builder,
      'translation',
      times,
      builder.accessor(Uint8Array.of(0, 0, 0, 255, 0, 0), 'VEC3', { normalized: true }),
    );
    const { root, animations, notes } = await scene(builder);
    expect(notes).toEqual([]);
    expect(animations[0].tracks).toHaveLength(4);
    const mixer = new AnimationMixer(root);
    mixer.clipAction(animations[0]).play();
    mixer.update(0.5);
    expect(root.children[0].position.x).toBeCloseTo(0.5);
  });
});

describe('skeletons', () => {
  const skinned = (joints: number[], matrices: number): GltfBuilder => {
    const builder = tetrahedron();
    const { json } = builder;
    json.nodes[0].skin = 0;
    json.nodes.push({});
    json.scenes[0].nodes.push(1);
    const identities = Float32Array.from({ length: 16 * matrices }, (_, i) => ((i % 16) % 5 === 0 ? 1 : 0));
    json.skins = [{ joints: [1], inverseBindMatrices: builder.accessor(identities, 'MAT4') }];
    Object.assign(json.meshes[0].primitives[0].attributes, {
      JOINTS_0: builder.accessor(
        Uint8Array.from({ length: 16 }, (_, i) => joints[i % 4]),
        'VEC4',
      ),
      WEIGHTS_0: builder.accessor(
        Float32Array.from({ length: 16 }, () => 0.25),
        'VEC4',
      ),
    });
    return builder;
  };

  test('weights of joints that the skeleton lacks have no effect', async () => {
    const { root } = await scene(skinned([0, 0, 0, 200], 1));
    const mesh = root.getObjectByProperty('isSkinnedMesh', true) as SkinnedMesh;
    expect([...mesh.geometry.getAttribute('skinIndex').array]).toEqual(new Array(16).fill(0));
    root.updateMatrixWorld(true);
    mesh.skeleton.update();
    expect(mesh.getVertexPosition(0, mesh.position.clone()).x).toBeCloseTo(1);
  });

  test('a skeleton without all its matrices is left out', async () => {
    const model = await read(skinned([0, 0, 0, 0], 0));
    expect(model).toMatchObject({ kind: 'mesh', notes: ['1 damaged skeleton left out'] });
  });

  test('a mesh that is drawn with and without a skeleton', async () => {
    const builder = skinned([0, 0, 0, 0], 1);
    builder.json.nodes.push({ mesh: 0 });
    builder.json.scenes[0].nodes.push(2);
    const { root } = await scene(builder);
    expect(root.children.map((child) => child.type)).toEqual(['SkinnedMesh', 'Bone', 'Mesh']);
  });
});

describe('shapes', () => {
  test('of three thousand, as many are kept as WebGL can store', async () => {
    const builder = tetrahedron();
    const shape = builder.accessor(new Float32Array(12), 'VEC3');
    builder.json.meshes[0].primitives[0].targets = Array.from({ length: 3000 }, () => ({ POSITION: shape }));
    builder.json.meshes[0].weights = new Array(3000).fill(0.5);
    const { root, notes } = await scene(builder);
    expect((root.children[0] as Mesh).morphTargetInfluences).toEqual(new Array(256).fill(0.5));
    expect(notes).toEqual(['2,744 shapes left out: too many']);
  });

  test('morph targets without positions or of another size have no effect', async () => {
    const builder = tetrahedron();
    const shape = builder.accessor(
      Float32Array.from({ length: 12 }, () => 1),
      'VEC3',
    );
    const short = builder.accessor(new Float32Array(9), 'VEC3');
    builder.json.meshes[0].primitives[0].targets = [{ POSITION: shape }, {}, { POSITION: short }];
    const { root } = await scene(builder);
    const { morphAttributes } = (root.children[0] as Mesh).geometry;
    expect(morphAttributes.position!.map(({ array }) => array[0])).toEqual([1, 0, 0]);
  });
});

describe('scenes', () => {
  test('the default one of several, and the caption says so', async () => {
    const model = await read(
      changed((json) => {
        json.nodes = [{ mesh: 0 }, { mesh: 0, children: [2] }, { mesh: 0, translation: [3, 0, 0] }];
        json.scenes = [{ nodes: [0] }, { name: 'Pair', nodes: [1] }];
        json.scene = 1;
      }),
    );
    expect(model.kind === 'mesh' && model.mesh.indices!.length).toBe(2 * 12);
    expect(model.notes).toEqual(['scene 2 of 2, “Pair”']);
  });

  test('none: all nodes; and no nodes: all meshes', async () => {
    const withoutScene = await read(changed((json) => Object.assign(json, { scenes: undefined, scene: undefined })));
    expect(withoutScene).toMatchObject({ kind: 'mesh', details: ['it has no scene: all its nodes are shown'] });
    const withoutNodes = await read(
      changed((json) => Object.assign(json, { scenes: undefined, scene: undefined, nodes: undefined })),
    );
    expect(withoutNodes).toMatchObject({ kind: 'mesh', details: ['it has no scene: all its meshes are shown'] });
  });

  test('no meshes: a sentence', async () => {
    await expect(read(changed((json) => Object.assign(json, { meshes: [], nodes: [{}] })))).rejects.toThrow(
      /^a\.glb holds no mesh, so there is nothing to draw\.$/,
    );
  });

  test('nodes that lie below themselves, also below another', async () => {
    const nodes = [{ children: [1] }, { children: [2], mesh: 0 }, { children: [1] }];
    const model = await read(changed((json) => Object.assign(json, { nodes })));
    expect(model.kind === 'mesh' && model.mesh.indices!.length).toBe(12);
    const loop = [{ children: [1] }, { children: [0] }];
    await expect(read(changed((json) => Object.assign(json, { nodes: loop })))).rejects.toThrow('contain themselves');
  });

  test.each([
    ['that is also a child of one outside of it', [{ children: [1] }, { mesh: 0 }]],
    ['whose child is also one of a node outside', [{ children: [2] }, { children: [2] }, { mesh: 0 }]],
  ])('a node of the scene %s', async (_, nodes) => {
    const model = await read(changed((json) => Object.assign(json, { nodes, scenes: [{ nodes: [1] }] })));
    expect(model.kind === 'mesh' && model.mesh.indices!.length).toBe(12);
  });

  test('a node that the scene lists beside its parent is drawn once, in its place', async () => {
    const nodes = [{ children: [1], scale: [2, 2, 2] }, { mesh: 0, translation: [9, 0, 0] }, { mesh: 0 }];
    const model = await read(changed((json) => Object.assign(json, { nodes, scenes: [{ nodes: [1, 0, 2] }] })));
    if (model.kind !== 'mesh') throw new Error('no mesh');
    expect(model.mesh.indices!.length).toBe(2 * 12);
    const xs = [...model.mesh.positions].filter((_, i) => i % 3 === 0);
    const [low, high] = [Math.min(...xs), Math.max(...xs)];
    // From -1 to 1, and twice as large from 16 to 20.
    const places = new Set(xs.map((x) => Math.round(((x - low) / (high - low)) * 21 - 1)));
    expect(places).toEqual(new Set([-1, 1, 16, 20]));
  });

  test('hidden nodes', async () => {
    const hidden = { extensions: { KHR_node_visibility: { visible: false } }, children: [2] };
    const nodes = [{ mesh: 0 }, hidden, { mesh: 0, translation: [3, 0, 0] }];
    const model = await read(changed((json) => Object.assign(json, { nodes, scenes: [{ nodes: [0, 1] }] })));
    expect(model.kind === 'mesh' && model.mesh.indices!.length).toBe(12);
  });
});

describe('instances', () => {
  const instanced = (places: number[]): GltfBuilder => {
    const builder = tetrahedron();
    const TRANSLATION = builder.accessor(Float32Array.from(places), 'VEC3');
    builder.json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION } } };
    return builder;
  };

  test('are merged, without those that are not numbers', async () => {
    const model = await read(instanced([0, 0, 0, Number.NaN, 0, 0, 5, 0, 0]));
    expect(model.kind === 'mesh' && model.mesh.indices!.length).toBe(2 * 12);
    expect(model.notes).toEqual(['1 damaged instance left out']);
  });

  test('are drawn as instances in a scene', async () => {
    const builder = instanced([0, 0, 0, 5, 0, 0]);
    builder.json.materials = [{ emissiveFactor: [1, 0, 0] }];
    builder.json.meshes[0].primitives[0].material = 0;
    const { root } = await scene(builder);
    expect((root.children[0] as InstancedMesh).count).toBe(2);
  });

  test('have the shapes of their mesh, which clips move', async () => {
    const builder = instanced([0, 0, 0, 5, 0, 0]);
    const { json } = builder;
    const POSITION = builder.accessor(new Float32Array(12).fill(1), 'VEC3');
    const parts = [0, 1].map(() => ({ ...json.meshes[0].primitives[0], targets: [{ POSITION }, { POSITION }] }));
    json.meshes = [
      { primitives: parts.slice(1), weights: [0.5, 0.25], extras: { targetNames: ['smile', 'blink'] } },
      { primitives: parts },
    ];
    json.nodes.push({ ...json.nodes[0], mesh: 1, weights: [0, 0.75] });
    json.scenes[0].nodes.push(1);
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'weights', times, builder.accessor(Float32Array.of(0, 0, 1, 0), 'SCALAR'));

    const { root, animations } = await scene(builder);
    const [single, group] = root.children as [InstancedMesh, Group];
    expect(single.morphTargetInfluences).toEqual([0.5, 0.25]);
    expect(single.morphTargetDictionary).toEqual({ smile: 0, blink: 1 });
    expect(group.children).toHaveLength(2);
    for (const part of group.children as InstancedMesh[]) {
      expect(part.isInstancedMesh).toBe(true);
      expect(part.morphTargetInfluences).toEqual([0, 0.75]);
      expect(part.morphTargetDictionary).toEqual({ 0: 0, 1: 1 });
    }
    const mixer = new AnimationMixer(root);
    mixer.clipAction(animations[0]).play();
    mixer.setTime(0.75);
    expect(single.morphTargetInfluences).toEqual([0.75, 0]);
  });

  test('instances that spread a tiny part have a size', async () => {
    const model = await read(instanced([0, 0, 0, 1e9, 0, 0, 0, 1e9, 0]));
    if (model.kind !== 'mesh') throw new Error('not merged');
    expect(Math.max(...model.mesh.positions)).toBeCloseTo(Math.SQRT1_2, 5);
    expect(model.mesh.indices!.length).toBe(3 * 12);
    expect(model.notes).toEqual(['its triangles are too thin to be hatched']);
  });

  test('too many triangles are refused with a sentence, before they are created', async () => {
    const builder = instanced([]);
    const { json } = builder;
    json.accessors[2] = { componentType: 5126, count: 6_000_000, type: 'VEC3' };
    await expect(read(builder)).rejects.toThrow(/more than [\d,]+ triangles/);
  });
});

describe('pictures', () => {
  test('of normals, light and occlusion reach the material', async () => {
    const builder = tetrahedron();
    const { json } = builder;
    json.images = [{ bufferView: builder.view(picture(4)) }];
    json.textures = [{ source: 0, sampler: 0 }];
    json.samplers = [{ wrapS: 33071, wrapT: 33648, minFilter: 9984, magFilter: 9728 }];
    json.materials = [
      {
        pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicRoughnessTexture: { index: 0 } },
        normalTexture: { index: 0, scale: 0.5 },
        emissiveTexture: { index: 0 },
        emissiveFactor: [0.5, 0, 0],
        occlusionTexture: { index: 0, strength: 0.25 },
        extensions: { KHR_materials_emissive_strength: { emissiveStrength: 3 } },
      },
    ];
    json.meshes[0].primitives[0].material = 0;
    const { root } = await scene(builder);
    const material = (root.children[0] as Mesh).material as MeshStandardMaterial;
    expect([material.map, material.normalMap, material.emissiveMap, material.aoMap].every(Boolean)).toBe(true);
    expect(material.roughnessMap).toBeNull();
    expect(material).toMatchObject({ emissiveIntensity: 3, aoMapIntensity: 0.25 });
    expect(material.emissive.r).toBe(0.5);
    expect(material.normalScale.x).toBe(0.5);
    expect(material.map).toMatchObject({ wrapS: 1001, wrapT: 1002, minFilter: 1004, magFilter: 1003, flipY: false });
  });

  test('of metal leave a surface plain, and factors reach the material', async () => {
    const metalOf = async (metal: object): Promise<number[]> => {
      const builder = tetrahedron();
      const { json } = builder;
      json.images = [{ bufferView: builder.view(picture(4)) }];
      json.textures = [{ source: 0 }];
      json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, ...metal } }];
      json.meshes[0].primitives[0].material = 0;
      const { root } = await scene(builder);
      const { metalness, roughness } = (root.children[0] as Mesh).material as MeshStandardMaterial;
      return [metalness, roughness];
    };
    expect(await metalOf({ metallicFactor: 0.75, roughnessFactor: 0.25 })).toEqual([0.75, 0.25]);
    expect(await metalOf({ roughnessFactor: 0.25 })).toEqual([1, 0.25]);
    expect((await metalOf({ roughnessFactor: 0.25, metallicRoughnessTexture: { index: 0 } }))[0]).toBe(0);
  });

  test('missing emissive maps leave a surface dark, so that it can be hatched', async () => {
    const builder = tetrahedron();
    builder.json.images = [{ uri: 'lamp.png' }];
    builder.json.textures = [{ source: 0 }];
    builder.json.materials = [{ emissiveTexture: { index: 0 }, emissiveFactor: [1, 1, 1] }];
    builder.json.meshes[0].primitives[0].material = 0;
    const { root, notes } = await scene(builder);
    expect(((root.children[0] as Mesh).material as MeshStandardMaterial).emissive.r).toBe(0);
    expect(notes).toEqual(['lamp.png is missing: drop it along']);
  });

  test('that were not dropped are named', async () => {
    const builder = tetrahedron();
    addPicture(builder, 'baseColorTexture', { uri: 'textures/wood.png' });
    const model = await read(builder);
    expect(model).toMatchObject({ kind: 'mesh', notes: ['wood.png is missing: drop it along'] });
    const wood = { name: 'Wood.png', content: new Blob([picture(2) as Uint8Array<ArrayBuffer>]) };
    expect(await read(builder, [wood])).toMatchObject({ kind: 'parts', notes: [] });
  });

  test('are judged by their headers, all together', async () => {
    const builder = tetrahedron();
    const uri = `data:image/png;base64,${Buffer.from(picture(8192)).toString('base64')}`;
    for (let i = 0; i < 8; i++) addPicture(builder, 'baseColorTexture', { uri });
    addPicture(builder, 'baseColorTexture', { uri: `data:,${'x'.repeat(40)}` });
    const { parts, notes } = await readParts(builder);
    const drawn = parts.pictures.flatMap((one) => (one ? [one.width] : []));
    expect(drawn).toEqual([2048, 2048, 2048, 2048]);
    expect(notes).toEqual([
      '1 picture left out: not PNG, JPEG or WebP',
      '4 pictures left out: too large',
      'pictures reduced to 2,048 pixels',
    ]);
  });

  test.each(['KHR_texture_basisu', 'EXT_texture_avif'])(
    'of a kind that is not read are counted, and the picture beside them is drawn: %s',
    async (extension) => {
      const builder = tetrahedron();
      const { json } = builder;
      const unread = { bufferView: builder.view(Uint8Array.from({ length: 64 }, (_, i) => i)) };
      json.images = [unread, { bufferView: builder.view(picture(4)) }];
      json.textures = [{ extensions: { [extension]: { source: 0 } } }];
      json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
      json.meshes[0].primitives[0].material = 0;
      expect(await read(builder)).toMatchObject({ notes: ['1 picture left out: not PNG, JPEG or WebP'] });
      Object.assign(json.textures[0], { source: 1 });
      expect(await read(builder)).toMatchObject({ kind: 'parts', notes: [] });
    },
  );

  test('of the older extension for gloss', async () => {
    const builder = tetrahedron();
    const { json } = builder;
    json.images = [{ bufferView: builder.view(picture(4)) }];
    json.textures = [{ source: 0 }];
    const gloss = { diffuseFactor: [0.5, 1, 1, 1], diffuseTexture: { index: 0 } };
    json.materials = [{ extensions: { KHR_materials_pbrSpecularGlossiness: gloss } }];
    json.meshes[0].primitives[0].material = 0;
    const { root } = await scene(builder);
    const material = (root.children[0] as Mesh).material as MeshStandardMaterial;
    expect(material.map).not.toBeNull();
    expect(material.color.r).toBe(0.5);
  });
});
