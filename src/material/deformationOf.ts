import type { BufferGeometry, Mesh, WebGLRenderer } from 'three';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import { Deformation } from './Deformation.js';

/** Per `renderer.properties`: three.js makes a new one when a lost context is restored, and the deformations must go too. */
const deformations = new WeakMap<object, WeakMap<Mesh, Deformation>>();
/** Frees a deformation when its mesh is garbage-collected: meshes have no `dispose()`. */
const disposeWithMesh = /* @__PURE__ */ new FinalizationRegistry<Deformation>((deformation) => deformation.dispose());

/** The deformation of a mesh on the renderer's graphics context, made on first use. Meshes that share a geometry have one each. */
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
    disposeWithMesh.unregister(known);
  }
  const deformation = new Deformation(geometry, vertices);
  ofContext.set(mesh, deformation);
  disposeWithMesh.register(mesh, deformation, deformation);
  return deformation;
}
