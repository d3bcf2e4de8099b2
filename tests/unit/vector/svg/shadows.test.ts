import { DirectionalLight, DoubleSide, Mesh, MeshBasicMaterial, PlaneGeometry, Scene, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingShadowMaterialParameters } from '../../../../src/material/groups/shadows.js';
import { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { type DrawSVGOptions, drawSVG } from '../../../../src/vector/svg/index.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, type HatchedLook, hatchedMesh, shadowMesh } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

/** The camera looks down on a ground at z = 0; its picture of 2.1 units fills a sheet of 105 mm. */
const SIZE = 105;
const SHEET = { sheet: [SIZE, SIZE], margin: 0 } as const;
const camera = () => cameraAt(0, 0, 1, true);

const GROUND: HatchingShadowMaterialParameters = {
  toneCurve: 'linear',
  irregularity: 0,
  shadowFade: 0,
  shadowSoftness: 0,
  shadowTone: 0.5,
  screenSpaceShare: 1,
  lineSpacing: 4,
  paperOpacity: 1,
  depthWrite: false,
};

/** A ground that shows shadows alone, lit by a sun that casts them. */
async function groundScene(material: HatchingShadowMaterialParameters, caster: Mesh, radius = 1) {
  const ground = await shadowMesh(new PlaneGeometry(2.4, 2.4, 5, 5), { ...GROUND, ...material });
  ground.receiveShadow = caster.castShadow = true;
  const sun = new DirectionalLight('white', Math.PI);
  sun.position.set(0.9, 0.1, 2.2);
  sun.castShadow = true;
  Object.assign(sun.shadow.camera, { left: -2, right: 2, top: 2, bottom: -2 });
  sun.shadow.radius = radius;
  const scene = new Scene();
  scene.add(ground, caster, sun);
  return { scene, ground, sun };
}

/** An invisible mesh that casts a shadow. */
function unseen(geometry: PlaneGeometry): Mesh {
  return new Mesh(geometry, new MeshBasicMaterial({ depthWrite: false, side: DoubleSide }));
}

/** A plate over the half of the ground with x above 0. */
function plate(height: number): Mesh {
  const mesh = unseen(new PlaneGeometry(1.6, 3));
  mesh.position.set(0.8, 0, height);
  return mesh;
}

/** The cover of strips across a drawing, from left to right, at half of its height. */
async function strips(scene: Scene, options: DrawSVGOptions = {}, count = 70): Promise<number[]> {
  const { svg } = await drawSVG(scene, camera(), { ...SHEET, ...options });
  const paths = pathsOf(svg);
  const width = SIZE / count;
  return Array.from({ length: count }, (_, i) => coverageOf(paths, [i * width, 25, width, 55], 150));
}

const xOf = (strip: number, count = 70) => 1.05 * ((2 * (strip + 0.5)) / count - 1);

/** The distance between where values first exceed one share of their maximum and where they exceed another. */
function riseOf(values: readonly number[], from = 0.1, to = 0.9): number {
  const most = Math.max(...values);
  const placeOf = (share: number): number => {
    const i = values.findIndex((value) => value > share * most);
    return i - (values[i] - share * most) / (values[i] - values[i - 1]);
  };
  return placeOf(to) - placeOf(from);
}

/** The share of a round lamp that the plate hides: the mean of rays to points all over the lamp. */
function shadeOfPlate(x: number, sun: DirectionalLight, height: number, softness: number): number {
  const toLight = sun.position.clone().normalize();
  const side = new Vector3(0, 1, 0).cross(toLight).normalize();
  const up = new Vector3().crossVectors(toLight, side);
  const rays = 2000;
  let hidden = 0;
  for (let j = 0; j < rays; j++) {
    const [r, angle] = [0.5 * softness * Math.sqrt((j + 0.5) / rays), j * Math.PI * (3 - Math.sqrt(5))];
    const ray = toLight
      .clone()
      .addScaledVector(side, r * Math.cos(angle))
      .addScaledVector(up, r * Math.sin(angle));
    const at = x + (height / ray.z) * ray.x;
    if (at > 0 && at < 1.6) hidden++;
  }
  return hidden / rays;
}

describe('the shadow on a ground', () => {
  test.each(cases([0.6], [0.3, 0.6]))(
    'has edges as wide as those of a round lamp, %s above it',
    { tags: ['more'] },
    async (height) => {
      const softness = 0.4;
      const { scene, sun } = await groundScene({ shadowSoftness: softness }, plate(height));
      const drawn = await strips(scene);
      const cast = drawn.map((_, i) => 0.5 * shadeOfPlate(xOf(i), sun, height, softness));
      const ratio = riseOf(drawn) / riseOf(cast);
      expect(ratio).toBeGreaterThan(0.75);
      expect(ratio).toBeLessThan(1.25);
      for (const [i, tone] of drawn.entries()) expect(Math.abs(tone - cast[i])).toBeLessThan(0.06);
    },
  );

  test('is hard with shadows: hard', { tags: ['all'] }, async () => {
    const { scene } = await groundScene({ shadowSoftness: 0.4 }, plate(0.6));
    expect(riseOf(await strips(scene, { shadows: 'hard' }))).toBeLessThan(2);
    expect(riseOf(await strips(scene))).toBeGreaterThan(5);
  });

  test.each(cases([1], [0, 1, 2]))(
    'dissolves evenly with the distance of a leaning board: shadowFade %s',
    { tags: ['more'] },
    async (shadowFade) => {
      // The board stands on the line x = −0.6 and rises at 45°.
      const board = unseen(new PlaneGeometry(1.2 * Math.SQRT2, 3));
      board.rotation.y = -Math.PI / 4;
      board.position.z = 0.6;
      const { scene, sun } = await groundScene({ shadowFade }, board, 0);
      const drawn = await strips(scene);
      const ray = sun.position.clone().normalize();
      let [checked, worst] = [0, 0];
      for (const [i, tone] of drawn.entries()) {
        const distance = (xOf(i) + 0.6) / (ray.z - ray.x);
        if (distance < 0.1 || xOf(i) + distance * ray.x > 0.5) continue;
        const left = Math.max(1 - (shadowFade * distance) / 4, 0);
        checked++;
        worst = Math.max(worst, Math.abs(tone - 0.5 * left));
      }
      expect(checked).toBeGreaterThan(14);
      // Lines end one by one: a strip holds few, and one line more or less matters.
      expect(worst).toBeLessThan(0.04);
    },
  );

  test.each(cases<readonly ('engraving' | 'pen' | 'woodcut')[]>(['engraving'], ['engraving', 'pen', 'woodcut']))(
    'has the right tone at five stages of dissolving, drawn with %s',
    { tags: ['more'] },
    async (technique) => {
      const { scene, ground, sun } = await groundScene(
        { technique, ...(technique !== 'engraving' && { strokeLength: 30 }) },
        plate(0.4),
        0,
      );
      // The distance at which a shadow loses all of its tone at shadowFade 1: the width of the light's camera.
      const share = 0.4 / sun.position.clone().normalize().z / 4;
      for (const left of cases([0.8, 0.2], [0.9, 0.7, 0.5, 0.3, 0.1])) {
        ground.material.shadowFade = (1 - left) / share;
        const { svg } = await drawSVG(scene, camera(), { sheet: [50, 50], margin: 0 });
        const tone = coverageOf(pathsOf(svg), [27, 2, 21, 46], 250);
        expect(Math.abs(tone - 0.5 * left), `${left} is left`).toBeLessThan(0.01 + 0.05 * left);
      }
    },
  );

  test('has lines that run away from the light, at a distance of their own, and none with light ink', async () => {
    const { scene, ground, sun } = await groundScene({ shadowSpacing: 0.8 }, plate(0.3));
    sun.position.set(0.9, 0.9, 2.2);
    const { drawn: near } = await drawSVG(scene, camera(), SHEET);
    ground.material.shadowSpacing = 1.6;
    const { svg, drawn } = await drawSVG(scene, camera(), SHEET);
    expect(near / drawn).toBeCloseTo(2, 1);
    const [x, y] = pathsOf(svg)
      .map((data) => /M[^l]*l(-?[\d.]+)[ ]?(-?[\d.]+)/.exec(data)!.slice(1).map(Number))
      .reduce((sum, [dx, dy]) => [sum[0] + Math.abs(dx), sum[1] + Math.abs(dy)]);
    expect(x / y).toBeCloseTo(1, 1);
    ground.material.toneCurve = [
      [0, 0.95],
      [1, 0],
    ];
    expect((await drawSVG(scene, camera(), SHEET)).paths).toBe(0);
  });
});

test('lines turn only in the shadow of the only light', async () => {
  const { scene, ground, sun } = await groundScene({}, plate(0.2));
  Object.assign(ground, {
    material: new HatchingMaterial({
      ...{ technique: 'engraving', direction: 'light', shadowStrokes: 'reorient', reflectedLight: 0, irregularity: 0 },
      ...{ screenSpaceShare: 1, lineSpacing: 4, transparent: true, depthWrite: false },
      toneCurve: [
        [0, 0.4],
        [1, 0.4],
      ],
    }),
  });
  sun.position.set(0.9, 0.9, 2.2);
  const { svg, leftOut } = await drawSVG(scene, camera(), { ...SHEET, kind: 'pen', penWidth: 0.6, shadows: 'hard' });
  expect(leftOut.filter(({ object }) => object === ground)).toEqual([]);
  let [lit, shaded] = [0, 0];
  for (const [points] of pathsOf(svg).map(ringsOf)) {
    const [x, y, toX, toY] = [points[0], points[1], points[points.length - 2], points[points.length - 1]];
    const length = Math.hypot(toX - x, toY - y);
    if (length < 4) continue;
    // The shadow ends where the ray past the plate's edge meets the ground.
    const edge = (SIZE / 2.1) * (1.05 - (0.2 * 0.9) / 2.2);
    const isLit = (x + toX) / 2 < edge;
    expect(isLit ? Math.max(x, toX) : -Math.min(x, toX)).toBeLessThan(isLit ? edge + 1 : 1 - edge);
    // In the light lines run across it on the ground, in picture coordinates; in shadow across both the light and up.
    const off = isLit ? Math.abs(toX - x - (toY - y)) / Math.SQRT2 : Math.abs(toX - x);
    expect(off / length).toBeLessThan(0.02);
    if (isLit) lit++;
    else shaded++;
  }
  expect(Math.min(lit, shaded)).toBeGreaterThan(12);
});

test('a ground that writes no depth hides nothing, and one that does hides what is below it', async () => {
  const { scene, ground } = await groundScene({}, plate(0.3));
  const below = await hatchedMesh(new PlaneGeometry(1, 1), { material: { direction: 'x' } });
  below.position.z = -0.2;
  scene.add(below);
  const outlines = async () =>
    pathsOf((await drawSVG(scene, camera(), { sheet: [40, 40], margin: 0 })).svg, 'outlines');
  expect((await outlines()).length).toBeGreaterThan(0);
  ground.material.depthWrite = true;
  expect((await outlines()).length).toBe(0);
});

test.each(cases([2], [0, 2, 4]))(
  'edges of shadows on bodies are as wide as the light says, radius %s',
  { tags: ['more'] },
  async (radius) => {
    const { scene, ground, sun } = await groundScene({}, plate(0.4), radius);
    ground.material.toneModel = 'lambert';
    ground.material.direction = 'x';
    sun.shadow.mapSize.setScalar(64);
    // The filter is a tent as wide as its samples plus one texel; on the ground it is wider by the angle of the light.
    const texel = 4 / 64;
    const { x, y, z } = sun.position.clone().normalize();
    const width = (1.106 * (radius + 1) * texel) / (z / Math.hypot(z, x)) / Math.hypot(1, y);
    const drawn = (await strips(scene)).map((tone, _, all) => tone - Math.min(...all));
    const ratio = (riseOf(drawn) * 2.1) / 70 / width;
    expect(ratio).toBeGreaterThan(0.75);
    expect(ratio).toBeLessThan(1.25);
  },
);

describe('lines of a shadow', () => {
  /** The direction of the longest line of a layer, as an angle from 0 to π. */
  function directionOf(svg: string, layer: string): number {
    const steps = pathsOf(svg, layer).map((data) => {
      const [points] = ringsOf(data);
      return [points[points.length - 2] - points[0], points[points.length - 1] - points[1]];
    });
    const [dx, dy] = steps.sort((a, b) => Math.hypot(...b) - Math.hypot(...a))[0];
    return (Math.atan2(dy, dx) + Math.PI) % Math.PI;
  }

  const LOOKS: [string, NonNullable<HatchedLook['material']>][] = [
    ['at 60°, where the first has none', { direction: 'z' }],
    ['at 90°, where the first has none', { direction: 'z', crossAngle: Math.PI / 2 }],
  ];

  test.each(cases(LOOKS.slice(0, 1), LOOKS))(
    'lie across those that cross the first %s',
    { tags: ['more'] },
    async (_, look) => {
      const material = {
        irregularity: 0,
        reflectedLight: 0,
        shadowStrokes: 'cross',
        crossFrom: 0.1,
        screenSpaceShare: 1,
      } as const;
      const wall = await hatchedMesh(new PlaneGeometry(2.4, 2.4, 2, 2), {
        outlines: false,
        material: { ...material, toneCurve: 'linear', composition: { exposure: 0.6 }, lineSpacing: 4, ...look },
      });
      const sun = new DirectionalLight('white', Math.PI);
      sun.position.set(0.9, 0.1, 2.2);
      const caster = plate(0.5);
      wall.receiveShadow = caster.castShadow = sun.castShadow = true;
      // A whole shadow would be solid, with lines of the first family alone.
      sun.shadow.intensity = 0.4;
      const scene = new Scene().add(wall, caster, sun);
      const options = { kind: 'pen', penWidth: 0.2, shadows: 'hard', sheet: [40, 40], margin: 0 } as const;
      const { svg } = await drawSVG(scene, camera(), options);
      const between = Math.abs(directionOf(svg, 'crossing') - directionOf(svg, 'shadows'));
      expect(Math.min(between, Math.PI - between)).toBeGreaterThan(Math.PI / 7);
    },
  );
});
