import { type BufferGeometry, type Material, type Mesh, MeshPhongMaterial } from 'three';
import { TDSLoader } from 'three/addons/loaders/TDSLoader.js';

/** A chunk of a file, as three's loader represents it. */
interface Chunk {
  readonly id: number;
  readonly endOfChunk: boolean;
  readWord(): number;
  readDWord(): number;
  readString(): string;
  readChunk(): Chunk | null;
}

const MATERIAL_GROUP = 0x4130;
const SMOOTHING = 0x4150;

/**
 * three's loader for 3DS with its handling of faces corrected: it assigns materials to faces by position instead of index, drops faces
 * without a material, and ignores smoothing groups.
 */
export class TdsFaces extends TDSLoader {
  /** The smoothing groups of triangles, where the file has them: one bit per group. */
  readonly smoothing = new Map<BufferGeometry, Uint32Array>();

  /** @param part actually a {@link Chunk} */
  override readFaceArray(part: DataView, mesh: Mesh): void {
    const chunk = part as unknown as Chunk;
    const count = chunk.readWord();
    const corners: number[][] = [];
    for (let face = 0; face < count; face++) {
      corners.push([chunk.readWord(), chunk.readWord(), chunk.readWord()]);
      // The visibility of edges, which is not used.
      chunk.readWord();
    }
    const groups = new Map<string, number[]>();
    const isNamed = new Uint8Array(count);
    let smoothing: number[] | undefined;
    for (let next = nextOf(chunk); next; next = nextOf(chunk)) {
      if (next.id === SMOOTHING) smoothing = corners.map(() => next!.readDWord());
      if (next.id !== MATERIAL_GROUP) continue;
      const name = next.readString();
      const faces = groups.get(name) ?? [];
      groups.set(name, faces);
      for (let left = next.readWord(); left > 0; left--) {
        const face = next.readWord();
        if (!(face < count) || isNamed[face]) continue;
        isNamed[face] = 1;
        faces.push(face);
      }
    }
    const known = this.materials as unknown as Readonly<Record<string, Material | undefined>>;
    const others = corners.flatMap((_, face) => (isNamed[face] ? [] : [face]));
    const sorted: number[] = [];
    const materials: Material[] = [];
    for (const [name, faces] of [...groups, ['', others] as const]) {
      if (faces.length === 0) continue;
      mesh.geometry.addGroup(3 * sorted.length, 3 * faces.length, materials.length);
      materials.push(known[name] ?? new MeshPhongMaterial());
      sorted.push(...faces);
    }
    mesh.geometry.setIndex(sorted.flatMap((face) => corners[face]));
    mesh.material = materials.length === 1 ? materials[0] : materials;
    if (smoothing) {
      const given = smoothing;
      this.smoothing.set(
        mesh.geometry,
        Uint32Array.from(sorted, (face) => given[face]),
      );
    }
  }
}

const nextOf = (chunk: Chunk): Chunk | null => (chunk.endOfChunk ? null : chunk.readChunk());
