import {
  DataTexture,
  DoubleSide,
  EquirectangularReflectionMapping,
  FloatType,
  HemisphereLight,
  IcosahedronGeometry,
  PCFShadowMap,
  PointLight,
  TorusKnotGeometry,
} from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { type KnotStage, knot, shadowed } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = { technique: 'engraved', lineField: 'slant', exposure: 1 } as const;

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters = {}): Promise<KnotStage> =>
  knot(await kit.hatching({ ...LINES, ...parameters }));

/** A window in a dim room. */
function room(): DataTexture {
  const [width, height] = [64, 32];
  const texels = new Float32Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const isWindow = x > 14 && x < 26 && y > 18 && y < 28;
    texels.set(isWindow ? [12, 11, 9, 1] : [0.15, 0.2 + (0.3 * y) / height, 0.3, 1], 4 * i);
  }
  const texture = new DataTexture(texels, width, height);
  texture.type = FloatType;
  texture.mapping = EquirectangularReflectionMapping;
  texture.needsUpdate = true;
  return texture;
}

/** A knot in a room, with the lamps of {@link knot} or without. */
async function inRoom(kit: Kit, parameters: HatchingMaterialParameters, hasLamps: boolean): Promise<KnotStage> {
  const stage = await drawn(kit, parameters);
  const { scene } = stage;
  scene.environment = room();
  scene.environmentIntensity = 0.6;
  scene.environmentRotation.set(0.2, 1, 0.1);
  if (hasLamps) stage.sun.intensity = 1;
  else scene.remove(...scene.children.filter((object) => 'isLight' in object));
  return stage;
}

/** A knot of few faces, under a lamp and a sky too. */
async function ofFaces(kit: Kit, parameters: HatchingMaterialParameters): Promise<KnotStage> {
  const stage = await drawn(kit, { toneNormal: 'face', ...parameters });
  stage.mesh.geometry = new TorusKnotGeometry(0.62, 0.24, 40, 7);
  const lamp = new PointLight(0xffddbb, 1.5, 0, 0);
  lamp.position.set(-1.5, 1, 1.5);
  stage.scene.add(lamp, new HemisphereLight(0xffffff, 0x202020, 0.7));
  stage.sun.intensity = 1;
  return stage;
}

/** Light of the surroundings, and of faces. */
export const cases: readonly SceneCase[] = [
  { name: 'an environment alone', show: (kit) => inRoom(kit, {}, false) },
  {
    name: 'an environment beside a lamp, on faces',
    show: (kit) => inRoom(kit, { toneNormal: 'face', exposure: 1.5 }, true),
  },
  { name: 'an exposure that is fitted to an environment', show: (kit) => inRoom(kit, { exposure: 'auto' }, true) },
  { name: 'the tone of faces', show: (kit) => ofFaces(kit, {}) },
  { name: 'the gloss of faces', show: (kit) => ofFaces(kit, { toneModel: 'phong', shininess: 8 }) },
  {
    name: 'the tone of faces, anchored, from both sides',
    async show(kit) {
      const stage = await ofFaces(kit, { technique: 'anchored', edgePixels: 0, side: DoubleSide });
      stage.mesh.geometry = new IcosahedronGeometry(0.95, 1);
      return stage;
    },
  },
  {
    name: 'lines on faces that turn in a shadow',
    shadows: PCFShadowMap,
    async show(kit) {
      const stage = shadowed(await drawn(kit, { toneNormal: 'face', lineField: 'light', shadowStrokes: 'reorient' }));
      stage.mesh.geometry = new TorusKnotGeometry(0.62, 0.24, 40, 7);
      return stage;
    },
  },
];
