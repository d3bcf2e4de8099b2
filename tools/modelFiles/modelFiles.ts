import { MeshoptEncoder } from 'meshoptimizer';
import { PNG } from 'pngjs';
import { Mesh, TorusGeometry } from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { packGlb } from './columnModel.js';
import { encodeDraco } from './encodeDraco.js';

/** An octahedron in every format that the page reads, made by code so that the tests need no files. */

const VERTICES = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
] as const;
const TRIANGLES = [
  [0, 2, 4],
  [2, 1, 4],
  [1, 3, 4],
  [3, 0, 4],
  [2, 0, 5],
  [1, 2, 5],
  [3, 1, 5],
  [0, 3, 5],
] as const;

export interface TestFile {
  name: string;
  mimeType: string;
  buffer: Buffer;
}

export const file = (name: string, content: Buffer | string): TestFile => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(content as string),
});

export const octahedronObj = [
  'mtllib octahedron.mtl',
  'usemtl red',
  ...VERTICES.map((vertex) => `v ${vertex.join(' ')}`),
  ...TRIANGLES.map((triangle) => `f ${triangle.map((i) => i + 1).join(' ')}`),
].join('\n');

export const octahedronMtl = 'newmtl red\nKd 0.8 0.1 0.1\nmap_Kd missing.png\n';

/** A square that faces the viewer, with a picture. */
export const squareObj = [
  'mtllib square.mtl',
  ...[0, 1, 2, 3].flatMap((i) => [`v ${i & 1} ${i >> 1} 0`, `vt ${i & 1} ${i >> 1}`]),
  'usemtl pictured',
  'f 1/1 2/2 4/4 3/3',
].join('\n');

export const squareMtl = 'newmtl pictured\nmap_Kd sky.png\n';

/** A picture whose upper half is blue and whose lower half is green. */
export function skyPng(): Buffer {
  const picture = new PNG({ width: 16, height: 16 });
  for (let i = 0; i < 256; i++) picture.data.set(i < 128 ? [20, 40, 255, 255] : [20, 200, 40, 255], 4 * i);
  return PNG.sync.write(picture);
}

export const octahedronPly = [
  'ply',
  'format ascii 1.0',
  `element vertex ${VERTICES.length}`,
  'property double x',
  'property double y',
  'property double z',
  `element face ${TRIANGLES.length}`,
  'property list uchar int vertex_indices',
  'end_header',
  ...VERTICES.map((vertex) => vertex.join(' ')),
  ...TRIANGLES.map((triangle) => `3 ${triangle.join(' ')}`),
  '',
].join('\n');

export const octahedronAsciiStl = `solid octahedron\n${TRIANGLES.map(
  (triangle) =>
    `facet normal 0 0 0\nouter loop\n${triangle.map((i) => `vertex ${VERTICES[i].join(' ')}`).join('\n')}\nendloop\nendfacet\n`,
).join('')}endsolid octahedron\n`;

export function octahedronBinaryStl(): Buffer {
  const buffer = Buffer.alloc(84 + 50 * TRIANGLES.length);
  buffer.writeUInt32LE(TRIANGLES.length, 80);
  TRIANGLES.forEach((triangle, t) => {
    triangle.forEach((i, corner) => {
      VERTICES[i].forEach((value, axis) => {
        buffer.writeFloatLE(value, 84 + 50 * t + 12 + 12 * corner + 4 * axis);
      });
    });
  });
  return buffer;
}

export function octahedronBin(): Buffer {
  const positions = Buffer.from(new Float32Array(VERTICES.flat()).buffer);
  return Buffer.concat([positions, Buffer.from(new Uint16Array(TRIANGLES.flat()).buffer)]);
}

/** Two octahedra, the second mirrored and translated. `uri` is that of the buffer; GLB has none. */
export function octahedronGltf(uri?: string, changes: object = {}): string {
  const positionBytes = 12 * VERTICES.length;
  const indexBytes = 6 * TRIANGLES.length;
  return JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0 }, { mesh: 0, translation: [3, 0, 0], scale: [-1, 1, 1] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: VERTICES.length, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: 3 * TRIANGLES.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: positionBytes },
      { buffer: 0, byteOffset: positionBytes, byteLength: indexBytes },
    ],
    buffers: [{ byteLength: positionBytes + indexBytes, ...(uri ? { uri } : {}) }],
    ...changes,
  });
}

/** The two octahedra, compressed with meshopt. */
export async function octahedronMeshoptGlb(): Promise<Buffer> {
  await MeshoptEncoder.ready;
  const bin = octahedronBin();
  const size = 12 * VERTICES.length;
  const parts = [
    { mode: 'ATTRIBUTES', count: VERTICES.length, byteStride: 12, plain: bin.subarray(0, size) },
    { mode: 'TRIANGLES', count: 3 * TRIANGLES.length, byteStride: 2, plain: bin.subarray(size) },
  ];
  let content = Buffer.alloc(0);
  const views = parts.map(({ mode, count, byteStride, plain }, i) => {
    const packed = MeshoptEncoder.encodeGltfBuffer(plain, count, byteStride, mode);
    const packing = { buffer: 0, byteOffset: content.length, byteLength: packed.length, byteStride, count, mode };
    content = Buffer.concat([content, packed, Buffer.alloc((4 - (packed.length % 4)) % 4)]);
    return {
      buffer: 1,
      byteOffset: i * size,
      byteLength: plain.length,
      ...(i === 0 && { byteStride }),
      extensions: { EXT_meshopt_compression: packing },
    };
  });
  const changes = {
    extensionsUsed: ['EXT_meshopt_compression'],
    extensionsRequired: ['EXT_meshopt_compression'],
    bufferViews: views,
    buffers: [
      { byteLength: content.length },
      { byteLength: bin.length, extensions: { EXT_meshopt_compression: { fallback: true } } },
    ],
  };
  return packGlb(octahedronGltf(undefined, changes), content);
}

/** The two octahedra in red, packed with Draco. Colours come first in the packing: positions are found by their id, not by their place. */
export async function octahedronDracoGlb(): Promise<Buffer> {
  const count = VERTICES.length;
  const red = Uint8Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 || i % 4 === 3 ? 255 : 0));
  const { bytes, ids } = await encodeDraco(
    {
      COLOR_0: { values: red, size: 4 },
      POSITION: { values: Float32Array.from(VERTICES.flat()), size: 3 },
    },
    TRIANGLES.flat(),
  );
  const packing = { bufferView: 0, attributes: ids };
  const primitive = {
    attributes: { POSITION: 0, COLOR_0: 2 },
    indices: 1,
    extensions: { KHR_draco_mesh_compression: packing },
  };
  return packGlb(
    octahedronGltf(undefined, {
      extensionsUsed: ['KHR_draco_mesh_compression'],
      extensionsRequired: ['KHR_draco_mesh_compression'],
      meshes: [{ primitives: [primitive] }],
      accessors: [
        { componentType: 5126, count, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] },
        { componentType: 5123, count: 3 * TRIANGLES.length, type: 'SCALAR' },
        { componentType: 5121, normalized: true, count, type: 'VEC4' },
      ],
      bufferViews: [{ buffer: 0, byteLength: bytes.length }],
      buffers: [{ byteLength: bytes.length }],
    }),
    Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4)]),
  );
}

export const octahedronGlb = (): Buffer => packGlb(octahedronGltf(), octahedronBin());

/** A torus of 110,000 triangles without normals. */
export function largeTorus(): TestFile {
  const torus = new TorusGeometry(1, 0.4, 200, 275);
  const options = { binary: true, excludeAttributes: ['normal', 'uv'] };
  const content = new PLYExporter().parse(new Mesh(torus), undefined as never, options as never);
  return file('torus.ply', Buffer.from(content as unknown as ArrayBuffer));
}
