import { existsSync } from 'node:fs';
import draco from 'draco3d';
import { Group, MathUtils, Vector3 } from 'three';
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { lightModel } from '../../../../src/playground/loading/lightModel.js';
import { BUILT_IN_MODELS, type BuiltInModel } from '../../../../src/playground/models/models.js';
import { View } from '../../../../src/playground/viewport/View.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { NO_EXTRAS } from '../../../../src/viewer/files/common/ModelExtras.js';
import { shadowOnGround } from '../../../../src/viewer/sceneSetup/groundShadow.js';
import { createCamera, DEFAULT_VIEW } from '../../../../src/viewer/sceneSetup/LensCamera.js';
import { GALLERY } from '../../../../src/viewer/settings/gallery.js';
import { type Look, lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { readLink } from '../../../../src/viewer/settings/shareLink.js';
import { cases } from '../../../selection.mjs';
import { builtInModel, SHARED, serveFiles, sharedModel } from './subjects.js';

/** The sheets of windows of 1440 × 900, 1024 × 768 and 390 × 844 pixels: what neither panel nor caption covers. */
const SHEETS = { wide: [998, 810], middle: [582, 662], phone: [374, 722] } as const;

/** The models of the page. The dragon is the same shape in each of its resolutions. */
const OWN: BuiltInModel[] = [
  ...['dragon4', 'bust', 'hand', 'shell', 'vase', 'column', 'gears', 'landscape', 'knot', 'bunny', 'suzanne'],
  ...['teapot', 'fish', 'cube', 'sphere'],
] as BuiltInModel[];
const SHARED_FILES = [
  ['CesiumMan.glb'],
  ['Fox.glb'],
  ['Lantern.gltf', 'Lantern.bin'],
  ['hand_lowres.obj'],
  ['nefertiti_lowres.obj'],
  ['spot.obj'],
  ['MorphStressTest.gltf'],
];

/** In Node, the decoder comes from a package, not from an address. */
vi.mock('../../../../src/playground/reading/loadDraco.js', () => ({ loadDraco: () => draco.createDecoderModule({}) }));
beforeAll(serveFiles);

type Direction = readonly [number, number, number];

/** A model on the page: how it is framed with a light. */
function framed(model: HatchedModel, first: Direction, turn: number, [width, height]: readonly [number, number]) {
  const holder = new Group().add(model.root);
  holder.rotation.y = MathUtils.degToRad(turn);
  holder.updateMatrixWorld(true);
  const framedPoints = model.framedPoints.slice();
  const point = new Vector3();
  let ground = Infinity;
  for (let i = 0; i < framedPoints.length; i += 3) {
    point.fromArray(framedPoints, i).applyMatrix4(holder.matrix).toArray(framedPoints, i);
    ground = Math.min(ground, point.y);
  }
  const light = new Vector3();
  const shadow = (): number[] => shadowOnGround(framedPoints, light, true, ground);
  const element = Object.assign(new EventTarget(), {
    style: {},
    getRootNode: () => new EventTarget(),
    ownerDocument: new EventTarget(),
    clientWidth: width,
    clientHeight: height,
  });
  const camera = createCamera();
  const view = new View(element as never, camera, () => {}, shadow);
  const apply = ({ lights: { place } }: Look): void => {
    light.setFromSphericalCoords(1, MathUtils.degToRad(90 - place.elevation), MathUtils.degToRad(place.azimuth));
  };
  view.resized(width / height);
  view.setFramedPoints(framedPoints, first);
  const viewport = { model: { root: holder, extras: NO_EXTRAS }, camera, view, apply };
  return { viewport, camera, place: () => placeOf(camera, framedPoints, shadow()), light };
}

/** Where the subject and its shadow are: shares of the sheet. */
function placeOf(camera: ReturnType<typeof createCamera>, framedPoints: Float32Array, shadow: number[]) {
  camera.updateMatrixWorld();
  const subject = reachOf(camera, framedPoints);
  return {
    /** The distance of the subject's middle from that of the sheet. */
    aside: Math.abs(subject.right + subject.left) / 4,
    width: (subject.right - subject.left) / 2,
    height: (subject.top - subject.bottom) / 2,
    /** How far the shadow reaches from the middle of the sheet: 1 at its edge. */
    shadow: Math.max(...Object.values(reachOf(camera, shadow)).map(Math.abs)),
  };
}

function reachOf(camera: ReturnType<typeof createCamera>, xyz: ArrayLike<number>) {
  const reach = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  const point = new Vector3();
  for (let i = 0; i < xyz.length; i += 3) {
    const { x, y } = point.set(xyz[i], xyz[i + 1], xyz[i + 2]).project(camera);
    reach.left = Math.min(reach.left, x);
    reach.right = Math.max(reach.right, x);
    reach.bottom = Math.min(reach.bottom, y);
    reach.top = Math.max(reach.top, y);
  }
  return reach;
}

type Placement = ReturnType<typeof placeOf>;

function expectWellPlaced({ aside, shadow, width, height }: Placement, sheet: string, what: string): void {
  // On a narrow sheet a subject makes room for the whole of its shadow.
  expect(aside, `${what}: aside`).toBeLessThan(sheet === 'phone' ? 0.09 : 0.06);
  expect(shadow, `${what}: shadow`).toBeLessThan(1);
  if (sheet !== 'phone') return;
  expect(width, `${what}: width`).toBeGreaterThan(0.55);
  expect(height, `${what}: height`).toBeGreaterThan(0.4);
}

/** Lights a model as one that is opened, in every sheet, whole and turned by 90°. */
function expectWellPlacedAnywhere(model: HatchedModel, first: Direction): void {
  for (const [sheet, size] of Object.entries(SHEETS)) {
    for (const turn of [0, 90]) {
      const whole = framed(model, first, turn, size);
      lightModel(whole.viewport as never, { ...defaultSettings(), shadows: 'on', ground: 'shadow' });
      expectWellPlaced(whole.place(), sheet, `${sheet}, turned by ${turn}°`);
      const { x, y, z } = whole.light.clone().transformDirection(whole.camera.matrixWorldInverse);
      expect(z, 'from the front').toBeGreaterThan(0.1);
      expect(y, 'from above').toBeGreaterThan(0.2);
      expect(Math.abs(x), 'from aside').toBeGreaterThan(0.1);
    }
  }
}

/** The cases of a list, a third of them in `npm test`. */
const thirdOf = <Case>(all: readonly Case[]): readonly Case[] =>
  cases(
    all.filter((_, i) => i % 3 === 0),
    all,
  );

describe('a model that is opened stands in the middle, with its shadow on the sheet', () => {
  test.each(thirdOf(OWN))('%s', { tags: ['more'] }, async (name) => {
    expectWellPlacedAnywhere(await builtInModel(name), BUILT_IN_MODELS[name].view ?? DEFAULT_VIEW);
  });

  test.skipIf(!existsSync(SHARED)).each(SHARED_FILES)('%s', async (...names) => {
    expectWellPlacedAnywhere(await sharedModel(...names), DEFAULT_VIEW);
  });
});

describe('a drawing of the gallery stands in the middle, with its shadow on the sheet and the light in front', () => {
  test.each(thirdOf(GALLERY))('$name', { tags: ['more'] }, async ({ link }) => {
    const { settings } = readLink(link);
    const name = (settings.model === 'dragon3' ? 'dragon4' : settings.model) as BuiltInModel;
    const model = await builtInModel(name);
    const castsShadow = settings.shadows === 'on' && settings.ground !== 'none';
    for (const [sheet, size] of Object.entries(SHEETS)) {
      const { viewport, place, light, camera } = framed(model, BUILT_IN_MODELS[name].view ?? DEFAULT_VIEW, 0, size);
      viewport.apply(lookOf(settings));
      if (castsShadow) viewport.view.frame();
      const { shadow, ...subject } = place();
      expectWellPlaced({ shadow: castsShadow ? shadow : 0, ...subject }, sheet, sheet);
      expect(light.clone().transformDirection(camera.matrixWorldInverse).z).toBeGreaterThan(0.1);
    }
  });
});
