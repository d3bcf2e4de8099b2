import { type BufferGeometry, DataTexture, RGBAIntegerFormat, UnsignedIntType } from 'three';
import { POINT_BITS, POINT_MASK } from '../bake/lineLayout.js';
import type { PackedLines } from '../bake/packLines.js';
import { pullTextureSize } from '../bake/pullLayout.js';
import { unpackPoints } from '../bake/unpackPoints.js';
import type { ContourSearch } from '../features/contourCandidates.js';
import { identityOf } from './identityOf.js';

/** Triangles from which on a search for contours takes more than about a millisecond, and is left to the worker. */
const SEARCHED_IN_WORKER = 100_000;

/** How often a search that was lost with its worker is made anew. */
const MOST_RESTORES = 3;

/** What lines of a geometry are drawn from: the textures of `lineLayout.ts`, and what contours are looked for in. */
export class LineData {
  readonly points: DataTexture;
  readonly primitives: DataTexture;
  readonly triangleCount: number;
  readonly edgeCount: number;
  /** Of the bounding sphere, at rest. */
  readonly radius: number;
  /** Makes the worker that searches for contours, if not the library's own. */
  createWorker: (() => Worker) | undefined;
  /** What contours are searched in; null while the worker has it. */
  search: ContourSearch | null;
  private readonly pointCount: number;
  private restored = 0;

  constructor({ points, primitives, triangleCount, edgeCount, positions, normals, radius }: PackedLines) {
    this.points = integerTexture(points);
    this.primitives = integerTexture(primitives);
    this.triangleCount = triangleCount;
    this.edgeCount = edgeCount;
    this.radius = radius;
    this.pointCount = positions.length / 3;
    this.search = this.searchIn(positions, normals);
  }

  /** Whether a search takes so long that it is left to the worker. */
  get isSearchedInWorker(): boolean {
    return this.triangleCount >= SEARCHED_IN_WORKER;
  }

  /**
   * Makes anew what contours are searched in, from the textures, after a worker has died and taken it along. Not without end:
   * what kills one worker may kill the next.
   */
  restoreSearch(): void {
    if (this.restored++ >= MOST_RESTORES) return;
    const { positions, normals } = unpackPoints(this.points.image.data as Uint32Array<ArrayBuffer>, this.pointCount);
    this.search = this.searchIn(positions, normals);
  }

  private searchIn(positions: Float32Array<ArrayBuffer>, normals: Float32Array<ArrayBuffer>): ContourSearch {
    const { triangleCount, edgeCount, pointCount } = this;
    const primitives = this.primitives.image.data as Uint32Array<ArrayBuffer>;
    return {
      positions,
      normals,
      // The worker takes this along, and the texture needs its own after a lost context.
      primitives: this.isSearchedInWorker ? primitives.slice() : primitives,
      pointMask: POINT_MASK,
      pointBits: POINT_BITS,
      triangleCount,
      edgeCount,
      sides: new Uint8Array(pointCount),
      list: new Uint32Array(triangleCount + edgeCount),
    };
  }

  /** Of the textures. */
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

/** By the identity of `userData.hatching`, an object that clones of a geometry share. */
const lineData = new WeakMap<object, LineData>();

/** What lines of a geometry are drawn from; undefined if it was prepared without. */
export const lineDataOf = ({ userData: { hatching } }: BufferGeometry): LineData | undefined =>
  typeof hatching === 'object' && hatching !== null ? lineData.get(identityOf(hatching)) : undefined;

/** Attaches the data to a geometry and its clones. It is freed when the geometry is disposed of. */
export function setLineData(geometry: BufferGeometry, data: LineData): void {
  lineData.set(identityOf(geometry.userData.hatching), data);
  geometry.addEventListener('dispose', () => data.dispose());
}
