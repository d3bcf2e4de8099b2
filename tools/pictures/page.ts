import {
  Box3,
  DirectionalLight,
  Group,
  MathUtils,
  Mesh,
  MeshBasicMaterial,
  PCFShadowMap,
  PlaneGeometry,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import {
  applyHatching,
  bakeOcclusion,
  HatchingMaterial,
  type HatchingPreset,
  HatchingShadowMaterial,
  type PresetName,
  presets,
  scalePreset,
} from 'three-hatching';
import { type ExampleHandName, exampleHand } from 'three-hatching/hands';
import { fitCamera } from '../../src/viewer/sceneSetup/framing.js';
import { createCamera } from '../../src/viewer/sceneSetup/LensCamera.js';
import { drawSwatches } from './drawSwatches.js';
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
  /** More lights, which are weaker. */
  fills?: { light: [number, number, number]; strength: number }[];
  view: [number, number, number];
  /** Rotation of the subject in degrees about x, y and z. */
  turned?: [number, number, number];
  /** Size of the picture relative to one that the subject just fills. */
  zoom?: number;
  shadows?: boolean;
  /** The ground: a sheet that shows only the shadow, or a floor. */
  ground?: 'shadow' | 'floor';
  /** Strength of the ambient occlusion, 0 to 1. */
  occlusion?: number;
  /** Differences from the preset. */
  material?: HatchingPreset['material'];
  outlines?: HatchingPreset['outlines'];
  /** The hand that draws, in whole strokes; its swatches stand above the picture. */
  hand?: ExampleHandName;
}

/** The swatches of a hand, in the ink and on the paper of a preset. */
export interface SwatchPicture {
  swatchesOf: ExampleHandName;
  preset: PresetName;
  /** The size of the picture in pixels. */
  width: number;
  height: number;
}

/** Rendered pixels per pixel of the picture, along each axis. */
const SUPERSAMPLING = 2;
const SHADOW_MAP_SIZE = 2048;
/** The height of three swatches over their width, with room for their name. */
const SWATCHES_SHARE = 0.4;
/** Side of the ground, in radii of the subject, and into how many parts it is divided along each side. */
const GROUND = { size: 40, parts: 40 };

/** A scene of a picture, which can be drawn again under another light. */
interface Drawing {
  /** Draws it, in the size of the picture. @param direction to the light, if it has moved */
  draw(direction?: Picture['light']): HTMLCanvasElement;
  dispose(): void;
}

/**
 * @param content of the file that holds the subject, in base64; empty if none does
 * @returns the picture as the address of a PNG
 */
async function drawPicture(picture: Picture, content: string): Promise<string> {
  const drawing = await createDrawing(picture, content);
  const canvas = drawing.draw();
  const address = (picture.hand ? belowSwatches(canvas, picture.hand, picture) : canvas).toDataURL('image/png');
  drawing.dispose();
  return address;
}

/**
 * Draws a picture once under each light.
 *
 * @param lights directions to the light
 * @returns the pictures as addresses of PNGs
 */
async function drawUnder(picture: Picture, content: string, lights: readonly Picture['light'][]): Promise<string[]> {
  const drawing = await createDrawing(picture, content);
  const addresses = lights.map((light) => drawing.draw(light).toDataURL('image/png'));
  drawing.dispose();
  return addresses;
}

/** A drawing by a hand, below the swatches that the hand was learnt from. */
function belowSwatches(drawing: HTMLCanvasElement, name: ExampleHandName, { preset }: Picture): HTMLCanvasElement {
  const { width, height } = drawing;
  const above = Math.round(SWATCHES_SHARE * width);
  const context = swatchSheet(name, preset, width, height + above);
  context.drawImage(drawing, 0, above);
  return context.canvas;
}

/** @returns the swatches of a hand as the address of a PNG */
const drawSwatchesOf = ({ swatchesOf, preset, width, height }: SwatchPicture): string =>
  swatchSheet(swatchesOf, preset, width, height).canvas.toDataURL('image/png');

/** A sheet with the swatches of a hand at its upper edge. */
function swatchSheet(name: ExampleHandName, preset: PresetName, width: number, height: number) {
  const { paper = 'white', ink = 'black' } = presets[preset].material;
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', {
    alpha: false,
  })!;
  context.fillStyle = String(paper);
  context.fillRect(0, 0, width, height);
  drawSwatches(context, exampleHand(name), width, String(ink));
  return context;
}

/** A step of a picture in motion. */
export interface Step {
  light: Picture['light'];
  /** Place of the drawn lamp, in pixels of the picture. */
  lamp: [x: number, y: number];
}

/**
 * Draws a picture once for each step of its light, with a lamp that shows where the light is.
 *
 * @param quality of the WebP images, from 0 to 1
 * @returns the pictures as addresses of WebP images
 */
async function drawMotion(
  picture: Picture,
  content: string,
  steps: readonly Step[],
  quality: number,
): Promise<string[]> {
  const drawing = await createDrawing(picture, content);
  const addresses = steps.map(({ light, lamp }) => {
    const canvas = drawing.draw(light);
    drawLamp(canvas.getContext('2d')!, ...lamp);
    return canvas.toDataURL('image/webp', quality);
  });
  drawing.dispose();
  return addresses;
}

/** Radii of the lamp and its glow, in pixels. */
const LAMP = { radius: 9, glow: 17 };

function drawLamp(context: CanvasRenderingContext2D, x: number, y: number): void {
  for (const [radius, colour] of [
    [LAMP.glow, '#ffc23c55'],
    [LAMP.radius, '#ffb000'],
  ] as const) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
  }
  context.lineWidth = 1.5;
  context.strokeStyle = '#1c1a17';
  context.stroke();
}

async function createDrawing(picture: Picture, content: string): Promise<Drawing> {
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
  const framedPoints = centre(holder);

  const preset = presets[picture.preset];
  const look = {
    ...preset,
    material: { ...preset.material, ...(picture.hand && drawnBy(picture.hand)), ...picture.material },
    outlines: { ...preset.outlines, ...picture.outlines },
  };
  const scaled = scalePreset(look, SUPERSAMPLING * pixelRatio);
  const hatched = [await applyHatching(holder, scaled)];
  if (picture.ground) {
    const ground = groundBelow(holder);
    scene.add(ground);
    const floor = await applyHatching(ground, { ...scaled, outlines: false });
    hatched.push(floor);
    if (picture.ground === 'shadow') ground.material = shadowsOf(floor.materials[0], scaled.shadow);
  }
  await Promise.all(hatched.map(({ formReady }) => formReady));
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    object.castShadow = object.receiveShadow = true;
    if (picture.occlusion !== undefined && object.material instanceof HatchingMaterial)
      object.material.occlusion = picture.occlusion;
  });
  const occlusion = picture.occlusion === undefined ? undefined : await bakeOcclusion(scene);
  renderer.setClearColor(look.material.paper ?? 'white', 1);

  const suns = [{ light: picture.light, strength: 1 }, ...(picture.fills ?? [])].map(({ light, strength }) =>
    sunAt(light, strength, picture.shadows === true),
  );
  scene.add(...suns);

  const camera = createCamera();
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  fitCamera(camera, framedPoints, new Vector3(...picture.view), { zoom: picture.zoom });
  renderer.render(scene, camera);

  const small = document.createElement('canvas');
  Object.assign(small, { width, height });
  const target = small.getContext('2d', { alpha: false })!;
  target.imageSmoothingQuality = 'high';
  return {
    draw: (direction) => {
      if (direction) suns[0].position.set(...direction).setLength(SUN_DISTANCE);
      // It is drawn for a second time, with the lists of contours that the worker has made meanwhile.
      renderer.render(scene, camera);
      target.drawImage(canvas, 0, 0, width, height);
      return small;
    },
    dispose: () => {
      occlusion?.dispose();
      for (const one of hatched) one.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

/** Pixels of the picture to a millimetre of a hand's sheet. */
const PIXELS_PER_MILLIMETRE = 3.4;

/** The strokes of a hand, all hands at one scale. */
function drawnBy(name: ExampleHandName): HatchingPreset['material'] {
  const hand = exampleHand(name);
  return { hand, strokeWidth: PIXELS_PER_MILLIMETRE * hand.numbers.width };
}

const SUN_DISTANCE = 3;

/** @param direction to the light */
function sunAt(direction: readonly [number, number, number], strength: number, castsShadow: boolean): DirectionalLight {
  const light = new DirectionalLight('white', Math.PI * strength);
  light.position.set(...direction).setLength(SUN_DISTANCE);
  light.castShadow = castsShadow;
  light.shadow.mapSize.setScalar(SHADOW_MAP_SIZE);
  Object.assign(light.shadow.camera, { left: -1.05, right: 1.05, bottom: -1.05, top: 1.05, near: 1, far: 7 });
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.02;
  light.shadow.radius = 2;
  return light;
}

function groundBelow(object: Group): Mesh {
  const { size, parts } = GROUND;
  const ground = new Mesh(new PlaneGeometry(size, size, parts, parts).rotateX(-Math.PI / 2), new MeshBasicMaterial());
  ground.position.y = new Box3().setFromObject(object, true).min.y;
  return ground;
}

/** A material that shows shadows alone, in the strokes of a floor. */
function shadowsOf(floor: HatchingMaterial, shadow: HatchingPreset['shadow']): HatchingShadowMaterial {
  const material = new HatchingShadowMaterial().copy(floor as HatchingShadowMaterial);
  material.setValues({ transparent: true, paperOpacity: 0, depthWrite: false, ...shadow });
  return material;
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

/** The most points that can be arguments of one call. */
const sampled = (points: Vector3[]): Vector3[] => points.filter((_, i) => i % Math.ceil(points.length / 20_000) === 0);

declare global {
  interface Window {
    drawPicture?: typeof drawPicture;
    drawUnder?: typeof drawUnder;
    drawMotion?: typeof drawMotion;
    drawSwatchesOf?: typeof drawSwatchesOf;
  }
}
Object.assign(window, { drawPicture, drawUnder, drawMotion, drawSwatchesOf });
