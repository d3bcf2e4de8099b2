import {
  BoxGeometry,
  BufferAttribute,
  CylinderGeometry,
  DataTexture,
  DoubleSide,
  Fog,
  HemisphereLight,
  LinearMipmapLinearFilter,
  type Material,
  Mesh,
  OrthographicCamera,
  PointLight,
  RepeatWrapping,
  SphereGeometry,
  SRGBColorSpace,
} from 'three';
import type { HatchingMaterialParameters } from 'three-hatching';
import { knot } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = {
  technique: 'engraving',
  direction: 'slant',
  shadowStrokes: 'tone',
  composition: { exposure: 1 },
} as const;

const drawn = async (kit: Kit, parameters: HatchingMaterialParameters = {}) =>
  knot(await kit.hatching({ ...LINES, ...parameters }));

/** A picture of four squares, repeated. */
function squares(texels: readonly number[]): DataTexture {
  const texture = new DataTexture(new Uint8Array(texels), 2, 2);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.repeat.set(6, 3);
  texture.needsUpdate = true;
  return texture;
}

/** Stripes of black and white that are narrower than lines. */
function stripes(): DataTexture {
  const texture = squares([0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255]);
  texture.repeat.set(300, 4);
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  return texture;
}

const colors = (): DataTexture => {
  const texture = squares([220, 60, 40, 255, 40, 90, 200, 255, 240, 230, 200, 255, 60, 140, 70, 255]);
  texture.colorSpace = SRGBColorSpace;
  return texture;
};

/** Surfaces and surroundings that materials of three.js know too. */
export const cases: readonly SceneCase[] = [
  {
    name: 'from within a fog',
    async show(kit) {
      const stage = await drawn(kit);
      stage.scene.fog = new Fog(0x8899aa, 3.4, 4.6);
      return stage;
    },
  },
  {
    name: 'an orthographic camera',
    async show(kit) {
      const stage = await drawn(kit, { screenSpaceShare: 1 });
      const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 20);
      camera.position.set(0.6, 0.3, 4);
      camera.lookAt(0, 0, 0);
      return { ...stage, camera };
    },
  },
  { name: 'half transparent', show: (kit) => drawn(kit, { transparent: true, opacity: 0.5 }) },
  { name: 'paper that lets through', show: (kit) => drawn(kit, { transparent: true, paperOpacity: 0.2 }) },
  {
    name: 'both sides of a tube without ends',
    async show(kit) {
      const stage = await drawn(kit, { side: DoubleSide });
      stage.mesh.geometry = new CylinderGeometry(0.6, 0.9, 1.2, 48, 1, true);
      stage.mesh.rotation.set(1, 0.3, 0);
      return stage;
    },
  },
  { name: 'a map of colours', show: (kit) => drawn(kit, { map: colors(), colorFill: 1, colorHatching: 0.6 }) },
  {
    name: 'planned values of a map',
    show: (kit) => drawn(kit, { map: colors(), composition: { exposure: 'fit' }, colorFill: 0, colorHatching: 0.8 }),
  },
  {
    name: 'details of a map that are finer than lines',
    show: (kit) => drawn(kit, { map: stripes(), composition: { exposure: 'fit' }, colorFill: 0, colorHatching: 0.8 }),
  },
  {
    name: 'holes of an alpha map',
    show: (kit) =>
      drawn(kit, {
        alphaMap: squares([255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255]),
        alphaTest: 0.5,
      }),
  },
  {
    name: 'colours of vertices, and light of its own',
    async show(kit) {
      const stage = await drawn(kit, { vertexColors: true, colorFill: 1, colorHatching: 0.5, emissive: 0x302010 });
      const geometry = new SphereGeometry(0.9, 48, 32);
      const { count } = geometry.attributes.position;
      const values = Float32Array.from({ length: 3 * count }, (_, i) => 0.5 + 0.5 * Math.sin(0.05 * i));
      geometry.setAttribute('color', new BufferAttribute(values, 3));
      stage.mesh.geometry = geometry;
      return stage;
    },
  },
  { name: 'smooth metal', show: (kit) => drawn(kit, { metalness: 1, roughness: 0.5, toneCurve: 'linear' }) },
  {
    name: 'reflected light of a lamp and a sky',
    async show(kit) {
      const stage = await drawn(kit, { reflectedLight: 0.6, toneModel: 'phong', shininess: 20 });
      const lamp = new PointLight(0xffddbb, 12, 6, 1.5);
      lamp.position.set(-1.5, 1, 1.5);
      stage.scene.add(lamp, new HemisphereLight(0xffffff, 0x202020, 0.7));
      return stage;
    },
  },
  {
    name: 'reflected light on planes',
    async show(kit) {
      const stage = await drawn(kit, { reflectedLight: 0.8, toneCurve: 'linear' });
      stage.mesh.geometry = new BoxGeometry(1.2, 1.2, 1.2);
      stage.mesh.rotation.set(0.4, 0.6, 0.2);
      return stage;
    },
  },
  {
    name: 'no light at all',
    async show(kit) {
      const stage = await drawn(kit, { emissive: 0x404040 });
      stage.scene.remove(...stage.scene.children.filter((object) => 'isLight' in object));
      return stage;
    },
  },
  {
    name: 'dots in three layers',
    show: (kit) => drawn(kit, { technique: 'stipple', composition: { exposure: 0.5 } }),
  },
  {
    name: 'ink that takes its colour of the ground too',
    show: (kit) => drawn(kit, { inkBlend: 'multiply', ink: 0x884422, color: 0x88bbee, colorFill: 1 }),
  },
  { name: 'a tone in steps', show: (kit) => drawn(kit, { toneModel: 'toon', toneSteps: 4, toneCurve: 'perceptual' }) },
  {
    name: 'several materials of one mesh',
    async show(kit) {
      const [first, second] = await Promise.all([
        kit.hatching({ ...LINES, ink: 0x882222 }),
        kit.hatching({ ...LINES, direction: 'y', ink: 0x224488, technique: 'woodcut' }),
      ]);
      const stage = knot(first);
      const geometry = new SphereGeometry(0.9, 48, 32);
      geometry.clearGroups();
      geometry.addGroup(0, geometry.index!.count / 2, 0);
      geometry.addGroup(geometry.index!.count / 2, Infinity, 1);
      stage.scene.remove(stage.mesh);
      stage.scene.add(new Mesh<SphereGeometry, Material[]>(geometry, [first, second]));
      return stage;
    },
  },
];
