import {
  Box3,
  DirectionalLight,
  Group,
  HemisphereLight,
  LoadingManager,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { fitCamera } from '../../src/viewer/sceneSetup/framing.js';
import { createCamera, DEFAULT_VIEW } from '../../src/viewer/sceneSetup/LensCamera.js';

/** Files by name, in base64. The first one is the model, the others are what it asks for. */
export type PlainFiles = readonly { name: string; content: string }[];

/** The share of the picture that the playground fills. */
const FILL = 0.76;

/**
 * Draws a model as three.js does by itself, seen from where the playground sees it.
 *
 * @returns the picture as the address of a PNG
 */
async function drawPlain(files: PlainFiles, side: number): Promise<string> {
  const canvas = Object.assign(document.createElement('canvas'), { width: side, height: side });
  const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.setClearColor('#d8d8d8');
  const holder = new Group().add(await load(files));
  holder.updateMatrixWorld(true);
  const sun = new DirectionalLight('white', 2.2);
  sun.position.set(-1, 1.2, 0.8);
  const scene = new Scene().add(holder, sun, new HemisphereLight('white', '#776655', 1.2));
  const camera = createCamera();
  const radius = fitted(holder);
  fitCamera(camera, outlineOf(holder), new Vector3(...DEFAULT_VIEW), { fill: FILL });
  Object.assign(camera, { near: radius / 50, far: radius * 100 });
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  const address = canvas.toDataURL();
  renderer.dispose();
  renderer.forceContextLoss();
  return address;
}

const bytesOf = (content: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(content), (character) => character.charCodeAt(0));

async function load(files: PlainFiles): Promise<Object3D> {
  const [{ name, content }, ...others] = files;
  const bytes = bytesOf(content);
  if (/\.obj$/.test(name)) return new OBJLoader().parse(new TextDecoder().decode(bytes));
  if (/\.ply\.gz$/.test(name)) {
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    const geometry = new PLYLoader().parse(await new Response(unpacked).arrayBuffer());
    geometry.computeVertexNormals();
    return new Mesh(geometry, new MeshStandardMaterial());
  }
  const manager = new LoadingManager();
  manager.setURLModifier((url) => {
    const other = others.find((one) => url.endsWith(one.name));
    return other ? URL.createObjectURL(new Blob([bytesOf(other.content)])) : url;
  });
  return (await new GLTFLoader(manager).parseAsync(bytes.buffer, '')).scene;
}

/** Moves what `holder` holds to the middle. @returns its radius */
function fitted(holder: Group): number {
  const box = new Box3().setFromObject(holder, true);
  holder.position.sub(box.getCenter(new Vector3()));
  holder.updateMatrixWorld(true);
  return box.getSize(new Vector3()).length() / 2;
}

function outlineOf(holder: Group): number[] {
  const points: number[] = [];
  holder.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { count } = object.geometry.getAttribute('position');
    const step = Math.ceil(count / 5000);
    for (let i = 0; i < count; i += step)
      points.push(...object.getVertexPosition(i, new Vector3()).applyMatrix4(object.matrixWorld));
  });
  return points;
}

declare global {
  interface Window {
    drawPlain?: typeof drawPlain;
  }
}
window.drawPlain = drawPlain;
