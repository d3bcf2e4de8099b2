/**
 * Features of three.js, each in its own scene, which is drawn twice: with `HatchingMaterial` and with three's `MeshLambertMaterial`.
 * Light is compared as tone (`debugView: 'tone'`), colours and cut-outs as blank paper.
 */
import './quickBlur.js';
import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { HatchingMaterial, type HatchingTechnique, prepareHatchingGeometry } from 'three-hatching';
import { plainLook } from '../../tools/plainLook.js';

// Each scene tests one feature and is odd on purpose, so warnings about looks are off.
HatchingMaterial.silent = true;

const SIZE = 64;
const GROUND = new THREE.Color(0x00ff00);

type Parameters = THREE.MeshLambertMaterialParameters;

/** The scene of a feature. `dress` makes the tested material from a geometry and parameters. */
interface Stage {
  scene: THREE.Scene;
  renderer: THREE.WebGLRenderer;
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera;
  dress(
    geometry: THREE.BufferGeometry,
    parameters?: Parameters,
  ): Promise<THREE.Mesh<THREE.BufferGeometry, THREE.Material>>;
}

interface Feature {
  group: 'Light' | 'Shadows' | 'Surface' | 'Vertices' | 'Paper';
  name: string;
  /** Options of the renderer. */
  context?: THREE.WebGLRendererParameters;
  show(stage: Stage): Promise<void>;
}

/** The difference between a picture and Lambert's. */
export interface Comparison {
  /** Largest difference in 1/255, away from outlines and edges of shadows. */
  difference: number;
  /** Mean difference in 1/255. */
  mean: number;
  /** Pixels that were compared. */
  compared: number;
  /** Darkest to lightest of them. */
  spread: number;
}

const ball = () => new THREE.SphereGeometry(1, 48, 32);

function sun(intensity = Math.PI, position: [number, number, number] = [1, 1.5, 2]): THREE.DirectionalLight {
  const light = new THREE.DirectionalLight(0xffffff, intensity);
  light.position.set(...position);
  return light;
}

/** Light that leaves paper blank, and Lambert white. */
const flood = () => new THREE.AmbientLight(0xffffff, Math.PI);

function texture(channels: (x: number, y: number) => number[]): THREE.DataTexture {
  const texels = Uint8Array.from({ length: 32 * 32 * 4 }, (_, i) => channels((i >> 2) % 32, i >> 7)[i % 4] ?? 255);
  const made = new THREE.DataTexture(texels, 32, 32);
  made.magFilter = made.minFilter = THREE.LinearFilter;
  made.wrapS = made.wrapT = THREE.RepeatWrapping;
  made.repeat.set(2, 1);
  made.offset.set(0.1, 0.2);
  made.rotation = 0.3;
  made.needsUpdate = true;
  return made;
}

const wave = (x: number) => 128 + 80 * Math.sin((x / 16) * Math.PI);
const bumps = () => texture((x, y) => [wave(x), wave(y + 5), 230]);
const greys = () => texture((x, y) => [wave(x), wave(y), wave(x + y)]);

/** Under lights: a ball. */
const lit =
  (...lights: (() => THREE.Light)[]) =>
  async ({ scene, dress }: Stage): Promise<void> => {
    for (const light of lights) scene.add(light());
    scene.add(await dress(ball()));
  };

/** Under a sun: a ball of a material with these parameters. */
const surfaced =
  (parameters: () => Parameters) =>
  async ({ scene, dress }: Stage): Promise<void> => {
    scene.add(sun(1.2), new THREE.AmbientLight(0xffffff, 0.9), await dress(ball(), parameters()));
  };

/** A ball in flat light, of a material with these parameters. */
const papered =
  (parameters: () => Parameters) =>
  async ({ scene, dress }: Stage): Promise<void> => {
    scene.add(flood(), await dress(ball(), parameters()));
  };

/** A floor, and a block that throws a shadow onto it. */
const shadowed =
  (light: () => THREE.DirectionalLight | THREE.PointLight | THREE.SpotLight) =>
  async ({ scene, dress, renderer }: Stage): Promise<void> => {
    renderer.shadowMap.enabled = true;
    const one = light();
    one.castShadow = true;
    one.position.set(2, 1, 3);
    one.shadow.mapSize.set(512, 512);
    const floor = await dress(new THREE.PlaneGeometry(3, 3, 4, 4));
    const block = await dress(new THREE.BoxGeometry(0.6, 0.6, 0.6));
    block.position.set(0.3, 0.2, 0.6);
    block.castShadow = true;
    floor.receiveShadow = true;
    scene.add(one, new THREE.AmbientLight(0xffffff, 0.6), floor, block);
  };

const spot = () => new THREE.SpotLight(0xffffff, 5, 0, 0.6, 0.5, 0);

function probe(): THREE.LightProbe {
  const light = new THREE.LightProbe(undefined, 0.9);
  light.sh.coefficients[0].setScalar(0.7);
  light.sh.coefficients[2].set(0.3, 0.3, 0.3);
  light.sh.coefficients[3].set(-0.2, -0.2, -0.2);
  return light;
}

/** A tube along y on two bones, bent. */
async function bent({ scene, dress }: Stage): Promise<void> {
  const geometry = new THREE.CylinderGeometry(0.5, 0.5, 2, 32, 20, true);
  const { position } = geometry.attributes;
  const weights = Array.from({ length: position.count }, (_, i) => {
    const upper = THREE.MathUtils.smoothstep(position.getY(i), -0.3, 0.3);
    return [1 - upper, upper, 0, 0];
  });
  const indices = weights.flatMap(() => [0, 1, 0, 0]);
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights.flat(), 4));
  const plain = await dress(geometry);
  const mesh = new THREE.SkinnedMesh(plain.geometry, plain.material);
  const bones = [new THREE.Bone(), new THREE.Bone()];
  bones[0].add(bones[1]);
  mesh.add(bones[0]);
  mesh.bind(new THREE.Skeleton(bones));
  bones[1].rotation.z = 0.7;
  scene.add(sun(), new THREE.AmbientLight(0xffffff, 0.4), mesh);
}

async function morphed({ scene, dress }: Stage): Promise<void> {
  const geometry = ball();
  const bulge = (name: 'position' | 'normal') => {
    const values = Float32Array.from(geometry.attributes[name].array, (value, i) => (i % 3 === 0 ? 0.4 * value : 0));
    return new THREE.BufferAttribute(values, 3);
  };
  geometry.morphTargetsRelative = true;
  geometry.morphAttributes.position = [bulge('position')];
  geometry.morphAttributes.normal = [bulge('normal')];
  const mesh = await dress(geometry);
  mesh.morphTargetInfluences = [0.7];
  scene.add(sun(), new THREE.AmbientLight(0xffffff, 0.4), mesh);
}

const places = () => [
  new THREE.Matrix4().makeRotationX(0.7).setPosition(-0.7, 0.3, 0),
  new THREE.Matrix4()
    .makeRotationY(1.1)
    .scale(new THREE.Vector3(0.8, 1.1, 0.7))
    .setPosition(0.6, -0.3, 0.2),
];

async function instanced({ scene, dress }: Stage, colors?: boolean): Promise<void> {
  const { geometry, material } = await dress(new THREE.SphereGeometry(0.6, 32, 20));
  const mesh = new THREE.InstancedMesh(geometry, material, 2);
  for (const [i, matrix] of places().entries()) {
    mesh.setMatrixAt(i, matrix);
    if (colors) mesh.setColorAt(i, new THREE.Color(i === 0 ? 0xff8844 : 0x4488ff));
  }
  scene.add(colors ? flood() : sun(), mesh);
}

async function batched({ scene, dress }: Stage): Promise<void> {
  const { geometry, material } = await dress(new THREE.SphereGeometry(0.6, 32, 20));
  const mesh = new THREE.BatchedMesh(2, geometry.attributes.position.count, geometry.index?.count ?? 0, material);
  const id = mesh.addGeometry(geometry);
  for (const matrix of places()) mesh.setMatrixAt(mesh.addInstance(id), matrix);
  scene.add(sun(), mesh);
}

const moved =
  (move: (mesh: THREE.Mesh) => void, parameters?: Parameters) =>
  async ({ scene, dress }: Stage): Promise<void> => {
    const mesh = await dress(ball(), parameters);
    move(mesh);
    scene.add(sun(), new THREE.AmbientLight(0xffffff, 0.4), mesh);
  };

/** Two balls that cut into each other, so that depth decides. */
async function crossing({ scene, dress }: Stage): Promise<void> {
  const [one, other] = [await dress(ball()), await dress(ball())];
  one.position.x = -0.4;
  other.position.set(0.4, 0.2, 0.3);
  scene.add(sun(), new THREE.AmbientLight(0xffffff, 0.4), one, other);
}

const FEATURES: readonly Feature[] = [
  { group: 'Light', name: '`DirectionalLight`', show: lit(sun) },
  { group: 'Light', name: '`PointLight`', show: lit(() => placed(new THREE.PointLight(0xffffff, 20, 0, 2))) },
  {
    group: 'Light',
    name: '`PointLight` with a distance',
    show: lit(() => placed(new THREE.PointLight(0xffffff, 20, 6, 1))),
  },
  { group: 'Light', name: '`SpotLight`', show: lit(() => placed(spot())) },
  { group: 'Light', name: '`HemisphereLight`', show: lit(() => new THREE.HemisphereLight(0xffffff, 0x333333, 2.5)) },
  {
    group: 'Light',
    name: '`AmbientLight` and a sun',
    show: lit(
      () => new THREE.AmbientLight(0xffffff, 0.8),
      () => sun(1.5),
    ),
  },
  { group: 'Light', name: '`LightProbe`', show: lit(probe) },
  {
    group: 'Light',
    name: 'coloured lights',
    show: lit(
      () => tinted(sun(1.5), 0xff8844),
      () => tinted(sun(1.5, [-2, 0.5, 1]), 0x4488ff),
    ),
  },
  {
    group: 'Light',
    name: 'six lights of all kinds',
    show: lit(
      () => sun(0.8),
      () => sun(0.6, [-2, 0.5, 1]),
      () => placed(new THREE.PointLight(0xffffff, 3, 0, 2)),
      () => placed(spot()),
      () => new THREE.HemisphereLight(0xffffff, 0x000000, 0.4),
      () => new THREE.AmbientLight(0xffffff, 0.2),
    ),
  },
  {
    group: 'Light',
    name: '`scene.environment`',
    show: async ({ scene, renderer, dress }) => {
      scene.environment = roomFor(renderer);
      scene.environmentIntensity = 0.7;
      scene.environmentRotation.set(0.5, 1.2, -0.4);
      scene.add(await dress(ball()));
    },
  },
  { group: 'Shadows', name: 'of a `DirectionalLight`', show: shadowed(() => sun(2)) },
  { group: 'Shadows', name: 'of a `PointLight`', show: shadowed(() => new THREE.PointLight(0xffffff, 2, 0, 0)) },
  {
    group: 'Shadows',
    name: 'of a `SpotLight`',
    show: shadowed(() => new THREE.SpotLight(0xffffff, 2, 0, 0.7, 0.5, 0)),
  },
  {
    group: 'Surface',
    name: '`normalMap`',
    show: surfaced(() => ({ normalMap: bumps(), normalScale: new THREE.Vector2(0.7, -0.5) })),
  },
  {
    group: 'Surface',
    name: '`normalMap` of object space',
    show: surfaced(() => ({ normalMap: bumps(), normalMapType: THREE.ObjectSpaceNormalMap })),
  },
  { group: 'Surface', name: '`bumpMap`', show: surfaced(() => ({ bumpMap: greys(), bumpScale: 0.5 })) },
  { group: 'Surface', name: '`aoMap`', show: surfaced(() => ({ aoMap: greys(), aoMapIntensity: 0.8 })) },
  { group: 'Surface', name: '`lightMap`', show: surfaced(() => ({ lightMap: greys(), lightMapIntensity: 0.6 })) },
  {
    group: 'Surface',
    name: '`emissive`',
    show: surfaced(() => ({ emissive: new THREE.Color(0.1, 0.2, 0.05), emissiveIntensity: 1.5 })),
  },
  {
    group: 'Surface',
    name: '`emissiveMap`',
    show: surfaced(() => ({ emissive: new THREE.Color(0.5, 0.4, 0.3), emissiveMap: greys() })),
  },
  { group: 'Surface', name: '`flatShading`', show: surfaced(() => ({ flatShading: true })) },
  { group: 'Surface', name: '`side: BackSide`', show: moved(() => {}, { side: THREE.BackSide }) },
  { group: 'Surface', name: '`side: DoubleSide`', show: moved(() => {}, { side: THREE.DoubleSide }) },
  {
    group: 'Vertices',
    name: 'a turned and unevenly scaled mesh',
    show: moved((mesh) => {
      mesh.rotation.set(0.5, 0.6, 0.7);
      mesh.scale.set(1.2, 0.7, 0.9);
    }),
  },
  { group: 'Vertices', name: 'a mirrored mesh', show: moved((mesh) => mesh.scale.set(-1, 1, 1)) },
  { group: 'Vertices', name: '`InstancedMesh`', show: (stage) => instanced(stage) },
  { group: 'Vertices', name: '`BatchedMesh`', show: batched },
  { group: 'Vertices', name: '`SkinnedMesh`', show: bent },
  { group: 'Vertices', name: 'morph targets', show: morphed },
  {
    group: 'Vertices',
    name: '`OrthographicCamera`',
    show: async (stage) => {
      stage.camera = new THREE.OrthographicCamera(-1.4, 1.4, 1.4, -1.4, 0.1, 50);
      stage.camera.position.z = 4;
      await crossing(stage);
    },
  },
  { group: 'Vertices', name: '`logarithmicDepthBuffer`', context: { logarithmicDepthBuffer: true }, show: crossing },
  { group: 'Vertices', name: '`reversedDepthBuffer`', context: { reversedDepthBuffer: true }, show: crossing },
  { group: 'Paper', name: '`color`', show: papered(() => ({ color: 0x88aaff })) },
  { group: 'Paper', name: '`map`', show: papered(() => ({ map: greys() })) },
  {
    group: 'Paper',
    name: '`vertexColors`',
    show: async ({ scene, dress }) => {
      const geometry = ball();
      const { position } = geometry.attributes;
      geometry.setAttribute(
        'color',
        new THREE.BufferAttribute(
          Float32Array.from(position.array, (x) => 0.5 + 0.5 * x),
          3,
        ),
      );
      scene.add(flood(), await dress(geometry, { vertexColors: true }));
    },
  },
  { group: 'Paper', name: 'colours of instances', show: (stage) => instanced(stage, true) },
  { group: 'Paper', name: '`alphaMap`', show: papered(() => ({ alphaMap: greys(), transparent: true })) },
  {
    group: 'Paper',
    name: '`alphaTest`',
    show: papered(() => ({ alphaMap: greys(), alphaTest: 0.5, color: 0x88aaff })),
  },
  { group: 'Paper', name: '`opacity`', show: papered(() => ({ opacity: 0.4, transparent: true })) },
  {
    group: 'Paper',
    name: '`Fog`',
    show: async (stage) => {
      stage.scene.fog = new THREE.Fog(0x0000ff, 2.8, 4);
      await papered(() => ({}))(stage);
    },
  },
  {
    group: 'Paper',
    name: '`FogExp2`',
    show: async (stage) => {
      stage.scene.fog = new THREE.FogExp2(0x0000ff, 0.3);
      await papered(() => ({}))(stage);
    },
  },
  {
    group: 'Paper',
    name: 'clipping planes',
    show: async (stage) => {
      stage.renderer.clippingPlanes = [new THREE.Plane(new THREE.Vector3(1, 0.3, 0), 0.1)];
      await papered(() => ({ color: 0x88aaff }))(stage);
    },
  },
  {
    group: 'Paper',
    name: 'tone mapping and sRGB',
    show: async (stage) => {
      stage.renderer.toneMapping = THREE.ACESFilmicToneMapping;
      stage.renderer.outputColorSpace = THREE.SRGBColorSpace;
      await papered(() => ({ color: 0x88aaff, map: greys(), toneMapped: true }))(stage);
    },
  },
];

/** Blurred once for each renderer: a software rasterizer takes its time over it. */
const rooms = new Map<THREE.WebGLRenderer, THREE.Texture>();

function roomFor(renderer: THREE.WebGLRenderer): THREE.Texture {
  const room = rooms.get(renderer) ?? new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
  rooms.set(renderer, room);
  return room;
}

function placed<Light extends THREE.Light>(light: Light): Light {
  light.position.set(1, 1.5, 3);
  return light;
}

function tinted<Light extends THREE.Light>(light: Light, color: number): Light {
  light.color.set(color);
  return light;
}

function dressedIn(technique: HatchingTechnique, isPaper: boolean): Stage['dress'] {
  return async (geometry, parameters = {}) => {
    const { color, emissive, ...rest } = parameters;
    const material = new HatchingMaterial(
      plainLook({
        technique,
        toneNormal: parameters.flatShading ? 'face' : 'smooth',
        ...(isPaper ? {} : { debugView: 'tone' }),
        // Neighbours would blend a tone of their own into it.
        ...(technique === 'adjacency' ? { perTriangle: { blendAngle: 0 } } : {}),
        ...rest,
      }),
    );
    if (color !== undefined) material.color.set(color as THREE.ColorRepresentation);
    if (emissive !== undefined) material.emissive.set(emissive as THREE.ColorRepresentation);
    return new THREE.Mesh(await prepareHatchingGeometry(geometry, { adjacency: true }), material as THREE.Material);
  };
}

const dressedInLambert: Stage['dress'] = async (geometry, parameters) =>
  new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(parameters));

/** A renderer for each kind of context, so that features share programs. */
const renderers = new Map<string, THREE.WebGLRenderer>();

function rendererFor(context: THREE.WebGLRendererParameters = {}): THREE.WebGLRenderer {
  const key = JSON.stringify(context);
  let renderer = renderers.get(key);
  if (!renderer) {
    renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true, ...context });
    renderer.setSize(SIZE, SIZE, false);
    renderers.set(key, renderer);
  }
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.toneMapping = THREE.NoToneMapping;
  renderer.clippingPlanes = [];
  renderer.shadowMap.enabled = false;
  return renderer;
}

async function draw({ show, context }: Feature, dress: Stage['dress']): Promise<Uint8Array> {
  const renderer = rendererFor(context);
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
  camera.position.z = 4;
  const stage: Stage = { scene: new THREE.Scene(), renderer, camera, dress };
  stage.scene.background = GROUND;
  await show(stage);
  renderer.render(stage.scene, stage.camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** Pixels are compared only where the picture changes less than this per pixel: rounding decides where outlines and shadows end. */
const STEEP = 24;

function compare(hatched: Uint8Array, lambert: Uint8Array, isPaper: boolean): Comparison {
  const value = (pixels: Uint8Array, place: number, channel: number): number => {
    const [r, g, b] = pixels.subarray(4 * place, 4 * place + 3);
    return isPaper || pixels === hatched ? [r, g, b][channel] : 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const isGround = (place: number) =>
    lambert[4 * place] === 0 && lambert[4 * place + 1] === 255 && lambert[4 * place + 2] === 0;
  const differences: number[] = [];
  const wanted: number[] = [];
  for (let y = 2; y < SIZE - 2; y++) {
    for (let x = 2; x < SIZE - 2; x++) {
      const place = y * SIZE + x;
      if (isGround(place)) continue;
      const near = [-2, -1, 1, 2].flatMap((d) => [place + d, place + d * SIZE]);
      const isSteep = near.some(
        (other) => isGround(other) || Math.abs(value(lambert, other, 0) - value(lambert, place, 0)) > STEEP,
      );
      if (isSteep) continue;
      for (const channel of isPaper ? [0, 1, 2] : [0]) {
        wanted.push(value(lambert, place, channel));
        differences.push(Math.abs(value(hatched, place, channel) - value(lambert, place, channel)));
      }
    }
  }
  return {
    difference: Math.max(...differences),
    mean: differences.reduce((sum, one) => sum + one, 0) / differences.length,
    compared: wanted.length,
    spread: Math.max(...wanted) - Math.min(...wanted),
  };
}

const besideLambert = {
  features: FEATURES.map(({ group, name }) => ({ group, name })),
  /** The differences of one feature, with every technique. */
  async measure(name: string, techniques: readonly HatchingTechnique[]): Promise<Comparison[]> {
    const feature = FEATURES.find((one) => one.name === name);
    if (!feature) throw new Error(`besideLambert: there is no feature ${name}.`);
    const isPaper = feature.group === 'Paper';
    const lambert = await draw(feature, dressedInLambert);
    const compared: Comparison[] = [];
    for (const technique of techniques) {
      compared.push(compare(await draw(feature, dressedIn(technique, isPaper)), lambert, isPaper));
    }
    return compared;
  },
};

declare global {
  interface Window {
    besideLambert: typeof besideLambert;
  }
}
// Tests draw in the same turn in which they make their materials.
await HatchingMaterial.preload();
window.besideLambert = besideLambert;
