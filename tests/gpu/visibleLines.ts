/** The visible lines of a scene, found by rays; outlines are compared with them. */
import * as THREE from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

/** An edge is a crease where its two faces enclose less than 180° by this angle. */
const CREASE = (50 / 180) * Math.PI;
/** Samples of lines lie so many pixels apart. */
const STEP = 0.5;

interface Edge {
  start: THREE.Vector3;
  end: THREE.Vector3;
  normals: THREE.Vector3[];
}

function edgesOf(source: THREE.BufferGeometry): Edge[] {
  const plain = new THREE.BufferGeometry().setAttribute('position', source.attributes.position).setIndex(source.index);
  const geometry = mergeVertices(plain, 1e-5);
  const index = geometry.index!;
  const at = (i: number) => new THREE.Vector3().fromBufferAttribute(geometry.attributes.position, i);
  const edges = new Map<string, Edge>();
  for (let i = 0; i < index.count; i += 3) {
    const corners = [0, 1, 2].map((k) => index.getX(i + k));
    const [a, b, c] = corners.map(at);
    const normal = b.clone().sub(a).cross(c.clone().sub(a));
    if (normal.length() < 1e-12) continue;
    normal.normalize();
    for (let k = 0; k < 3; k++) {
      const pair = [corners[k], corners[(k + 1) % 3]].toSorted((x, y) => x - y);
      const edge = edges.get(pair.join()) ?? { start: at(pair[0]), end: at(pair[1]), normals: [] };
      edge.normals.push(normal);
      edges.set(pair.join(), edge);
    }
  }
  return [...edges.values()];
}

/** Whether an edge of a polygon mesh is a line, as seen along a direction: a border, a crease with a side that is seen, or a contour. */
function isLine({ start, normals }: Edge, eye: THREE.Vector3): boolean {
  if (normals.length !== 2) return true;
  const sight = eye.clone().sub(start);
  const [faces, others] = normals.map((normal) => normal.dot(sight) > 0);
  return faces !== others || (faces && normals[0].angleTo(normals[1]) > CREASE);
}

/** x and y in pixels from the top left, of places half a pixel apart on all lines of meshes and instances that no surface hides. */
export function visibleLines(
  meshes: readonly (THREE.Mesh | THREE.InstancedMesh)[],
  camera: THREE.PerspectiveCamera,
  size: number,
): { x: number; y: number }[] {
  const eye = camera.position;
  const raycaster = new THREE.Raycaster();
  const seen: { x: number; y: number }[] = [];
  const pixel = (place: THREE.Vector3) => {
    const { x, y } = place.clone().project(camera);
    return { x: (0.5 + 0.5 * x) * size, y: (0.5 - 0.5 * y) * size };
  };
  for (const mesh of meshes) {
    mesh.updateMatrixWorld();
    const edges = edgesOf(mesh.geometry);
    const count = mesh instanceof THREE.InstancedMesh ? mesh.count : 1;
    for (let instance = 0; instance < count; instance++) {
      const matrix = new THREE.Matrix4();
      if (mesh instanceof THREE.InstancedMesh) mesh.getMatrixAt(instance, matrix);
      matrix.premultiply(mesh.matrixWorld);
      const own = eye.clone().applyMatrix4(matrix.clone().invert());
      for (const edge of edges) {
        if (!isLine(edge, own)) continue;
        const start = edge.start.clone().applyMatrix4(matrix);
        const end = edge.end.clone().applyMatrix4(matrix);
        const [a, b] = [pixel(start), pixel(end)];
        const steps = Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / STEP);
        for (let i = 0; i < steps; i++) {
          const place = start.clone().lerp(end, (i + 0.5) / steps);
          const away = place.distanceTo(eye);
          raycaster.set(eye, place.clone().sub(eye).normalize());
          raycaster.far = away - 1e-4;
          if (raycaster.intersectObjects([...meshes], false).length === 0) seen.push(pixel(place));
        }
      }
    }
  }
  return seen;
}

/** Errors of an outline drawn `width` pixels wide: pixels of length that are missing, and those that no line explains. */
export function wrongLength(
  ink: Float32Array,
  seen: readonly { x: number; y: number }[],
  size: number,
  width: number,
): { length: number; missing: number; stray: number } {
  const explained = new Uint8Array(size * size);
  let missing = 0;
  for (const { x, y } of seen) {
    let most = 0;
    for (let j = Math.floor(y - 3); j <= y + 3; j++) {
      for (let i = Math.floor(x - 3); i <= x + 3; i++) {
        if (i < 0 || j < 0 || i >= size || j >= size) continue;
        explained[j * size + i] = 1;
        if (Math.abs(i + 0.5 - x) <= 2 && Math.abs(j + 0.5 - y) <= 2) most = Math.max(most, ink[j * size + i]);
      }
    }
    if (most < 0.3) missing++;
  }
  const stray = ink.reduce((sum, one, i) => (explained[i] ? sum : sum + one), 0) / width;
  return { length: STEP * seen.length, missing: STEP * missing, stray };
}
