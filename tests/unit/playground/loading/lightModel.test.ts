import { ConeGeometry, Group, MathUtils, Mesh, PerspectiveCamera, SphereGeometry, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import { lightModel } from '../../../../src/playground/loading/lightModel.js';
import { type ModelExtras, NO_EXTRAS } from '../../../../src/viewer/files/common/ModelExtras.js';
import type { Look } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings, type Settings } from '../../../../src/viewer/settings/settings.js';

/** A viewport with a ball that its looks turn upright, and a camera that looks at it from the right. */
function createStage(isFramed = true, extras = NO_EXTRAS) {
  const root = new Mesh(new SphereGeometry(1, 48, 32));
  const upright = new Group().add(root);
  const camera = new PerspectiveCamera(30, 1.3);
  camera.position.set(5, 1, 0);
  camera.lookAt(0, 0, 0);
  const applied: Look[] = [];
  const apply = (look: Look): void => {
    applied.push(look);
    upright.rotation.set(...look.upright);
  };
  const framedPoints = root.geometry.attributes.position.array;
  const view = { isFramed, frame: vi.fn(), roomiest: camera, framedPoints };
  const viewport = { model: { root, extras }, camera, apply, view };
  return { viewport, applied, root, light: (settings: Settings) => lightModel(viewport as never, settings) };
}

/** The direction to the light of settings, if it goes with the model. */
const directionOf = ({ lightAzimuth, lightElevation }: Settings): Vector3 =>
  new Vector3().setFromSphericalCoords(1, MathUtils.degToRad(90 - lightElevation), MathUtils.degToRad(lightAzimuth));

test('the settings get a light from the upper front of the view, in steps of their controls, and it is applied and framed', () => {
  const { viewport, applied, light } = createStage();
  const settings = { ...defaultSettings(), lightAzimuth: -170, lightElevation: -60 };
  light(settings);
  const direction = directionOf(settings);
  expect(direction.x).toBeGreaterThan(0.2);
  expect(direction.y).toBeGreaterThan(0.3);
  // To the left of the viewer.
  expect(direction.z).toBeGreaterThan(0.3);
  expect([settings.lightAzimuth, settings.lightElevation].map((angle) => Number(angle.toFixed(1)))).toEqual([
    settings.lightAzimuth,
    settings.lightElevation,
  ]);
  expect(applied.at(-1)?.lights.place).toEqual({ azimuth: settings.lightAzimuth, elevation: settings.lightElevation });
  expect(viewport.view.frame).toHaveBeenCalledTimes(1);
});

test('a model is lit by its file’s lights, turned upright, and the light that suits the view is returned', () => {
  // From in front, before the model is turned upright.
  const sun = { kind: 'directional', intensity: 2, position: [0, 0, 0], forwards: [0, 0, -1], angle: 0 } as const;
  const lamp = { ...sun, kind: 'point', position: [-2, 0, 0], intensity: 4 } as const;
  const { viewport, light } = createStage(true, { ...NO_EXTRAS, lights: [lamp, sun] } as unknown as ModelExtras);
  const settings: Settings = { ...defaultSettings(), upAxis: 'z', lightFollows: 'viewer' };
  const found = light(settings);
  expect([settings.lightKind, settings.secondLight, settings.lightFollows]).toEqual(['directional', 'free', 'model']);
  expect(directionOf(settings).distanceTo(new Vector3(0, 1, 0))).toBeLessThan(0.02);
  expect([settings.secondAzimuth, settings.secondElevation, settings.secondStrength]).toEqual([-90, 0, 50]);
  expect(found?.lightKind).toBe('directional');
  expect(found?.lightElevation).not.toBe(settings.lightElevation);
  expect(viewport.view.frame).toHaveBeenCalledTimes(1);
  expect(createStage().light(defaultSettings())).toBe(undefined);
});

test('a light that follows the viewer gets the same place', () => {
  const withModel = defaultSettings();
  const withViewer: Settings = { ...defaultSettings(), lightFollows: 'viewer', lightKind: 'point', lightDistance: 3 };
  createStage().light(withModel);
  const { viewport, light } = createStage(false);
  light(withViewer);
  const seen = directionOf(withViewer).applyQuaternion(viewport.camera.quaternion);
  expect(seen.distanceTo(directionOf(withModel))).toBeLessThan(0.005);
  expect([withViewer.lightKind, withViewer.lightDistance]).toEqual(['point', 3]);
  // The user has placed the camera.
  expect(viewport.view.frame).not.toHaveBeenCalled();
});

test('the model is lit in its upright position, not in that of its file', () => {
  const lit = (upAxis: Settings['upAxis']): Settings => {
    const { root, light } = createStage();
    root.geometry = new ConeGeometry(0.8, 2, 48) as never;
    const settings = { ...defaultSettings(), upAxis };
    light(settings);
    return settings;
  };
  expect(directionOf(lit('-y')).distanceTo(directionOf(lit('y')))).toBeGreaterThan(0.05);
});
