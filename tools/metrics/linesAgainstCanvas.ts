/** Compares drawings that leave as lines with the canvas: how much ink each has, block by block. */
import {
  Box3,
  BufferGeometry,
  Color,
  DirectionalLight,
  Group,
  LinearSRGBColorSpace,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  OrthographicCamera,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector3,
  WebGLRenderer,
} from 'three';
import { applyHatching, type HatchingMaterial, type HatchingOutlines, type PresetName } from 'three-hatching';
import { type DrawSVGOptions, drawSVG } from 'three-hatching/svg';

/** A model with its view and light. */
export interface ComparedDrawing {
  preset?: PresetName;
  isOrthographic?: boolean;
  /** Towards the light and towards the eye, of any length. */
  light?: readonly [number, number, number];
  view?: readonly [number, number, number];
  hasShadows?: boolean;
  svg?: DrawSVGOptions;
}

/** Differences of the share of ink over blocks of 16 × 16 CSS pixels that have any, and its sum on the file's side over the canvas's. */
export interface InkDifference {
  mean: number;
  p99: number;
  ink: number;
  leftOut: string[];
}

/** CSS pixels a side, and those of the picture to one of them. */
const SIZE = 640;
const RATIO = 2;
const BLOCK = 16;
const MILLIMETRES = (SIZE * 25.4) / 96;

let renderer: WebGLRenderer | undefined;

/** A scene of one model, fitted to a radius of 1, in one light, hatched in black on white; and the camera that sees all of it. */
export async function comparedScene(source: BufferGeometry | Object3D, drawing: ComparedDrawing) {
  const { preset = 'engraving', light = [-0.55, 0.75, 0.6], view = [0.5, 0.4, 2], hasShadows = false } = drawing;
  const model = source instanceof BufferGeometry ? new Mesh(source, new MeshLambertMaterial()) : fitted(source);
  model.traverse((object) => {
    object.castShadow = object.receiveShadow = hasShadows;
  });
  const sun = new DirectionalLight('white', Math.PI);
  sun.position.set(...light).multiplyScalar(5);
  sun.castShadow = hasShadows;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.camera = new OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.5, 12);
  sun.shadow.normalBias = 0.01;
  const scene = new Scene().add(model, sun);
  scene.background = new Color('white');
  const camera = drawing.isOrthographic
    ? new OrthographicCamera(-1.08, 1.08, 1.08, -1.08, 0.1, 50)
    : new PerspectiveCamera(28, 1, 0.1, 50);
  camera.position.copy(new Vector3(...view).setLength(4.4));
  camera.lookAt(0, 0, 0);
  await applyHatching(scene, { preset });
  for (const material of materialsOf(scene)) material.setValues({ ink: 'black', paper: 'white' });
  scene.traverse((object) => {
    if ('isHatchingOutlines' in object) (object as HatchingOutlines).material.ink.set('black');
  });
  return { scene, camera };
}

/** A model in its pose, with a radius of 1 around the origin. */
function fitted(model: Object3D): Object3D {
  const { center, radius } = new Box3().setFromObject(model, true).getBoundingSphere(new Sphere());
  const group = new Group();
  group.scale.setScalar(1 / radius);
  group.position.copy(center).multiplyScalar(-1 / radius);
  return group.add(model);
}

function materialsOf(scene: Scene): HatchingMaterial[] {
  const materials: HatchingMaterial[] = [];
  scene.traverse((object) => {
    if (!('isMesh' in object) || 'isHatchingOutlines' in object) return;
    const { material } = object as Mesh;
    for (const one of Array.isArray(material) ? material : [material])
      if ('isHatchingMaterial' in one) materials.push(one as unknown as HatchingMaterial);
  });
  return materials;
}

/** Draws a model on the canvas and as lines. */
export async function compareLines(
  source: BufferGeometry | Object3D,
  drawing: ComparedDrawing = {},
): Promise<InkDifference> {
  const { scene, camera } = await comparedScene(source, drawing);
  return compareScene(scene, camera, { shadows: drawing.hasShadows ?? false, ...drawing.svg });
}

/** Draws a scene on the canvas and as lines. Its ink is black, and its paper white. */
export async function compareScene(
  scene: Scene,
  camera: PerspectiveCamera | OrthographicCamera,
  options: DrawSVGOptions = {},
): Promise<InkDifference> {
  const canvas = await inkOfCanvas(scene, camera);
  const sheet = [MILLIMETRES, MILLIMETRES] as const;
  const { svg, leftOut } = await drawSVG(scene, camera, { sheet, margin: 0, ...options });
  return { ...differenceOf(canvas, await inkOfFile(svg)), leftOut: leftOut.map(({ reason }) => reason) };
}

async function inkOfCanvas(scene: Scene, camera: PerspectiveCamera | OrthographicCamera): Promise<Float32Array> {
  if (!renderer) {
    renderer = new WebGLRenderer({ preserveDrawingBuffer: true });
    renderer.outputColorSpace = LinearSRGBColorSpace;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    renderer.setPixelRatio(RATIO);
    renderer.setSize(SIZE, SIZE, false);
  }
  // A material may be drawn with code and images that come later.
  await Promise.all(materialsOf(scene).map((material) => material.ready));
  renderer.render(scene, camera);
  return inkOf(renderer.domElement);
}

/** The ink of a file as the browser draws it. */
export async function inkOfFile(svg: string): Promise<Float32Array> {
  const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  const image = new Image();
  image.src = url;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = RATIO * SIZE;
  const context = canvas.getContext('2d')!;
  context.fillStyle = 'white';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(url);
  return inkOf(canvas);
}

/** The share of ink in each block, from black on white. */
function inkOf(canvas: HTMLCanvasElement): Float32Array {
  const copy = document.createElement('canvas');
  copy.width = copy.height = RATIO * SIZE;
  const context = copy.getContext('2d', { willReadFrequently: true })!;
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const blocks = SIZE / BLOCK;
  const side = RATIO * BLOCK;
  const ink = new Float32Array(blocks * blocks);
  for (let y = 0; y < copy.height; y++) {
    for (let x = 0; x < copy.width; x++)
      ink[Math.floor(y / side) * blocks + Math.floor(x / side)] +=
        (1 - data[4 * (y * copy.width + x)] / 255) / side ** 2;
  }
  return ink;
}

function differenceOf(canvas: Float32Array, file: Float32Array): Pick<InkDifference, 'mean' | 'p99' | 'ink'> {
  const found: number[] = [];
  let [ofCanvas, ofFile] = [0, 0];
  for (const [i, ink] of canvas.entries()) {
    ofCanvas += ink;
    ofFile += file[i];
    if (ink > 0 || file[i] > 0) found.push(Math.abs(ink - file[i]));
  }
  found.sort((a, b) => a - b);
  return {
    mean: found.reduce((sum, one) => sum + one, 0) / found.length,
    p99: found[Math.floor(0.99 * (found.length - 1))],
    ink: ofFile / ofCanvas,
  };
}
