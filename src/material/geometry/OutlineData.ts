import { type BufferGeometry, DataTexture, RGBAIntegerFormat, UnsignedIntType } from 'three';
import { POINT_BITS, POINT_MASK, SEARCHED_IN_WORKER, unpackPoints } from '../../mesh/bake/outlineLayout.js';
import type { PackedOutlines } from '../../mesh/bake/packOutlines.js';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';
import type { ContourSearch } from '../../mesh/features/contourCandidates.js';
import { identityOf } from './identityOf.js';

/** How often the search data is restored after it was lost with a worker. */
const MAX_RESTORES = 3;

/**
 * The data that the outlines of a geometry are drawn from: the textures of `outlineLayout.ts`, and the data of the search for contours.
 */
export class OutlineData {
  readonly primitives: DataTexture;
  readonly triangleCount: number;
  readonly edgeCount: number;
  /** The radius of the bounding sphere, in the rest pose. */
  readonly radius: number;
  /** The data of the search for contours; null while the worker has it. */
  search: ContourSearch | null;
  readonly pointCount: number;
  private restored = 0;

  /**
   * @param createWorker creates the worker that searches for contours. Default: the inlined worker
   * @param points the texture of the points, if it exists already
   */
  constructor(
    {
      points: words,
      primitives,
      searched,
      triangleCount,
      edgeCount,
      positions,
      normals,
      radius,
    }: Omit<PackedOutlines, 'mayCrowd'>,
    public createWorker?: (() => Worker) | undefined,
    readonly points: DataTexture = integerTexture(words),
  ) {
    this.primitives = integerTexture(primitives);
    this.triangleCount = triangleCount;
    this.edgeCount = edgeCount;
    this.radius = radius;
    this.pointCount = positions.length / 3;
    this.search = this.searchIn(positions, normals, searched ?? primitives);
  }

  /** The data for other primitives over the same points. The caller frees the texture of the primitives. */
  withPrimitives(others: Omit<PackedOutlines, 'points' | 'radius' | 'mayCrowd'>): OutlineData {
    const { createWorker, points, radius } = this;
    return new OutlineData(
      { ...others, points: points.image.data as Uint32Array<ArrayBuffer>, radius },
      createWorker,
      points,
    );
  }

  /** Whether the search for contours runs in the worker, because it takes long. */
  get isSearchedInWorker(): boolean {
    return this.triangleCount >= SEARCHED_IN_WORKER;
  }

  /**
   * Restores the search data from the textures, after it was lost with a worker that has died. It does so only a few times, since the
   * geometry that killed one worker may kill the next.
   */
  restoreSearch(): void {
    if (this.restored++ >= MAX_RESTORES) return;
    const { positions, normals } = unpackPoints(this.points.image.data as Uint32Array<ArrayBuffer>, this.pointCount);
    const primitives = this.primitives.image.data as Uint32Array<ArrayBuffer>;
    // The array is transferred to the worker; the texture keeps its own copy in case the context is lost.
    this.search = this.searchIn(positions, normals, this.isSearchedInWorker ? primitives.slice() : primitives);
  }

  private searchIn(
    positions: Float32Array<ArrayBuffer>,
    normals: Float32Array<ArrayBuffer>,
    primitives: Uint32Array<ArrayBuffer>,
  ): ContourSearch {
    const { triangleCount, edgeCount, pointCount } = this;
    return {
      positions,
      normals,
      primitives,
      pointMask: POINT_MASK,
      pointBits: POINT_BITS,
      triangleCount,
      edgeCount,
      sides: new Uint8Array(pointCount),
      list: new Uint32Array(triangleCount + edgeCount),
    };
  }

  /** The size of the textures, in bytes. */
  get bytes(): number {
    return [this.points, this.primitives].reduce((sum, { image }) => sum + image.data!.byteLength, 0);
  }

  dispose(): void {
    this.points.dispose();
    this.primitives.dispose();
  }
}

function integerTexture(words: Uint32Array<ArrayBuffer>): DataTexture {
  const { width, height } = pullTextureSize(words.length / 4);
  const texture = new DataTexture(words, width, height, RGBAIntegerFormat, UnsignedIntType);
  texture.needsUpdate = true;
  return texture;
}

/** Keyed by the identity of `userData.hatching`, an object that the clones of a geometry share. */
const outlineData = new WeakMap<object, OutlineData>();

/** The data that the outlines of a geometry are drawn from; undefined if it was prepared without outlines. */
export const outlineDataOf = ({ userData: { hatching } }: BufferGeometry): OutlineData | undefined =>
  typeof hatching === 'object' && hatching !== null ? outlineData.get(identityOf(hatching)) : undefined;

/** Attaches the data to a geometry and its clones. It is freed when the geometry is disposed of. */
export function setOutlineData(geometry: BufferGeometry, data: OutlineData): void {
  outlineData.set(identityOf(geometry.userData.hatching), data);
  geometry.addEventListener('dispose', () => data.dispose());
}
