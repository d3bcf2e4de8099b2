import { Box3, DirectionalLight, Group, MathUtils, Mesh, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import { applyHatching, type HatchingPreset, type PresetName, presets, scalePreset } from 'three-hatching';
import { createCamera } from '../src/demo/stage/createCamera.js';
import { fitCamera } from '../src/demo/stage/framing.js';
import { loadSubject, type SubjectName } from './subjects.js';

/** A picture of one subject in one preset. */
export interface Picture {
  subject: SubjectName;
  preset: PresetName;
  /** The size of the picture in pixels. */
  width: number;
  height: number;
  /** Pixels of the picture per CSS pixel. */
  pixelRatio: number;
  /** Direction to the light, and from the subject to the eye. */
  light: [number, number, number];
  view: [number, number, number];
  /** Rotation of the subject in degrees about x, y and z. */
  turned?: [number, number, number];
  /** How many times larger the picture is than one that the subject just fills. */
  zoom?: number;
  shadows?: boolean;
  /** What differs from the preset. */
  material?: HatchingPreset['material'];
  lines?: HatchingPreset['lines'];
}

/** Rendered pixels per pixel of the picture, along each axis. */
const SUPERSAMPLING = 2;
const SHADOW_MAP_SIZE = 2048;

/**
 * @param content of the file that holds the subject, in base64; empty if none does
 * @returns the picture as the address of a PNG
 */
async function drawPicture(picture: Picture, content: string): Promise<string> {
  const { width, height, pixelRatio } = picture;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: SUPERSAMPLING * width, height: SUPERSAMPLING * height });
  const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
  renderer.shadowMap.enabled = picture.shadows === true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.setSize(canvas.width, canvas.height, false);

  const root = await loadSubject(
    picture.subject,
    Uint8Array.from(atob(content), (character) => character.charCodeAt(0)).buffer,
  );
  const holder = new Group().add(root);
  holder.rotation.set(...((picture.turned ?? [0, 0, 0]).map(MathUtils.degToRad) as [number, number, number]));
  const scene = new Scene().add(holder);
  const outline = centre(holder);

  const preset = presets[picture.preset];
  const look = {
    ...preset,
    material: { ...preset.material, ...picture.material },
    lines: { ...preset.lines, ...picture.lines },
  };
  const hatched = await applyHatching(holder, scalePreset(look, SUPERSAMPLING * pixelRatio));
  holder.traverse((object) => {
    if (object instanceof Mesh) object.castShadow = object.receiveShadow = true;
  });
  renderer.setClearColor(look.material.paper ?? 'white', 1);

  const light = new DirectionalLight('white', Math.PI);
  light.position.set(...picture.light).setLength(3);
  light.castShadow = picture.shadows === true;
  light.shadow.mapSize.setScalar(SHADOW_MAP_SIZE);
  Object.assign(light.shadow.camera, { left: -1.05, right: 1.05, bottom: -1.05, top: 1.05, near: 1, far: 5 });
  light.shadow.bias = -0.002;
  light.shadow.normalBias = 0.02;
  light.shadow.radius = 2;
  scene.add(light);

  const camera = createCamera();
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  fitCamera(camera, outline, new Vector3(...picture.view), picture.zoom);
  renderer.render(scene, camera);
  // Once more, with the lists of contours that were made meanwhile.
  renderer.render(scene, camera);

  const small = document.createElement('canvas');
  Object.assign(small, { width, height });
  const target = small.getContext('2d', { alpha: false })!;
  target.imageSmoothingQuality = 'high';
  target.drawImage(canvas, 0, 0, width, height);
  hatched.dispose();
  renderer.dispose();
  renderer.forceContextLoss();
  return small.toDataURL('image/png');
}

/**
 * Moves and scales what `holder` holds so that it is centred, with its farthest point at distance 1.
 *
 * @returns its points as xyz
 */
function centre(holder: Group): number[] {
  holder.updateMatrixWorld(true);
  const points: Vector3[] = [];
  holder.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const count = object.geometry.getAttribute('position').count;
    for (let i = 0; i < count; i++)
      points.push(object.getVertexPosition(i, new Vector3()).applyMatrix4(object.matrixWorld));
  });
  const middle = new Box3().setFromPoints(points).getCenter(new Vector3());
  const radius = Math.max(...sampled(points).map((point) => point.distanceTo(middle)));
  const scale = 1 / radius;
  holder.scale.setScalar(scale);
  holder.position.copy(middle).multiplyScalar(-scale);
  holder.updateMatrixWorld(true);
  return sampled(points).flatMap((point) => point.sub(middle).multiplyScalar(scale).toArray());
}

/** At most so many points as can be arguments of a function. */
const sampled = (points: Vector3[]): Vector3[] => points.filter((_, i) => i % Math.ceil(points.length / 20_000) === 0);

declare global {
  interface Window {
    drawPicture?: typeof drawPicture;
  }
}
window.drawPicture = drawPicture;
