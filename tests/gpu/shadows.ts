/** The scene of the tests of shadows: a ball over a plane, seen from above. The ball is visible only by its shadow. */
import './toolkit.js';
import * as THREE from 'three';
import {
  HatchingMaterial,
  type HatchingMaterialParameters,
  HatchingShadowMaterial,
  type HatchingShadowMaterialParameters,
  type HatchingTechnique,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { plainLook, plainShadow } from '../../tools/plainLook.js';

export type LightKind = 'directional' | 'spot' | 'point' | 'point over a seam' | 'sun';
export type Filter = 'Basic' | 'PCF' | 'VSM';
type ShadowLight = THREE.DirectionalLight | THREE.SpotLight | THREE.PointLight;

/** The width and height of the picture in pixels. The camera sees the square from −1 to 1. */
const SIZE = 192;
const MAP_SIZE = 192;
const CENTRE = new THREE.Vector3(0.35, 0.25, 0.8);
const RADIUS = 0.35;

/** The directions to the lights, or their positions. Under all of them the shadow of the ball is in the picture. */
const PLACES: Record<LightKind, [number, number, number]> = {
  directional: [0.9, 0.7, 2.2],
  sun: [0.9, 0.7, 2.2],
  spot: [0.9, 0.7, 2.4],
  point: [0.6, 0.5, 2.4],
  // Seen from there, the middle of the shadow lies where two faces of the cube meet.
  'point over a seam': [2.5, 0.2, 3],
};

/** Older versions of three.js have no suns. */
const hasSun = THREE.ShaderChunk.lights_pars_begin.includes('NUM_SUN_LIGHTS');
const addons = import.meta.glob('../../node_modules/three/examples/jsm/lights/SunLight.js');

/** A light without attenuation. `arriving` is N·L times its intensity divided by π. */
async function lightOf(kind: LightKind, intensity = 2.6): Promise<ShadowLight> {
  let light: ShadowLight;
  if (kind === 'sun') {
    const { SunLight } = (await Object.values(addons)[0]()) as { SunLight: typeof THREE.DirectionalLight };
    light = new SunLight(0xffffff, intensity);
    light.shadow.mapSize.setScalar(MAP_SIZE);
  } else if (kind === 'directional') {
    light = new THREE.DirectionalLight(0xffffff, intensity);
    Object.assign(light.shadow.camera, { left: -2, right: 2, top: 2, bottom: -2, near: 0.5, far: 6 });
    light.shadow.mapSize.setScalar(MAP_SIZE);
  } else if (kind === 'spot') {
    light = new THREE.SpotLight(0xffffff, intensity, 0, 0.65, 0, 0);
    Object.assign(light.shadow.camera, { near: 0.5, far: 6 });
    light.shadow.mapSize.setScalar(MAP_SIZE);
  } else {
    light = new THREE.PointLight(0xffffff, intensity, 0, 0);
    Object.assign(light.shadow.camera, { near: 0.2, far: 6 });
    light.shadow.mapSize.setScalar(2 * MAP_SIZE);
  }
  light.position.set(...PLACES[kind]);
  return light;
}

/** Makes the light cast shadows, which are hard by default. */
function casting(light: ShadowLight, radius = 0): ShadowLight {
  light.castShadow = true;
  light.shadow.radius = radius;
  // With VSM whatever receives shadows casts them too, and its depths are halves.
  light.shadow.bias = -0.002;
  return light;
}

/** Units that a texel of the light's shadow map covers, across the light, at the ball. */
function texelOf(kind: LightKind, light: ShadowLight): number {
  const camera = light.shadow.camera as THREE.OrthographicCamera;
  if (kind === 'sun') {
    // The texel of the coarser cascade.
    const cascades = light.shadow as unknown as { getCamera(index: number): typeof camera };
    const widths = [0, 1].map((index) => cascades.getCamera(index)).map(({ left, right }) => right - left);
    return Math.max(...widths) / light.shadow.mapSize.x;
  }
  if (kind === 'directional') return (camera.right - camera.left) / light.shadow.mapSize.x;
  const away = light.position.distanceTo(CENTRE);
  if (kind === 'spot') return (2 * Math.tan((light as THREE.SpotLight).angle) * away) / light.shadow.mapSize.x;
  return (2 * away) / light.shadow.mapSize.x;
}

/** For each pixel, bottom row first, how far the ray from the plane to the light passes the ball: texels, below 0 in shadow. */
function clearances(kind: LightKind, light: ShadowLight): Float32Array {
  const isFar = kind === 'directional' || kind === 'sun';
  const texel = texelOf(kind, light);
  const [place, ray, toBall] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  return Float32Array.from({ length: SIZE * SIZE }, (_, i) => {
    place.set(((i % SIZE) + 0.5) / (SIZE / 2) - 1, (Math.floor(i / SIZE) + 0.5) / (SIZE / 2) - 1, 0);
    ray.copy(light.position);
    if (!isFar) ray.sub(place);
    const passing = toBall.subVectors(CENTRE, place).cross(ray.normalize()).length();
    return (passing - RADIUS) / texel;
  });
}

function ball(): THREE.Mesh {
  const mesh = new THREE.Mesh(
    new THREE.SphereGeometry(RADIUS, 160, 120),
    new THREE.MeshBasicMaterial({ colorWrite: false, depthWrite: false }),
  );
  mesh.position.copy(CENTRE);
  mesh.castShadow = true;
  return mesh;
}

/** Half the width of the board, and where it rises from the ground, at 45°. */
const BOARD = { x: 0.6, y: 0.8 } as const;

/** A board that leans over the plane: it stands on the line x = −0.6 and rises to x = 0.6. It is visible only by its shadow. */
function board(): THREE.Mesh {
  const { x, y } = BOARD;
  const corners = [
    [-x, -y, 0],
    [x, -y, 2 * x],
    [x, y, 2 * x],
    [-x, y, 0],
  ].map((corner) => new THREE.Vector3(...corner));
  const geometry = new THREE.BufferGeometry().setFromPoints(corners).setIndex([0, 1, 2, 0, 2, 3]);
  const mesh = new THREE.Mesh(
    geometry,
    new THREE.MeshBasicMaterial({ colorWrite: false, depthWrite: false, side: THREE.DoubleSide }),
  );
  mesh.castShadow = true;
  return mesh;
}

/**
 * For each pixel, bottom row first, how far the board is along the light, as a share of the width that the shadow's camera sees at the
 * plane; NaN where it casts no shadow, or close to the border of its shadow.
 */
function boardDistances(kind: LightKind, light: ShadowLight): Float32Array {
  const [place, ray, hit] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  const axis = light.position.clone().normalize();
  const camera = light.shadow.camera as THREE.OrthographicCamera;
  return Float32Array.from({ length: SIZE * SIZE }, (_, i) => {
    place.set(((i % SIZE) + 0.5) / (SIZE / 2) - 1, (Math.floor(i / SIZE) + 0.5) / (SIZE / 2) - 1, 0);
    ray.copy(light.position);
    if (kind !== 'directional') ray.sub(place);
    const width = {
      directional: camera.right - camera.left,
      spot: 2 * Math.tan((light as THREE.SpotLight).angle) * ray.dot(axis),
      point: 2 * Math.max(Math.abs(ray.x), Math.abs(ray.y), Math.abs(ray.z)),
    }[kind as 'directional' | 'spot' | 'point'];
    ray.normalize();
    const distance = (place.x + BOARD.x) / (ray.z - ray.x);
    hit.copy(place).addScaledVector(ray, distance);
    const isInside = distance > 0.25 && hit.x < BOARD.x - 0.1 && Math.abs(hit.y) < BOARD.y - 0.1;
    return isInside ? distance / width : Number.NaN;
  });
}

/** A plate over the half of the plane where x is above 0, at a height. It is visible only by its shadow. */
function plate(height: number): THREE.Mesh {
  const mesh = new THREE.Mesh(
    new THREE.PlaneGeometry(1.6, 3),
    new THREE.MeshBasicMaterial({ colorWrite: false, depthWrite: false, side: THREE.DoubleSide }),
  );
  mesh.position.set(0.8, 0, height);
  mesh.castShadow = true;
  return mesh;
}

/**
 * The visible share of a round lamp past the plate, along the middle row of the picture: the mean of rays to points all over the lamp.
 *
 * @param softness the width of the lamp as a share of its distance
 */
function plateVisibility(kind: LightKind, light: ShadowLight, height: number, softness: number): number[] {
  const [place, toLight, side, up, ray] = Array.from({ length: 5 }, () => new THREE.Vector3());
  const rays = 2000;
  return Array.from({ length: SIZE }, (_, i) => {
    place.set((i + 0.5) / (SIZE / 2) - 1, 0.5 / (SIZE / 2), 0);
    toLight.copy(light.position);
    if (kind !== 'directional') toLight.sub(place);
    toLight.normalize();
    side.set(0, 1, 0).cross(toLight).normalize();
    up.crossVectors(toLight, side);
    let seen = 0;
    for (let j = 0; j < rays; j++) {
      const [radius, angle] = [0.5 * softness * Math.sqrt((j + 0.5) / rays), j * Math.PI * (3 - Math.sqrt(5))];
      ray
        .copy(toLight)
        .addScaledVector(side, radius * Math.cos(angle))
        .addScaledVector(up, radius * Math.sin(angle));
      const x = place.x + (height / ray.z) * ray.x;
      if (x < 0 || x > 1.6) seen++;
    }
    return seen / rays;
  });
}

/** The outline of the ball's shadow under a directional light, as a black disc. */
function ellipse(light: ShadowLight): THREE.Mesh {
  const towards = light.position.clone().normalize();
  const u = new THREE.Vector3(0, 0, 1).cross(towards).normalize();
  const v = towards.clone().cross(u);
  const outline = Array.from({ length: 360 }, (_, i) => {
    const angle = (i * Math.PI) / 180;
    const point = CENTRE.clone()
      .addScaledVector(u, RADIUS * Math.cos(angle))
      .addScaledVector(v, RADIUS * Math.sin(angle));
    point.addScaledVector(towards, -point.z / towards.z);
    return new THREE.Vector2(point.x, point.y);
  });
  const disc = new THREE.Mesh(
    new THREE.ShapeGeometry(new THREE.Shape(outline)),
    new THREE.MeshBasicMaterial({ color: 0x000000, side: THREE.DoubleSide, depthTest: false }),
  );
  disc.renderOrder = 1;
  return disc;
}

let strokes: Promise<TonalArtMap> | undefined;

/** The map, which is generated once for the page. */
function strokeMap(): Promise<TonalArtMap> {
  strokes ??= TonalArtMap.generate({ size: 128 });
  return strokes;
}

/** A plane of many triangles that receives shadows, without its material, and what materials of all kinds have there. */
async function plane(technique: HatchingTechnique, isGrey: boolean) {
  const geometry = await prepareHatchingGeometry(new THREE.PlaneGeometry(2.4, 2.4, 5, 5), { adjacency: true });
  const tonalArtMap = isGrey ? window.toolkit.greyMap() : await strokeMap();
  const sizes =
    technique === 'engraving' ? { screenSpaceShare: 1, lineSpacing: 6 } : { tonalArtMap, tilesPerObjectUnit: 1 };
  return { geometry, look: { technique, ...sizes } };
}

function receiving<Drawn extends HatchingMaterial>(geometry: THREE.BufferGeometry, material: Drawn) {
  const mesh = new THREE.Mesh<THREE.BufferGeometry, Drawn>(geometry, material);
  mesh.receiveShadow = true;
  return mesh;
}

/** A ground. With `isGrey` and a map it shows its tone as a flat grey. */
async function ground(technique: HatchingTechnique, parameters: HatchingMaterialParameters = {}, isGrey = false) {
  const { geometry, look } = await plane(technique, isGrey);
  return receiving(geometry, new HatchingMaterial(plainLook({ ...look, ...parameters })));
}

/** The same that shows shadows alone, on paper of its own. */
async function shadowGround(
  technique: HatchingTechnique,
  parameters: HatchingShadowMaterialParameters = {},
  isGrey = false,
) {
  const { geometry, look } = await plane(technique, isGrey);
  const opaque = { transparent: false, paperOpacity: 1 };
  return receiving(geometry, new HatchingShadowMaterial(plainShadow({ ...look, ...opaque, ...parameters })));
}

const renderers = new Map<string, THREE.WebGLRenderer>();

/** The renderer is kept, because browsers allow only few contexts. */
function rendererOf(filter: Filter = 'PCF', parameters: THREE.WebGLRendererParameters = {}): THREE.WebGLRenderer {
  const key = JSON.stringify([filter, parameters]);
  let renderer = renderers.get(key);
  if (!renderer) {
    renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true, ...parameters });
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setSize(SIZE, SIZE, false);
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = { Basic: THREE.BasicShadowMap, PCF: THREE.PCFShadowMap, VSM: THREE.VSMShadowMap }[filter];
    renderers.set(key, renderer);
  }
  return renderer;
}

/** The camera, moved by whole pixels. */
function above(right = 0, up = 0): THREE.OrthographicCamera {
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.position.set((2 * right) / SIZE, (2 * up) / SIZE, 5);
  return camera;
}

function sceneOf(...things: THREE.Object3D[]): THREE.Scene {
  const scene = new THREE.Scene();
  scene.add(...things);
  return scene;
}

/** RGBA, bottom row first. */
function draw(scene: THREE.Scene, renderer = rendererOf(), camera: THREE.Camera = above()): Uint8Array {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** The differences between two pictures at the pixels for whose index `isAsked` is true. */
function compared(a: Uint8Array, b: Uint8Array, isAsked: (i: number) => boolean) {
  let [count, differing, most, meanA, meanB] = [0, 0, 0, 0, 0];
  for (let i = 0; i < a.length / 4; i++) {
    if (!isAsked(i)) continue;
    const apart = Math.abs(a[4 * i] - b[4 * i]);
    count++;
    if (apart > 32) differing++;
    most = Math.max(most, apart);
    meanA += a[4 * i] / 255;
    meanB += b[4 * i] / 255;
  }
  return { count, share: differing / count, most, means: [meanA / count, meanB / count] as const };
}

const shading = {
  THREE,
  HatchingMaterial,
  prepareHatchingGeometry,
  SIZE,
  hasSun,
  lightOf,
  casting,
  clearances,
  ball,
  board,
  plate,
  plateVisibility,
  boardDistances,
  ellipse,
  strokeMap,
  ground,
  shadowGround,
  rendererOf,
  above,
  sceneOf,
  draw,
  compared,
};

declare global {
  interface Window {
    shading: typeof shading;
  }
}
window.shading = shading;
