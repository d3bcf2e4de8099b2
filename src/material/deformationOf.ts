import type { BufferGeometry, Mesh, WebGLRenderer } from 'three';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import { Deformation } from './Deformation.js';

/** By what three.js knows about one graphics context: it starts anew when a lost one is restored, and so must we. */
const deformations = new WeakMap<object, WeakMap<Mesh, Deformation>>();
/** Meshes are not disposed of, they are let go. */
const abandoned = new FinalizationRegistry<Deformation>((deformation) => deformation.dispose());

/** The deformation of a mesh on the renderer's graphics context. Meshes that share a geometry have one each. */
export function deformationOf(
  renderer: WebGLRenderer,
  mesh: Mesh,
  geometry: BufferGeometry,
  vertices: PulledVertices,
): Deformation {
  let ofContext = deformations.get(renderer.properties);
  if (!ofContext) {
    ofContext = new WeakMap();
    deformations.set(renderer.properties, ofContext);
  }
  const known = ofContext.get(mesh);
  if (known && !known.isDisposed && known.geometry === geometry) return known;
  if (known) {
    known.dispose();
    abandoned.unregister(known);
  }
  const deformation = new Deformation(geometry, vertices);
  ofContext.set(mesh, deformation);
  abandoned.register(mesh, deformation, deformation);
  return deformation;
}
