import {
  BackSide,
  type BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Mesh,
  MeshStandardMaterial,
  PCFShadowMap,
  PlaneGeometry,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import { applyHatching, bakeOcclusion, type PresetName } from 'three-hatching';
import { type ApplyNodeHatchingOptions, applyHatching as applyToNodes } from 'three-hatching/webgpu';
import { knot, shadowed } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

/** A knot and a ball on a floor, in three colours. */
function still(): { stage: Stage; root: Group } {
  const stage = shadowed(knot(new MeshStandardMaterial()));
  const root = new Group();
  const add = (geometry: TorusKnotGeometry | SphereGeometry | PlaneGeometry, color: number): Mesh => {
    const mesh = new Mesh(geometry, new MeshStandardMaterial({ color }));
    root.add(mesh);
    return mesh;
  };
  add(new TorusKnotGeometry(0.4, 0.14, 80, 16), 0xcc6633).position.set(-0.35, 0.1, 0);
  add(new SphereGeometry(0.4, 40, 30), 0x4466aa).position.set(0.6, -0.2, 0.2);
  const floor = add(new PlaneGeometry(4, 4), 0xdddddd);
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -0.62;
  stage.scene.remove(stage.mesh);
  stage.scene.add(root);
  return { stage, root };
}

async function hatched(
  { either }: Kit,
  options: ApplyNodeHatchingOptions | PresetName,
  shadows = false,
): Promise<Stage> {
  const { stage, root } = still();
  for (const mesh of root.children) mesh.castShadow = mesh.receiveShadow = shadows;
  await either(
    () => applyHatching(root, options),
    () => applyToNodes(root, options),
  );
  return stage;
}

/** A copy of a geometry whose faces point the other way. */
function insideOut(source: BufferGeometry): BufferGeometry {
  const geometry = source.clone();
  geometry.setIndex(Array.from(source.index!.array).reverse());
  const { array } = geometry.attributes.normal;
  for (let i = 0; i < array.length; i++) array[i] *= -1;
  return geometry;
}

/** Bowls in two rows, seen from inside above and from outside below: drawn from both sides, mirrored too, and from one side. */
function bowls(): { stage: Stage; root: Group } {
  const stage = shadowed(knot(new MeshStandardMaterial()));
  const root = new Group();
  const open = new SphereGeometry(0.27, 32, 20, 0, 2 * Math.PI, 0.5 * Math.PI, 0.5 * Math.PI).rotateX(0.5 * Math.PI);
  for (const [row, y] of [0.35, -0.3].entries()) {
    for (const [column, side] of [DoubleSide, DoubleSide, row === 0 ? BackSide : FrontSide].entries()) {
      // One bowl points inwards.
      const geometry = row === 1 && column === 0 ? insideOut(open) : open.clone();
      const bowl = new Mesh(geometry, new MeshStandardMaterial({ color: 0xdddddd, side }));
      bowl.position.set(0.65 * (column - 1), y, 0);
      bowl.rotation.set(row * Math.PI - 0.3, 0.2, 0);
      if (column === 1) bowl.scale.x = -1;
      root.add(bowl);
    }
  }
  stage.scene.remove(stage.mesh);
  stage.scene.add(root);
  return { stage, root };
}

const LINES = { technique: 'engraving', direction: 'slant', shadowStrokes: 'tone' } as const;

/** Whole scenes, hatched by one call. */
export const cases: readonly SceneCase[] = [
  { name: 'a scene with outlines', show: (kit) => hatched(kit, { material: LINES, outlines: true }) },
  {
    name: 'its colours filled, half of their tone kept, far things fainter',
    show: (kit) =>
      hatched(kit, {
        material: {
          ...LINES,
          colorFill: 1,
          colorHatching: 0.5,
          composition: { depthFade: 0.8 },
          direction: 'towardsLight',
        },
      }),
  },
  {
    name: 'lines along the form',
    show: (kit) => hatched(kit, { material: { ...LINES, direction: 'form', crossFrom: 0.3 } }),
  },
  { name: 'lines across the form', show: (kit) => hatched(kit, { material: { ...LINES, direction: 'acrossForm' } }) },
  { name: 'the preset pen', show: (kit) => hatched(kit, 'pen') },
  { name: 'the preset crossHatching', show: (kit) => hatched(kit, 'crossHatching') },
  { name: 'the preset engraving', show: (kit) => hatched(kit, 'engraving') },
  { name: 'the preset banknote', show: (kit) => hatched(kit, 'banknote') },
  { name: 'the preset technical', show: (kit) => hatched(kit, 'technical') },
  { name: 'the preset woodcut', show: (kit) => hatched(kit, 'woodcut') },
  { name: 'the preset stipple', show: (kit) => hatched(kit, 'stipple') },
  { name: 'the preset pencil', show: (kit) => hatched(kit, 'pencil') },
  { name: 'the preset charcoal', show: (kit) => hatched(kit, 'charcoal') },
  { name: 'the preset chalk', show: (kit) => hatched(kit, 'chalk') },
  {
    name: 'a scene with hollows',
    async show(kit) {
      const stage = await hatched(kit, { material: { ...LINES, occlusion: 0.9, hollowStrength: 0.8 } });
      await bakeOcclusion(stage.scene);
      return stage;
    },
  },
  {
    name: 'bowls with hollows, seen from inside and outside',
    shadows: PCFShadowMap,
    async show({ either }) {
      const { stage, root } = bowls();
      for (const mesh of root.children) mesh.castShadow = mesh.receiveShadow = true;
      const outlines = { weights: { suggestiveContours: 0.5 } };
      const options = { material: { ...LINES, hollowStrength: 0.8 }, outlines };
      await either(
        () => applyHatching(root, options),
        () => applyToNodes(root, options),
      );
      await bakeOcclusion(stage.scene);
      return stage;
    },
  },
  {
    name: 'a scene whose look was changed in place after a part was added and a source painted',
    async show({ either }) {
      const { stage, root } = still();
      const [painted, hidden] = root.children as Mesh<TorusKnotGeometry, MeshStandardMaterial>[];
      const sources = [painted.material, hidden.material];
      const handle: { setPreset(look: ApplyNodeHatchingOptions): Promise<unknown> } = await either(
        () => applyHatching(root, 'technical'),
        () => applyToNodes(root, 'technical'),
      );
      const added = new Mesh(new SphereGeometry(0.25, 30, 20), new MeshStandardMaterial({ color: 0x88aa44 }));
      root.add(added);
      added.position.set(0.1, 0.7, 0);
      await handle.setPreset({ material: { ...LINES, colorFill: 1 }, outlines: true });
      sources[0].color.set(0xaa2255);
      sources[1].visible = false;
      return stage;
    },
  },
  {
    name: 'a scene with shadows',
    shadows: PCFShadowMap,
    show: (kit) => hatched(kit, { material: LINES, outlines: { outlineWidth: 2 } }, true),
  },
];
