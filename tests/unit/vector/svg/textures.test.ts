import {
  BoxGeometry,
  BufferAttribute,
  Color,
  DataTexture,
  InstancedMesh,
  LinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  ObjectSpaceNormalMap,
  PlaneGeometry,
  RepeatWrapping,
  RGBAFormat,
  SphereGeometry,
  SRGBColorSpace,
  Texture,
  Vector3,
} from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { lightness } from '../../../../src/look/vectors.js';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf } from '../paths.js';

// Dashes and order do not matter here, and take time.
const SIDE = 60;
const SHEET = { sheet: [SIDE, SIDE] as const, margin: 0, leastWidth: 0, order: 'drawn' as const };
const draw = (...meshes: Mesh[]) => drawSVG(sceneOf(...meshes), cameraAt(0, 0, 1), SHEET);

/** The plane is 3 wide, of which the camera sees 2.13: boxes in its left and its right half. */
const LEFT = [5, 5, 20, 50] as const;
const RIGHT = [35, 5, 20, 50] as const;
const UPPER = [5, 5, 50, 20] as const;
const LOWER = [5, 35, 50, 20] as const;

/** A texture from pixels row by row from below, grey and alpha from 0 to 255. */
function textureOf(columns: number, pixels: readonly (readonly [grey: number, alpha: number])[]): DataTexture {
  const data = Uint8Array.from(pixels.flatMap(([grey, alpha]) => [grey, grey, grey, alpha]));
  const texture = new DataTexture(data, columns, pixels.length / columns, RGBAFormat);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

const BLACK_AND_WHITE = () =>
  textureOf(2, [
    [0, 255],
    [255, 255],
  ]);

/** A plane with tone 0.2 by its light, darkened by its colour. */
const painted = (material: HatchingMaterialParameters) =>
  planeOfTone(0.2, {
    colorHatching: 0.6,
    composition: { exposure: 1 },
    toneCurve: [
      [0, 0.2],
      [1, 0.9],
    ],
    ...material,
  });

/** The tone of the plane with a colour of that luminance, by its tone with white. */
const darkened = (white: number, luminance: number): number => {
  const share = 0.6 * (1 - lightness(luminance));
  return white + share * (0.9 - white);
};

async function halves(mesh: Mesh): Promise<[left: number, right: number]> {
  const { svg, leftOut } = await draw(mesh);
  expect(leftOut).toEqual([]);
  return [coverageOf(pathsOf(svg), LEFT), coverageOf(pathsOf(svg), RIGHT)];
}

/** The tone of the plane on both sides with white. */
let white = 0;

beforeAll(async () => {
  [white] = await halves(await painted({}));
});

describe('a texture becomes tone', () => {
  test('half black and half white', async () => {
    const [left, right] = await halves(await painted({ map: BLACK_AND_WHITE() }));
    expect(Math.abs(left - darkened(white, 0))).toBeLessThan(0.02);
    expect(Math.abs(right - white)).toBeLessThan(0.02);
  });

  test('a grey by its luminance in linear light, and the same by bytes of linear light', async () => {
    const luminance = ((128 / 255 + 0.055) / 1.055) ** 2.4;
    const [left, right] = await halves(await painted({ map: textureOf(1, [[128, 255]]) }));
    expect(Math.abs(left - darkened(white, luminance))).toBeLessThan(0.02);
    expect(Math.abs(right - left)).toBeLessThan(0.01);
    const linear = textureOf(1, [[Math.round(255 * luminance), 255]]);
    linear.colorSpace = '';
    expect(Math.abs((await halves(await painted({ map: linear })))[0] - left)).toBeLessThan(0.01);
  });

  test('turned upside down, moved and repeated as three.js does', async () => {
    // Half a turn and mirrored repetition swap the halves.
    const moved = BLACK_AND_WHITE();
    moved.wrapS = RepeatWrapping;
    moved.offset.set(0.5, 0);
    const [left, right] = await halves(await painted({ map: moved }));
    expect(left).toBeLessThan(right - 0.15);
    const upright = textureOf(1, [
      [0, 255],
      [255, 255],
    ]);
    const flipped = upright.clone();
    flipped.flipY = true;
    const bottom = async (map: Texture) =>
      coverageOf(pathsOf((await draw(await painted({ map }))).svg), [10, 35, 40, 20]);
    expect(await bottom(upright)).toBeGreaterThan((await bottom(flipped)) + 0.2);
  });

  test.each([true, false])(
    'on a part of a mesh the same as on all of it, with flat shading: %s',
    async (flatShading) => {
      const map = textureOf(1, [
        [0, 255],
        [255, 255],
      ]);
      const [whole, part] = [await painted({ map, flatShading }), await painted({ map, flatShading })];
      const count = (part.geometry.index ?? part.geometry.attributes.position).count;
      part.geometry.clearGroups();
      part.geometry.addGroup(0, count / 2, 0);
      part.geometry.addGroup(count / 2, count / 2, 1);
      const lower = part.material;
      Object.assign(part, { material: [new MeshBasicMaterial({ visible: false }), lower] });
      const [ofWhole, ofPart] = [pathsOf((await draw(whole)).svg), pathsOf((await draw(part)).svg)];
      expect(coverageOf(ofPart, UPPER)).toBe(0);
      expect(coverageOf(ofWhole, LOWER)).toBeGreaterThan(0.4);
      expect(coverageOf(ofPart, LOWER)).toBeCloseTo(coverageOf(ofWhole, LOWER), 2);
    },
  );

  test('stripes of 2 mm come out one by one, and those of 0.05 mm as their mean', { tags: ['all'] }, async () => {
    // 60 mm show 71 of 100 pixels of the texture.
    const stripes = (columns: number): DataTexture =>
      textureOf(
        columns,
        Array.from({ length: columns }, (_, i) => [i % 2 === 0 ? 0 : 255, 255] as const),
      );
    const { svg } = await draw(await painted({ map: stripes(42), direction: 'y' }));
    const tones = Array.from({ length: 20 }, (_, i) => coverageOf(pathsOf(svg), [21 + i, 5, 1, 50]));
    expect(Math.max(...tones) - Math.min(...tones)).toBeGreaterThan(0.2);
    // No line is missing in the middle, where rays run along an axis.
    expect(Math.min(...tones)).toBeGreaterThan(0.5);
    const fine = stripes(2048);
    const [left] = await halves(await painted({ map: fine }));
    const [half] = await halves(await painted({ map: gray(0.5) }));
    expect(Math.abs(left - half)).toBeLessThan(0.02);
  });

  test('a large image that shows a tenth of itself on each triangle', { tags: ['all'] }, async () => {
    const size = 3000;
    const texture = textureOf(
      size,
      Array.from({ length: size }, (_, i) => [i < size / 2 ? 0 : 255, 255] as const),
    );
    texture.magFilter = LinearFilter;
    const [left, right] = await halves(await painted({ map: texture }));
    expect(left).toBeGreaterThan(right + 0.2);
  });

  test('a picture that cannot be read is named', async () => {
    const mesh = await painted({ map: new Texture({ width: 4, height: 4 } as HTMLImageElement) });
    const { leftOut } = await draw(mesh);
    expect(leftOut.map(({ reason }) => reason)).toEqual([
      'The Mesh at Scene/Mesh[1] is drawn without map: pixels that cannot be read here.',
    ]);
  });
});

/** A texture of one luminance. */
function gray(luminance: number): DataTexture {
  const texture = textureOf(1, [[Math.round(255 * luminance), 255]]);
  texture.colorSpace = '';
  return texture;
}

describe('other textures and colours', () => {
  test('an emissive map lightens', async () => {
    const [left, right] = await halves(
      await planeOfTone(0, {
        composition: { exposure: 1 },
        toneCurve: 'linear',
        emissive: 'white',
        emissiveIntensity: 0.4,
        emissiveMap: BLACK_AND_WHITE(),
      }),
    );
    expect(Math.abs(left - right - 0.4)).toBeLessThan(0.02);
  });

  test('light maps and occlusion maps change ambient light', { tags: ['all'] }, async () => {
    const look: HatchingMaterialParameters = { composition: { exposure: 1 }, toneCurve: 'linear' };
    const map = BLACK_AND_WHITE();
    const lit = await planeOfTone(0, { ...look, lightMap: map, lightMapIntensity: 0.3 * Math.PI });
    const [left, right] = await halves(lit);
    expect(Math.abs(left - right - 0.3)).toBeLessThan(0.02);
    const open = await planeOfTone(0, {
      ...look,
      lightMap: gray(1),
      lightMapIntensity: 0.3 * Math.PI,
      aoMap: map,
      aoMapIntensity: 0.5,
    });
    const [less, more] = await halves(open);
    expect(Math.abs(less - more - 0.15)).toBeLessThan(0.02);
  });

  test('colours of vertices, and those of instances', async () => {
    const mesh = await painted({ vertexColors: true });
    const { position } = mesh.geometry.attributes;
    const colors = Float32Array.from({ length: 3 * position.count }, (_, i) =>
      position.getX(Math.floor(i / 3)) < 0 ? 0.1 : 1,
    );
    mesh.geometry.setAttribute('color', new BufferAttribute(colors, 3));
    const [left, right] = await halves(mesh);
    expect(Math.abs(left - darkened(white, 0.1))).toBeLessThan(0.02);
    expect(Math.abs(right - white)).toBeLessThan(0.02);
    const source = await painted({});
    const instances = new InstancedMesh(source.geometry, source.material, 1);
    instances.setMatrixAt(0, new Matrix4());
    instances.setColorAt(0, new Color(0.1, 0.1, 0.1));
    expect(Math.abs((await halves(instances))[1] - darkened(white, 0.1))).toBeLessThan(0.02);
  });
});

describe('a map of normals', () => {
  /** A normal map of one normal. */
  const slanted = (x: number, y: number): DataTexture => {
    const z = Math.sqrt(1 - x * x - y * y);
    const bytes = [x, y, z].map((component) => Math.round(127.5 * (component + 1)));
    const texture = new DataTexture(Uint8Array.from([...bytes, 255]), 1, 1, RGBAFormat);
    texture.needsUpdate = true;
    return texture;
  };
  const plain: HatchingMaterialParameters = {
    composition: { exposure: 1 },
    toneCurve: 'linear',
    highlightThreshold: 0,
  };

  const leanings = [
    [-0.3, 0.5],
    [0, 0],
    [0.4, 0],
    [0, 0.4],
  ];

  test.each(leanings.slice(0, cases(1, 4)))(
    'that leans by (%s, %s) has the tone of what leans so',
    { tags: ['more'] },
    async (x, y) => {
      const [left] = await halves(await planeOfTone(0, { ...plain, normalMap: slanted(x, y) }));
      const toLight = new Vector3(-0.55, 0.75, 0.6).normalize();
      const cosine = Math.max(toLight.dot(new Vector3(x, y, Math.sqrt(1 - x * x - y * y))), 0);
      expect(Math.abs(left - (1 - cosine))).toBeLessThan(0.02);
    },
  );

  test('leans more by its scale, and the way that its coordinates turn', { tags: ['all'] }, async () => {
    const one = await planeOfTone(0, { ...plain, normalMap: slanted(0.4, 0) });
    one.geometry.attributes.uv.applyMatrix4(new Matrix4().makeRotationZ(Math.PI / 2));
    const other = await planeOfTone(0, { ...plain, normalMap: slanted(0, 0.4) });
    // u falls as the plane rises, so a slope along u is a slope downwards.
    expect(
      Math.abs(
        (await halves(one))[0] - (await halves(await planeOfTone(0, { ...plain, normalMap: slanted(0, -0.4) })))[0],
      ),
    ).toBeLessThan(0.02);
    const before = (await halves(other))[0];
    other.material.normalScale.set(1, 0);
    expect(Math.abs((await halves(other))[0] - before)).toBeGreaterThan(0.05);
  });
});

describe('bump maps and object-space normal maps', () => {
  const SMALL = 40;
  const plain: HatchingMaterialParameters = {
    composition: { exposure: 1 },
    toneCurve: 'linear',
    highlightThreshold: 0,
  };
  const toLight = new Vector3(-0.55, 0.75, 0.6).normalize();
  const toneOf = async (material: HatchingMaterialParameters, turn = 0) => {
    const mesh = await planeOfTone(0, { ...plain, ...material });
    mesh.rotation.z = turn;
    const { svg, leftOut } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1, true), {
      ...{ sheet: [SMALL, SMALL], margin: 0, leastWidth: 0, order: 'drawn' },
    });
    expect(leftOut).toEqual([]);
    return coverageOf(pathsOf(svg), [14, 14, 12, 12], 100);
  };

  test.each(cases([0.5], [0.5, -0.3]))(
    'heights that rise by %s of a pixel to a pixel, across the picture',
    { tags: ['more'] },
    async (rise) => {
      // From black at a quarter of the plane to white at three quarters.
      const map = BLACK_AND_WHITE();
      map.colorSpace = '';
      map.magFilter = LinearFilter;
      const pixels = (SMALL / 25.4) * 96;
      const bumpScale = (rise * 0.5 * pixels) / (2.1 / 3);
      const expected = 1 - Math.max(toLight.dot(new Vector3(-rise, 0, 1).normalize()), 0);
      expect(Math.abs((await toneOf({ bumpMap: map, bumpScale })) - expected)).toBeLessThan(0.02);
      // Upwards, since the plane is turned.
      const upwards = 1 - Math.max(toLight.dot(new Vector3(0, -rise, 1).normalize()), 0);
      expect(Math.abs((await toneOf({ bumpMap: map, bumpScale }, Math.PI / 2)) - upwards)).toBeLessThan(0.02);
    },
  );

  test('normals in the space of the object turn with it', async () => {
    const normal = new Vector3(0.4, 0, Math.sqrt(1 - 0.16));
    const bytes = normal.toArray().map((component) => Math.round(127.5 * (component + 1)));
    const normalMap = new DataTexture(Uint8Array.from([...bytes, 255]), 1, 1, RGBAFormat);
    normalMap.needsUpdate = true;
    const map: HatchingMaterialParameters = { normalMap, normalMapType: ObjectSpaceNormalMap };
    expect(Math.abs((await toneOf(map)) - (1 - toLight.dot(normal)))).toBeLessThan(0.02);
    const turned = normal.clone().applyAxisAngle(new Vector3(0, 0, 1), Math.PI / 2);
    expect(Math.abs((await toneOf(map, Math.PI / 2)) - (1 - toLight.dot(turned)))).toBeLessThan(0.02);
  });
});

describe('cut-out surfaces', () => {
  const HOLE = () =>
    textureOf(2, [
      [255, 0],
      [255, 255],
    ]);

  test('have no lines where alpha is too low, up to the edge of it', async () => {
    const mesh = await painted({ map: HOLE(), alphaTest: 0.5, alphaMap: textureOf(1, [[255, 255]]) });
    const { svg, leftOut } = await draw(mesh);
    expect(leftOut).toEqual([]);
    expect(coverageOf(pathsOf(svg), LEFT)).toBe(0);
    expect(coverageOf(pathsOf(svg), RIGHT)).toBeGreaterThan(0.1);
    expect(coverageOf(pathsOf(svg), [20, 5, 9.9, 50])).toBeLessThan(0.002);
    expect(coverageOf(pathsOf(svg), [30.1, 5, 5, 50])).toBeGreaterThan(0.1);
  });

  test('hide nothing there, whatever their material, and cast no shadow', { tags: ['all'] }, async () => {
    const ball = await hatchedMesh(new SphereGeometry(0.9, 32, 24), {
      outlines: false,
      material: { composition: { exposure: 1 } },
    });
    const wall = new Mesh(new PlaneGeometry(3, 3), new MeshBasicMaterial({ map: HOLE(), alphaTest: 0.5 }));
    wall.position.z = 1;
    const { svg } = await draw(ball, wall);
    expect(coverageOf(pathsOf(svg), LEFT)).toBeGreaterThan(0.05);
    expect(coverageOf(pathsOf(svg), RIGHT)).toBe(0);
    const ground = await planeOfTone(0, { toneCurve: 'linear', composition: { exposure: 1 } });
    ground.receiveShadow = true;
    const leaf = new Mesh(
      new BoxGeometry(0.6, 0.6, 0.001),
      new MeshBasicMaterial({ alphaMap: gray(0.4), alphaTest: 0.3 }),
    );
    leaf.position.z = 0.5;
    leaf.castShadow = true;
    const scene = sceneOf(ground, leaf);
    scene.children[0].castShadow = true;
    const inkOf = async () =>
      (await drawSVG(scene, cameraAt(0, 0, 1), { sheet: [24, 24], margin: 0, kind: 'pen', order: 'drawn' })).drawn;
    const withShadow = await inkOf();
    leaf.material.alphaTest = 0.5;
    const without = await inkOf();
    leaf.removeFromParent();
    expect(await inkOf()).toBe(without);
    expect(withShadow).not.toBe(without);
  });

  test('a surface blended by its texture is drawn where alpha is above a half, and listed', async () => {
    const mesh = await painted({ map: HOLE(), transparent: true });
    const { svg, leftOut } = await draw(mesh);
    expect(coverageOf(pathsOf(svg), LEFT)).toBe(0);
    expect(coverageOf(pathsOf(svg), RIGHT)).toBeGreaterThan(0.1);
    expect(leftOut[0].reason).toContain('is drawn opaque where it is more than half there');
  });
});
