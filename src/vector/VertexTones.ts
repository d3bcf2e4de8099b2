import type { SurfacePlace } from './LineSurface.js';
import type { Toner, Tones } from './Toner.js';

/** Caches the tones of vertices, which all families of a surface share. */
export class VertexTones {
  private tones = new Float64Array(0);
  private unshadowed = new Float64Array(0);

  /** @param count of vertices */
  constructor(
    private readonly toner: Toner,
    private readonly count: number,
  ) {}

  /** The tone of a vertex of a body. place: of the vertex, for the case that it was not read yet. */
  at(vertex: number, place: SurfacePlace): Tones {
    if (this.tones.length === 0) {
      this.tones = new Float64Array(this.count).fill(Number.NaN);
      this.unshadowed = new Float64Array(this.count);
    }
    if (Number.isNaN(this.tones[vertex])) {
      const { tone, unshadowed } = this.toner.read(place, this.toner.hasShadows ? 'traced' : 'none');
      this.tones[vertex] = tone;
      this.unshadowed[vertex] = unshadowed;
    }
    return { tone: this.tones[vertex], unshadowed: this.unshadowed[vertex], shadows: 0, left: 1, full: 0, turned: 0 };
  }
}
