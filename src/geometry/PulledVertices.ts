import { type BufferGeometry, DataTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';
import type { PackedPull } from '../bake/packPull.js';
import { pullTextureSize } from '../bake/pullLayout.js';
import { identityOf } from './identityOf.js';

/** The textures of a geometry in the `pull` layout (see `pullLayout.ts`). */
export class PulledVertices {
  readonly triangleVertices: DataTexture;
  /** The positions of the vertices in the rest pose. */
  readonly positions: DataTexture;
  /** The base-2 logarithm of the number of texels in a row. */
  readonly rowShift: number;

  constructor({ columns, triangleVertices, vertexPositions }: PackedPull) {
    this.rowShift = Math.log2(columns);
    const triangles = pullTextureSize(triangleVertices.length / 4, columns);
    const vertices = pullTextureSize(vertexPositions.length / 4, columns);
    this.triangleVertices = new DataTexture(
      triangleVertices,
      triangles.width,
      triangles.height,
      RGBAIntegerFormat,
      UnsignedIntType,
    );
    this.positions = new DataTexture(vertexPositions, vertices.width, vertices.height, RGBAFormat, FloatType);
    this.triangleVertices.needsUpdate = true;
    this.positions.needsUpdate = true;
  }

  dispose(): void {
    this.triangleVertices.dispose();
    this.positions.dispose();
  }
}

/** The keys are the identities of `userData.hatching`, an object that the clones of a geometry share. */
const pulledVertices = new WeakMap<object, PulledVertices>();

/** The textures of a geometry in the `pull` layout; undefined if it has another layout. */
export const pulledVerticesOf = ({ userData: { hatching } }: BufferGeometry): PulledVertices | undefined =>
  typeof hatching === 'object' && hatching !== null ? pulledVertices.get(identityOf(hatching)) : undefined;

/** Attaches the textures to a geometry and its clones. They are freed when the geometry is disposed of. */
export function setPulledVertices(geometry: BufferGeometry, vertices: PulledVertices): void {
  pulledVertices.set(identityOf(geometry.userData.hatching), vertices);
  geometry.addEventListener('dispose', () => vertices.dispose());
}
