import { BufferAttribute, type BufferGeometry } from 'three';
import type { DetailLevel, DetailLevels } from '../../mesh/detail/makeLevels.js';

/**
 * The levels of detail of one geometry, in one index buffer on the GPU, one after another over the same vertices. The geometry has that
 * index only while a level is drawn. To raycasts, clones, exporters and other code it is always the whole mesh.
 */
export class LeveledGeometry {
  readonly levels: readonly DetailLevel[];
  private readonly whole: BufferAttribute;
  private readonly all: BufferAttribute;

  /** @param detail the levels of the geometry, which must be indexed */
  constructor(
    readonly geometry: BufferGeometry,
    detail: DetailLevels,
  ) {
    this.levels = detail.levels;
    this.all = new BufferAttribute(detail.indices, 1);
    // The first level is the whole mesh: its memory is shared.
    this.whole = new BufferAttribute(detail.indices.subarray(0, detail.levels[0].count), 1);
    geometry.setIndex(this.whole);
    // This listener runs before three's own, which frees the index that the geometry has at that moment.
    geometry.addEventListener('dispose', () => {
      geometry.setIndex(this.all);
      queueMicrotask(() => this.showWhole());
    });
  }

  /** Whether the geometry is unchanged since the levels were made: other code may have set another index or draw range. */
  get isWhole(): boolean {
    const { index, drawRange } = this.geometry;
    return index === this.whole && drawRange.start === 0 && drawRange.count === Infinity;
  }

  /** Makes the next draws show a level. */
  show(level: number): void {
    const { start, count } = this.levels[level];
    this.geometry.setIndex(this.all);
    this.geometry.setDrawRange(start, count);
  }

  /** Ends what `show` began. */
  showWhole(): void {
    if (this.geometry.index !== this.all) return;
    this.geometry.setIndex(this.whole);
    this.geometry.setDrawRange(0, Infinity);
  }
}
