/** Compares which surfaces are seen in our picture of a glTF file and in that of plain three.js, by their depths. */
import {
  AmbientLight,
  AnimationMixer,
  Box3,
  DepthTexture,
  FloatType,
  LoadingManager,
  Mesh,
  type MeshPhysicalMaterial,
  NearestFilter,
  type Object3D,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Sphere,
  type Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { buildModel } from '../../src/viewer/drawing/buildModel.js';
import { BITMAPS } from '../../src/viewer/files/common/Surroundings.js';
import { withPictures } from '../../src/viewer/files/pictures/decodePictures.js';
import { readModel } from '../../src/viewer/files/readModel.js';
import type { FileText } from './measureLines.js';

const SIZE = 256;
/** Depths that differ by less, as a share of the radius, are of one surface. */
const SAME = 0.02;
const VIEWS = [
  [0.7, 0.5, 1],
  [-0.6, 0.9, -0.8],
  [0.15, -0.4, 1],
] as const;

/** The share of seen pixels that show the same surface in both pictures, the least of several views. */
export async function measureSeenSurfaces(files: readonly FileText[], hasBothSides = false): Promise<number> {
  const renderer = new WebGLRenderer();
  try {
    const plain = await plainScene(files);
    const model = await hatchedScene(files, hasBothSides);
    return Math.min(...VIEWS.map((view) => sharedView(renderer, plain, model, view)));
  } finally {
    renderer.dispose();
    renderer.forceContextLoss();
  }
}

const bytesOf = ({ base64 }: FileText): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

async function plainScene(files: readonly FileText[]): Promise<Object3D> {
  const urls = new Map(files.map((file) => [file.name, URL.createObjectURL(new Blob([bytesOf(file)]))]));
  const manager = new LoadingManager().setURLModifier(
    (url) => urls.get(decodeURIComponent(url.split('/').pop()!)) ?? url,
  );
  const { scene, animations } = await new GLTFLoader(manager).loadAsync(files[0].name);
  if (animations.length > 0) {
    const mixer = new AnimationMixer(scene);
    mixer.clipAction(animations[0]).play();
    mixer.setTime(0);
  }
  scene.traverse(prepareObject);
  return scene;
}

/** A surface of at least this opacity hides others. */
const OPAQUE = 0.95;

/** Leaves lines and surfaces that cannot be seen out of a picture; lets opaque ones hide others, and no glass. */
function prepareObject(object: Object3D): void {
  if ('isLine' in object || 'isPoints' in object) object.visible = false;
  for (const material of [(object as Partial<Mesh>).material ?? []].flat()) {
    const { opacity, alphaTest, transparent, transmission = 0 } = material as MeshPhysicalMaterial;
    if (opacity < alphaTest || (transparent && opacity === 0)) object.visible = false;
    if (transparent || transmission > 0) material.depthWrite = transmission === 0 && opacity >= OPAQUE;
  }
}

async function hatchedScene(files: readonly FileText[], hasBothSides: boolean): Promise<Object3D> {
  const dropped = files.map((file) => ({ name: file.name, content: new Blob([bytesOf(file)]) }));
  const read = await readModel(dropped, () => {}, BITMAPS, { switched: hasBothSides ? ['sides'] : [] });
  const pictured = await withPictures(read, () => {}, BITMAPS);
  const { model } = await buildModel(pictured, () => {}, new AbortController().signal);
  model.root.traverse((object) => {
    if ('isHatchingOutlines' in object) object.visible = false;
  });
  return model.root;
}

/** The share of the pixels seen in either picture that show the same surface in both, from a direction. */
function sharedView(
  renderer: WebGLRenderer,
  plain: Object3D,
  hatched: Object3D,
  view: readonly [number, number, number],
): number {
  const { center, radius } = sphereOf(plain);
  const other = sphereOf(hatched);
  const one = depthsFrom(renderer, plain, center, radius, view);
  const two = depthsFrom(renderer, hatched, other.center, other.radius, view);
  let seen = 0;
  let same = 0;
  for (let i = 0; i < one.length; i += 4) {
    if (one[i] >= 1 && two[i] >= 1) continue;
    seen++;
    if (Math.abs(one[i] - two[i]) < SAME / DEPTH) same++;
  }
  return seen === 0 ? 1 : same / seen;
}

/** The sphere around all visible meshes. */
function sphereOf(root: Object3D): Sphere {
  root.updateMatrixWorld(true);
  const box = new Box3();
  root.traverseVisible((object) => {
    const { isMesh, material, children } = object as Mesh;
    if (!isMesh || [material].flat().every(({ visible }) => !visible)) return;
    object.children = [];
    box.expandByObject(object, true);
    object.children = children;
  });
  return box.getBoundingSphere(new Sphere());
}

/** The extent of the view along the line of sight, in radii. */
const DEPTH = 4;

/** The depth of each pixel in the first of four channels, from 0 to 1; 1 where nothing is seen. */
function depthsFrom(
  renderer: WebGLRenderer,
  root: Object3D,
  center: Vector3,
  radius: number,
  view: readonly [number, number, number],
): Float32Array {
  const camera = new OrthographicCamera(-radius, radius, radius, -radius, 0, DEPTH * radius);
  camera.position
    .fromArray(view)
    .setLength((DEPTH / 2) * radius)
    .add(center);
  camera.lookAt(center);
  const target = new WebGLRenderTarget(SIZE, SIZE, { depthTexture: new DepthTexture(SIZE, SIZE, FloatType) });
  const read = new WebGLRenderTarget(SIZE, SIZE, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(new Scene().add(root, new AmbientLight()), camera);
  const quad = new Mesh(new PlaneGeometry(2, 2), copyOf(target.depthTexture!));
  quad.frustumCulled = false;
  renderer.setRenderTarget(read);
  renderer.render(new Scene().add(quad), camera);
  const depths = new Float32Array(4 * SIZE * SIZE);
  renderer.readRenderTargetPixels(read, 0, 0, SIZE, SIZE, depths);
  target.dispose();
  read.dispose();
  quad.geometry.dispose();
  quad.material.dispose();
  return depths;
}

const copyOf = (map: DepthTexture): ShaderMaterial =>
  new ShaderMaterial({
    uniforms: { map: { value: map } },
    vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader:
      'uniform sampler2D map; varying vec2 at; void main() { gl_FragColor = vec4(texture2D(map, at).x, 0.0, 0.0, 1.0); }',
  });

declare global {
  interface Window {
    measureSeenSurfaces: typeof measureSeenSurfaces;
  }
}

window.measureSeenSurfaces = measureSeenSurfaces;
