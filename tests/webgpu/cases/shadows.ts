import {
  BasicShadowMap,
  type Light,
  type LightShadow,
  Mesh,
  PCFShadowMap,
  PlaneGeometry,
  PointLight,
  SpotLight,
  type Vector3Tuple,
  VSMShadowMap,
} from 'three';
import { type HatchingMaterialParameters, prepareHatchingGeometry } from 'three-hatching';
import { type KnotStage, knot, shadowed } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = { technique: 'engraved', exposure: 1, lineSpacing: 6 } as const;
const STROKES = { technique: 'anchored', exposure: 1, edgePixels: 0 } as const;
const SHADOWS = { toneModel: 'shadow', transparent: true, paperOpacity: 0 } as const;

type Casting = Light & { shadow: LightShadow };

function casting<Shining extends Casting>(light: Shining, ...[x, y, z]: Vector3Tuple): Shining {
  light.position.set(x, y, z);
  light.castShadow = true;
  Object.assign(light.shadow.camera, { near: 0.3, far: 12 });
  light.shadow.bias = -0.0005;
  light.shadow.normalBias = 0.02;
  return light;
}

/** A knot that stands on a ground and casts its shadow on it. @param ground its material; that of the knot, if there is none */
async function onGround(
  kit: Kit,
  parameters: HatchingMaterialParameters,
  ground: HatchingMaterialParameters | null = null,
): Promise<KnotStage> {
  const stage = shadowed(knot(await kit.hatching(parameters)));
  stage.mesh.scale.setScalar(0.7);
  const { camera } = stage.sun.shadow;
  Object.assign(camera, { left: -2, right: 2, top: 2, bottom: -2 });
  stage.sun.position.set(2.2, 2.4, 0.4);
  const floor = new Mesh(new PlaneGeometry(4, 4), ground ? await kit.hatching(ground) : stage.mesh.material);
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -0.75;
  floor.receiveShadow = true;
  stage.scene.add(floor);
  stage.camera.position.set(0.6, 1.6, 3.8);
  stage.camera.lookAt(0, -0.2, 0);
  return stage;
}

/** The same under another light too, which casts a shadow of its own. */
async function underTwo(kit: Kit, parameters: HatchingMaterialParameters, light: Casting): Promise<KnotStage> {
  const stage = await onGround(kit, parameters);
  stage.sun.intensity = 1.2;
  stage.scene.add(light);
  return stage;
}

const lamp = (): PointLight => casting(new PointLight(0xffffff, 1, 0, 0), -1.5, 1.6, 1.2);
const spot = (): SpotLight => casting(new SpotLight(0xffffff, 1.2, 0, 0.6, 0.3, 0), -1.8, 2.4, 1.6);

/** Only shadows, on the ground. @param light in the place of the sun, where there is one */
async function alone(kit: Kit, parameters: HatchingMaterialParameters, light: Casting | null = null) {
  const stage = await onGround(kit, LINES, { ...SHADOWS, ...parameters });
  if (light) stage.scene.remove(stage.sun).add(light);
  return stage;
}

/** What shadows do to strokes, and shadows alone. */
export const cases: readonly SceneCase[] = [
  {
    name: 'lines that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...LINES, shadowStrokes: 'cross' }),
  },
  {
    name: 'strokes of a pen that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...LINES, shadowStrokes: 'cross', medium: 'pen', localTone: 0.5, color: 0x888888 }),
  },
  {
    name: 'anchored strokes that cross in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...STROKES, shadowStrokes: 'cross' }),
  },
  {
    name: 'lines that turn in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...LINES, shadowStrokes: 'reorient', lineField: 'light' }),
  },
  {
    name: 'lines that turn in the shadows of two lights',
    shadows: PCFShadowMap,
    show: (kit) => underTwo(kit, { ...LINES, shadowStrokes: 'reorient', lineField: 'light' }, lamp()),
  },
  {
    name: 'anchored strokes that turn in a shadow',
    shadows: PCFShadowMap,
    show: (kit) => onGround(kit, { ...STROKES, shadowStrokes: 'reorient' }),
  },
  {
    name: 'anchored strokes that turn in the shadows of two lights',
    shadows: PCFShadowMap,
    show: (kit) => underTwo(kit, { ...STROKES, shadowStrokes: 'reorient' }, spot()),
  },
  {
    name: 'lines along the form that turn in a shadow',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = await onGround(kit, { ...LINES, shadowStrokes: 'reorient', lineField: 'form' });
      stage.mesh.geometry = await prepareHatchingGeometry(stage.mesh.geometry, { form: true });
      return stage;
    },
  },
  {
    name: 'blended shadows',
    shadows: BasicShadowMap,
    show: (kit) => underTwo(kit, LINES, lamp()),
  },
  {
    name: 'soft maps of shadows',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = await underTwo(kit, LINES, lamp());
      stage.sun.shadow.radius = 3;
      stage.sun.shadow.intensity = 0.7;
      return stage;
    },
  },
  {
    name: 'shadows of variances',
    shadows: VSMShadowMap,
    show: (kit) => underTwo(kit, { ...LINES, shadowStrokes: 'cross' }, spot()),
  },
  { name: 'shadows alone', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES) },
  { name: 'shadows alone, anchored', shadows: PCFShadowMap, show: (kit) => alone(kit, STROKES) },
  {
    name: 'shadows alone, carved, as dark as black and as wide as their maps say',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, medium: 'woodcut', shadowTone: 1, shadowFade: 0, shadowSoftness: 0 }),
  },
  {
    name: 'shadows alone, of strokes that cross',
    shadows: PCFShadowMap,
    show: (kit) => alone(kit, { ...LINES, shadowDirection: 'strokes', shadowStrokes: 'cross' }),
  },
  { name: 'shadows alone, of a cone', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES, spot()) },
  { name: 'shadows alone, of a lamp', shadows: PCFShadowMap, show: (kit) => alone(kit, LINES, lamp()) },
  { name: 'shadows alone, blended', shadows: BasicShadowMap, show: (kit) => alone(kit, LINES) },
  { name: 'shadows alone, of variances', shadows: VSMShadowMap, show: (kit) => alone(kit, LINES) },
];
