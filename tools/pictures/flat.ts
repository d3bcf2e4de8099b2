import {
  Box3,
  Color,
  DirectionalLight,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector3,
  WebGLRenderer,
} from 'three';
import { applyHatching, type PresetName, presets } from 'three-hatching';
import { FLAT_SCENES, type FlatScene, type FlatSceneName } from './flatScenes.js';

/** The view of a scene: from nearby, from afar, or from nearby with its light turned. */
export const FLAT_VIEWS = ['near', 'far', 'turned'] as const;

/** Drawings of a scene of plain faces, one from each view. */
export interface FlatPictures {
  scene: FlatSceneName;
  preset: PresetName;
  views: readonly (typeof FLAT_VIEWS)[number][];
  /** The size of each picture in pixels. */
  width: number;
  height: number;
  shadows: boolean;
}

/** The turn of the light about the vertical, radians. */
const TURN = (110 * Math.PI) / 180;
/** The milliseconds in which the worker makes the lists of contours of a view. */
const PAUSE = 150;

const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.shadowMap.type = PCFShadowMap;
document.body.append(renderer.domElement);
/** The previous scene, kept until the next is drawn, so that shared shaders are compiled once. */
let former: { dispose(): void } | undefined;

/**
 * Draws a scene as a user does who writes `applyHatching(scene, { preset })`.
 *
 * @returns the pictures as addresses of PNGs
 */
async function drawFlat({ scene: name, preset, views, width, height, shadows }: FlatPictures): Promise<string[]> {
  const { make, eye, target, light, fieldOfView = 32, far = 2.4 }: FlatScene = FLAT_SCENES[name];
  renderer.setSize(width, height, false);
  renderer.shadowMap.enabled = shadows;
  const sun = new DirectionalLight('white', Math.PI);
  const scene = new Scene().add(make(), sun, sun.target);
  const at = new Vector3(...target);
  const reach = Math.min(MOST_REACH, new Box3().setFromObject(scene).getBoundingSphere(new Sphere()).radius);
  if (shadows) castShadows(scene, sun, reach);
  const hatched = await applyHatching(scene, { preset });
  await hatched.formReady;
  scene.background = new Color(presets[preset].material.paper ?? 'white');

  const camera = new PerspectiveCamera(fieldOfView, width / height, 0.05, 500);
  const addresses: string[] = [];
  for (const view of views) {
    sun.target.position.copy(at);
    sun.position.set(...light).setLength(2 * reach);
    if (view === 'turned') sun.position.applyAxisAngle(new Vector3(0, 1, 0), TURN);
    sun.position.add(at);
    camera.position.set(...eye);
    if (view === 'far') camera.position.sub(at).multiplyScalar(far).add(at);
    camera.lookAt(at);
    // It is drawn for a second time, with the lists of contours that the worker has made meanwhile.
    renderer.render(scene, camera);
    await new Promise((resolve) => setTimeout(resolve, PAUSE));
    renderer.render(scene, camera);
    addresses.push(renderer.domElement.toDataURL('image/png'));
  }
  former?.dispose();
  former = hatched;
  return addresses;
}

/** The most that shadows reach around what is looked at, in units of the scene. */
const MOST_REACH = 14;

function castShadows(scene: Scene, sun: DirectionalLight, reach: number): void {
  scene.traverse((object) => {
    if (object instanceof Mesh) object.castShadow = object.receiveShadow = true;
  });
  sun.castShadow = true;
  sun.shadow.mapSize.setScalar(2048);
  Object.assign(sun.shadow.camera, {
    left: -reach,
    right: reach,
    bottom: -reach,
    top: reach,
    near: 0.1,
    far: 4 * reach,
  });
  sun.shadow.bias = -0.0005;
  sun.shadow.normalBias = 0.02;
}

const flatScenes = Object.keys(FLAT_SCENES);

declare global {
  interface Window {
    drawFlat?: typeof drawFlat;
    flatScenes?: readonly string[];
    flatViews?: readonly string[];
  }
}
Object.assign(window, { drawFlat, flatScenes, flatViews: FLAT_VIEWS });
