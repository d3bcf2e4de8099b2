import { Box3, DirectionalLight, type Material, type Mesh, OrthographicCamera, Scene } from 'three';
import { describe, expect, test } from 'vitest';
import { GLASS } from '../../../../src/look/glass.js';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { BOX_CORNERS, BOX_FACES } from '../../../../tools/modelFiles/box.js';
import { addTrack, type GltfBuilder, tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';

type Files = [name: string, content: BlobPart][];

async function build(...files: Files): Promise<HatchedModel> {
  const read = await readModel(
    files.map(([name, content]) => ({ name, content: new Blob([content]) })),
    () => {},
  );
  const { model } = await buildModel(read, () => {}, new AbortController().signal);
  model.apply(lookOf({ ...defaultSettings(), technique: 'engraving', colorHatching: 100, surfaceColors: 'paper' }));
  return model;
}

/** A tetrahedron in a shell of a material, which swings if it is to be drawn in its parts. */
function shell(material: object, isMoving: boolean): GltfBuilder {
  const builder = tetrahedron();
  const { json } = builder;
  json.materials = [{}, { doubleSided: true, ...material }];
  json.meshes.push({ primitives: [{ ...json.meshes[0].primitives[0], material: 1 }] });
  json.nodes.push({ mesh: 1, scale: [2, 2, 2] });
  json.scenes[0].nodes.push(1);
  if (isMoving) {
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(Float32Array.of(0, 0, 0, 0, 0, 1e-3), 'VEC3'));
  }
  return builder;
}

const glb = (material: object, isMoving = false): Files => [
  ['shell.glb', shell(material, isMoving).glb() as Uint8Array<ArrayBuffer>],
];

/** The same in OBJ, with boxes. */
const obj = (mtl: string): Files => [
  [
    'shell.obj',
    [
      'mtllib shell.mtl',
      ...BOX_CORNERS.map((corner) => `v ${corner.join(' ')}`),
      ...BOX_CORNERS.map((corner) => `v ${corner.map((x) => 3 * x - 1).join(' ')}`),
      ...BOX_FACES.map((face) => `f ${face.map((i) => i + 1).join(' ')}`),
      'usemtl shell',
      ...BOX_FACES.map((face) => `f ${face.map((i) => i + 9).join(' ')}`),
    ].join('\n'),
  ],
  ['shell.mtl', `newmtl shell\n${mtl}\n`],
];

const blend = (alpha: number): object => ({
  alphaMode: 'BLEND',
  pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, alpha] },
});

const materialOf = (mesh: Mesh): HatchingMaterial => [mesh.material].flat()[0] as HatchingMaterial;

/** The lines of a drawing from the front, in millimetres, without outlines. */
async function drawnOf(model: HatchedModel): Promise<number> {
  model.show('whole', false);
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.position.z = 5;
  const light = new DirectionalLight('white', 1);
  light.position.set(1, 2, -1);
  const scene = new Scene().add(model.root, light);
  return (await drawSVG(scene, camera, { sheet: [40, 40], margin: 0 })).drawn;
}

/** Shells that are glass, that cannot be seen, and that are opaque. */
const SHELLS: readonly [format: string, glass: Files, nothing: Files, opaque: Files][] = [
  ['glTF', glb(blend(0.25)), glb(blend(0)), glb({})],
  ['glTF in its parts', glb(blend(0.25), true), glb(blend(0), true), glb({}, true)],
  ['glTF that transmits', glb({ extensions: { KHR_materials_transmission: { transmissionFactor: 1 } } }), [], []],
  [
    'glTF whose mask leaves nothing',
    [],
    glb({ ...blend(0.2), alphaMode: 'MASK' }),
    glb({ ...blend(0.6), alphaMode: 'MASK' }),
  ],
  ['OBJ with d', obj('d 0.25'), obj('d 0'), obj('d 1')],
  ['OBJ with Tr', obj('Tr 0.75'), obj('Tr 1'), obj('Tr 0')],
  ['OBJ with both', obj('d -halo 0.25\nTr 0.25'), obj('Tr 0\nd 0.0'), obj('d 1\nTr 1')],
];

const shells = (kind: 1 | 2 | 3): [format: string, files: Files][] =>
  SHELLS.map((shell): [string, Files] => [shell[0], shell[kind]]).filter(([, files]) => files.length > 0);

describe('a shell', () => {
  test.each([...shells(1), ...shells(2)])(
    'in %s carries nothing: the model stands on what is in it',
    async (_format, files) => {
      const { root, bounds } = await build(...files);
      const solid = meshesOf(root).filter((mesh) => mesh.visible && !materialOf(mesh).transparent);
      root.updateMatrixWorld(true);
      const lowest = Math.min(...solid.map((mesh) => new Box3().setFromObject(mesh, true).min.y));
      expect(bounds.min.y).toBeCloseTo(lowest, 6);
      if (meshesOf(root).length > solid.length)
        expect(lowest).toBeGreaterThan(new Box3().setFromObject(root, true).min.y + 0.1);
    },
  );

  test.each(shells(1))(
    'in %s is glass: it lightens what is behind it, and casts and receives no shadow',
    async (_format, files) => {
      const model = await build(...files);
      const meshes = meshesOf(model.root);
      expect(meshes.map(({ castShadow }) => castShadow).sort()).toEqual([false, true]);
      const pane = meshes.find(({ castShadow }) => !castShadow)!;
      expect(pane.receiveShadow).toBe(false);
      expect(materialOf(pane)).toMatchObject({
        transparent: true,
        depthWrite: false,
        paperOpacity: GLASS.paperOpacity,
        opacity: 1,
        occlusion: 0,
      });
      const [one] = meshes.filter((mesh) => mesh !== pane);
      expect(materialOf(one)).toMatchObject({ transparent: false, depthWrite: true, paperOpacity: 1, opacity: 1 });
      const whole = await drawnOf(model);
      pane.visible = false;
      const inside = await drawnOf(model);
      pane.visible = true;
      expect(inside).toBeGreaterThan(50);
      // Its veil leaves out some hairlines.
      expect(whole).toBeGreaterThan(0.85 * inside);
      expect(whole).toBeLessThan(1.5 * inside);
      // A picture whose paper is transparent has no veil of paper.
      model.show('ink');
      expect(materialOf(pane).paperOpacity).toBe(0);
      model.show('whole');
      expect(materialOf(pane).paperOpacity).toBe(GLASS.paperOpacity);
      // A woodcut has no greys.
      model.apply(lookOf({ ...defaultSettings(), technique: 'woodcut' }));
      expect(materialOf(pane).paperOpacity).toBe(0);
      model.dispose();
    },
  );

  test.each(shells(2))(
    'in %s that cannot be seen is not there, and nothing is framed for it',
    async (_format, files) => {
      const model = await build(...files);
      expect(meshesOf(model.root)).toHaveLength(1);
      const reach = model.bounds.max.x - model.bounds.min.x;
      expect(reach).toBeGreaterThan(1.1);
      expect(meshesOf(model.root)[0].castShadow).toBe(true);
      model.dispose();
    },
  );

  test.each(shells(3))('in %s that is opaque stays so', async (_format, files) => {
    const model = await build(...files);
    const materials: Material[] = meshesOf(model.root).map(materialOf);
    expect(materials.every(({ transparent, depthWrite }) => !transparent && depthWrite)).toBe(true);
    model.dispose();
  });
});
