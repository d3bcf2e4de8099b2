import { addTrack, type GltfBuilder, tetrahedron } from './GltfBuilder.js';

/** A model of many parts, each a mesh and a node of its own with one of several materials, which swing. @param parts how many */
export function partsGlb(parts = 400): Buffer {
  const builder: GltfBuilder = tetrahedron();
  const { json } = builder;
  const [{ primitives }] = json.meshes;
  const side = Math.ceil(Math.cbrt(parts));
  json.materials = Array.from({ length: 12 }, (_, i) => ({
    name: `paint ${i}`,
    pbrMetallicRoughness: { baseColorFactor: [i / 12, 1 - i / 12, 0.5, 1] },
  }));
  json.meshes = Array.from({ length: parts }, (_, i) => ({ primitives: [{ ...primitives[0], material: i % 12 }] }));
  json.nodes = [
    { children: Array.from({ length: parts }, (_, i) => i + 1) },
    ...Array.from({ length: parts }, (_, i) => ({
      mesh: i,
      translation: [3 * (i % side), 3 * (Math.floor(i / side) % side), 3 * Math.floor(i / side ** 2)],
    })),
  ];
  const times = builder.accessor(Float32Array.of(0, 1, 2), 'SCALAR');
  const turns = Float32Array.of(0, 0, 0, 1, 0, 0.38, 0, 0.92, 0, 0, 0, 1);
  addTrack(builder, 'rotation', times, builder.accessor(turns, 'VEC4'));
  return Buffer.from(builder.glb());
}
