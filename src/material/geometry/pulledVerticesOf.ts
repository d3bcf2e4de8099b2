import type { BufferGeometry } from 'three';
import { identityOf } from './identityOf.js';
import type { PulledVertices } from './PulledVertices.js';

/** Keyed by the identity of `userData.hatching`, an object that the clones of a geometry share. */
const pulledVertices = new WeakMap<object, PulledVertices>();

/** The textures of a geometry in the `pull` layout; undefined if it has another layout. */
export const pulledVerticesOf = ({ userData: { hatching } }: BufferGeometry): PulledVertices | undefined =>
  typeof hatching === 'object' && hatching !== null ? pulledVertices.get(identityOf(hatching)) : undefined;

/** Attaches the textures to a geometry and its clones. They are freed when the geometry is disposed of. */
export function setPulledVertices(geometry: BufferGeometry, vertices: PulledVertices): void {
  pulledVertices.set(identityOf(geometry.userData.hatching), vertices);
  geometry.addEventListener('dispose', () => vertices.dispose());
}
