import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  type Camera,
  Color,
  DataArrayTexture,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  HemisphereLight,
  type Light,
  LinearSRGBColorSpace,
  type Material,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SpotLight,
  Vector3,
} from 'three';
import {
  type HatchingMaterialParameters,
  type HatchingMaterialProperties,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { parametersOf } from 'three-hatching/facts';
import { drawsLines, needsAdjacency } from '../../src/look/queries.js';
import { pairThresholdLevels, ThresholdTexture } from '../../src/material/tam/thresholds.js';
import { plainLook } from '../../tools/plainLook.js';
import type { ReferenceLight } from '../reference/hatchingReference.js';
import type { Vec3 } from '../reference/referenceAdjacency.js';
import { ANALYTIC_TONES, type AnalyticMapName, analyticMaps, analyticThreshold } from './analyticMaps.js';
import type { HatchingSpec, LineSettings } from './hatchingSpec.js';
import { quadraticAt, quadraticGradient } from './quadratics.js';

const maps = new Map<AnalyticMapName, TonalArtMap>();

function analyticMap(name: AnalyticMapName): TonalArtMap {
  let map = maps.get(name);
  if (map === undefined) {
    const { size, levels, darkness } = analyticMaps[name];
    const images = Array.from({ length: ANALYTIC_TONES }, (_, tone) =>
      Array.from({ length: levels }, (_, level) => {
        const side = size >> level;
        return Uint8Array.from({ length: side * side }, (_, i) => {
          const value = darkness(tone, ((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side, level);
          return Math.round(255 * (1 - value));
        });
      }),
    );
    map = TonalArtMap.fromHatchImages({ size, images });
    maps.set(name, map);
  }
  return map;
}

/** The part of a map that the material needs for `hatching`: only thresholds. */
function analyticThresholdMap(): TonalArtMap {
  const { size, levels, field } = analyticThreshold;
  const drawn = Array.from({ length: levels }, (_, level) => {
    const side = size >> level;
    const encoded = Uint8Array.from({ length: side * side }, (_, i) =>
      Math.round(127.5 + 42.5 * field(((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side, level)),
    );
    return { size: side, encoded, thresholds: new Float32Array() };
  });
  // These moments declare the field standard normal: the reference does not correct the variance either.
  const thresholdMoments = { variance: 1, coarserVariance: 1, covariance: 0 };
  return {
    size,
    tones: 2,
    levels,
    thresholdTexture: new ThresholdTexture(pairThresholdLevels(drawn)),
    thresholdMoments,
    isTonalArtMap: true,
    isReady: true,
    // Techniques that read thresholds do not read this.
    texture: new DataArrayTexture(),
  } as unknown as TonalArtMap;
}

const thresholdMap = analyticThresholdMap();

function makeLight(light: ReferenceLight, scene: Scene): Light {
  const color = new Color().setRGB(...light.color, LinearSRGBColorSpace);
  const made = {
    ambient: () => new AmbientLight(color),
    hemisphere: () => new HemisphereLight(color, new Color().setRGB(...(light.groundColor ?? [0, 0, 0]))),
    directional: () => new DirectionalLight(color),
    point: () => new PointLight(color, 1, light.distance ?? 0, light.decay ?? 2),
    spot: () => new SpotLight(color, 1, light.distance ?? 0, light.angle, light.penumbra, light.decay ?? 2),
  }[light.type]();
  if (light.position) made.position.fromArray(light.position);
  if (made instanceof DirectionalLight || made instanceof SpotLight) {
    made.target.position.fromArray(light.target ?? [0, 0, 0]);
    scene.add(made.target);
  }
  if (light.isBlocked) {
    made.castShadow = true;
    const screen = new Mesh(new PlaneGeometry(8, 8), invisible);
    screen.castShadow = true;
    screen.position.copy(made.position).multiplyScalar(0.5);
    screen.lookAt(made.position);
    scene.add(screen);
  }
  scene.add(made);
  return made;
}

/** A material for objects that only cast shadows. */
const invisible = new MeshBasicMaterial({ side: DoubleSide, colorWrite: false, depthWrite: false });

/** Gives a geometry what lines that follow the form are drawn from: functions of the place from its centre, in tiles. */
function setForm(geometry: BufferGeometry, form: NonNullable<LineSettings['form']>, tilesPerObjectUnit: number): void {
  geometry.computeBoundingSphere();
  const { position } = geometry.attributes;
  const places = Array.from({ length: position.count }, (_, i) => {
    const place = new Vector3().fromBufferAttribute(position, i).sub(geometry.boundingSphere!.center);
    return place.multiplyScalar(tilesPerObjectUnit).toArray() as Vec3;
  });
  const set = (name: string, itemSize: number, values: number[]): void => {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), itemSize));
  };
  set(
    'formValue',
    2,
    places.flatMap((place) => form.map((quadratic) => quadraticAt(quadratic, place))),
  );
  for (const [name, quadratic] of [
    ['formSlope', form[0]],
    ['formCrossing', form[1]],
  ] as const) {
    const gradients = places.flatMap((place) => [
      ...quadraticGradient(quadratic, place).map((slope) => slope * tilesPerObjectUnit),
      0,
    ]);
    set(name, 4, gradients);
  }
}

/** The properties of a material of either renderer that are set here. */
type MadeMaterial = Material &
  Pick<
    HatchingMaterialProperties,
    'latticeSpacing' | 'color' | 'edgePixels' | 'ink' | 'paper' | 'perTriangle' | 'screenSpaceShare' | 'strokeAngle'
  >;

/** A spec as a scene. */
export interface SpecScene {
  scene: Scene;
  camera: Camera;
  dispose(): void;
}

/** A camera with the projection of a spec. Its range of depths is another one with WebGPU, where three.js reckons the projection anew. */
function cameraOf({ orthographic, camera: { projection } }: HatchingSpec): OrthographicCamera | PerspectiveCamera {
  const [across, up, depth, shift] = [projection[0], projection[5], projection[10], projection[14]];
  if (orthographic) {
    return new OrthographicCamera(-1 / across, 1 / across, 1 / up, -1 / up, (shift + 1) / depth, (shift - 1) / depth);
  }
  const fov = (2 * Math.atan(1 / up) * 180) / Math.PI;
  return new PerspectiveCamera(fov, up / across, shift / (depth - 1), shift / (depth + 1));
}

/** @param make makes the material, of whichever renderer */
export async function specScene(
  spec: HatchingSpec,
  make: (parameters: HatchingMaterialParameters) => MadeMaterial,
): Promise<SpecScene> {
  const source = new BufferGeometry();
  source.setAttribute('position', new BufferAttribute(new Float32Array(spec.positions), 3));
  if (spec.normals) source.setAttribute('normal', new BufferAttribute(new Float32Array(spec.normals), 3));
  const form = spec.lines?.form ?? spec.strokes?.form;
  if (form) setForm(source, form, spec.material.tilesPerObjectUnit);
  source.setIndex(new BufferAttribute(new Uint32Array(spec.indices), 1));
  const { technique } = spec.material;
  const isPerFragment = !needsAdjacency({ technique });
  const geometry = isPerFragment ? source : await prepareHatchingGeometry(source, { adjacency: true });

  const { form: _form, ...lines } = spec.lines ?? {};
  const takesThresholds = technique === 'hatching' || spec.material.sharpInk;
  const { ink, paper, color, strokeOffset, strokeAngle, ...material } = spec.material;
  const hatching = make(
    plainLook({
      ...parametersOf(material),
      ...(!drawsLines(technique) && { tonalArtMap: takesThresholds ? thresholdMap : analyticMap(spec.map) }),
      ...lines,
      ...(spec.strokes && { direction: spec.strokes.direction }),
      side: spec.doubleSided ? DoubleSide : FrontSide,
    }),
  );
  // These properties are set separately, since parameters that the technique does not use would cause a warning.
  hatching.perTriangle.strokeOffset.set(...strokeOffset);
  hatching.strokeAngle = strokeAngle;
  hatching.edgePixels = 0;
  if (spec.dots) Object.assign(hatching, { ...spec.dots, technique: 'stipple', tonalArtMap: null });
  hatching.latticeSpacing = spec.latticeSpacing ?? 0.35;
  hatching.screenSpaceShare = spec.screenSpaceShare ?? 0;
  hatching.ink.setRGB(...(ink as [number, number, number]), LinearSRGBColorSpace);
  hatching.paper.setRGB(...(paper as [number, number, number]), LinearSRGBColorSpace);
  hatching.color.setRGB(...(color as [number, number, number]), LinearSRGBColorSpace);

  const scene = new Scene();
  scene.background = new Color(0x00ff00);
  const lights = spec.lights.map((light) => makeLight(light, scene));
  const mesh = new Mesh(geometry, hatching);
  mesh.matrixAutoUpdate = false;
  mesh.matrix.fromArray(spec.matrixWorld);
  mesh.matrixWorldNeedsUpdate = true;
  mesh.frustumCulled = false;
  mesh.receiveShadow = true;
  mesh.userData.hatching = { importance: spec.importance };
  scene.add(mesh);

  const camera = cameraOf(spec);
  camera.matrixAutoUpdate = false;
  camera.matrix.fromArray(spec.camera.view).invert();
  camera.matrixWorldNeedsUpdate = true;
  camera.projectionMatrix.fromArray(spec.camera.projection);
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();

  return {
    scene,
    camera,
    dispose() {
      for (const light of lights) light.dispose();
      geometry.dispose();
      hatching.dispose();
    },
  };
}
