import { type BufferGeometry, DataTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';
import type { PackedPull } from '../bake/packPull.js';
import { pullTextureSize } from '../bake/pullLayout.js';
import { identityOf } from './identityOf.js';

/** The textures of a geometry in the `pull` layout (see `pullLayout.ts`). */
export class PulledVertices {
  readonly triangleVertices: DataTexture;
  /** In the rest pose. */
  readonly positions: DataTexture;
  /** Texels in a row, as a power of two. */
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

/** By the identity of `userData.hatching`, an object that clones of a geometry share. */
const pulledVertices = new WeakMap<object, PulledVertices>();

export const pulledVerticesOf = ({ userData: { hatching } }: BufferGeometry): PulledVertices | undefined =>
  typeof hatching === 'object' && hatching !== null ? pulledVertices.get(identityOf(hatching)) : undefined;

/** Attaches the textures to a geometry and its clones. They are freed when the geometry is disposed of. */
export function setPulledVertices(geometry: BufferGeometry, vertices: PulledVertices): void {
  pulledVertices.set(identityOf(geometry.userData.hatching), vertices);
  geometry.addEventListener('dispose', () => vertices.dispose());
}
