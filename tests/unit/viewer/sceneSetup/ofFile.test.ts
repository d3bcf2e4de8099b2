import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { FileCamera, FileLight } from '../../../../src/viewer/files/common/ModelExtras.js';
import { lightsOfFile, viewsOfFile } from '../../../../src/viewer/sceneSetup/ofFile.js';
import { cameraOfFile, linkedCamera } from '../../../../src/viewer/sceneSetup/placeCamera.js';
import { lightOf, MAX_VIEWS, readView, writeView } from '../../../../src/viewer/settings/CameraView.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { readLink, writeLink } from '../../../../src/viewer/settings/shareLink.js';

const LIGHT = lightOf(defaultSettings());
const hero: FileCamera = {
  ...{ name: 'hero', position: [0, 0, 5], forwards: [0, 0, -1], up: [0, 1, 0] },
  ...{ high: 0.5, isOrthographic: false, aspect: 2 },
};
const flat: FileCamera = { ...hero, name: 'plan', high: 1.2, isOrthographic: true, aspect: undefined };

describe('a camera of a file', () => {
  test.each([1, 2, 4])('shows all of its picture on a sheet %d times wider than high', (aspect) => {
    const { camera, target } = cameraOfFile(aspect, hero, false);
    expect([camera.position.toArray(), target.toArray()]).toEqual([
      [0, 0, 5],
      [0, 0, 0],
    ]);
    camera.updateMatrixWorld();
    const corner = new Vector3(5, 2.5, 0).project(camera);
    expect(Math.max(corner.x, corner.y)).toBeCloseTo(1);
  });

  test('may have no perspective, also where that is asked for, and may be turned on its side', () => {
    expect(cameraOfFile(1, flat, false).camera).toBeInstanceOf(OrthographicCamera);
    const { camera } = cameraOfFile(1, { ...hero, aspect: 1, up: [1, 0, 0] }, true);
    expect(camera).toBeInstanceOf(OrthographicCamera);
    camera.updateMatrixWorld();
    // What is up in its picture is on the right of the model; it sees 2.5 to each side in the middle.
    const place = new Vector3(2.5, 0, 0).project(camera);
    expect(place.x).toBeCloseTo(0);
    expect(place.y).toBeCloseTo(1);
    expect(cameraOfFile(1, hero, false).camera).toBeInstanceOf(PerspectiveCamera);
  });

  test('becomes a view with its own lens, which links hold to the last digit', () => {
    for (const camera of [hero, { ...flat, up: [0.6, 0.8, 0] } as FileCamera]) {
      const [view] = viewsOfFile([camera], LIGHT, undefined).views;
      expect([view.name, view.light]).toEqual([camera.name, LIGHT]);
      const { isOrthographic, high, aspect = 0, up } = camera;
      expect(view.camera).toEqual({
        position: [0, 0, 5],
        target: [0, 0, 0],
        lens: { isOrthographic, high: Math.fround(high), aspect, up: up.map(Math.fround) },
      });
      expect(readView(writeView(view))).toEqual(view);
      expect(readLink(writeLink(defaultSettings(), view.camera)).camera).toEqual(view.camera);
      const [drawn, linked] = [cameraOfFile(1.5, camera, false), linkedCamera(1.5, view.camera!, false)].map(
        (placed) => {
          placed.camera.updateMatrixWorld();
          return new Vector3(0.3, 0.2, -0.4).project(placed.camera);
        },
      );
      expect(drawn.distanceTo(linked)).toBeLessThan(1e-5);
    }
  });

  test('may be within the model; one that is too far away, or has no lens, is no view', () => {
    const within = viewsOfFile([{ ...hero, position: [0, 0, 0.5] }], LIGHT, undefined).views;
    expect(within[0].camera).toMatchObject({ position: [0, 0, 0.5], target: [0, 0, 0] });
    for (const other of [{ position: [0, 0, 1e4] }, { high: 0 }, { high: 1e9 }, { up: [0, 0, 0] }] as object[]) {
      expect(viewsOfFile([{ ...hero, ...other }], LIGHT, undefined)).toEqual({ views: [], leftOut: 1 });
    }
  });

  test('with a damaged lens in a link is none', () => {
    const link = (lens: string): unknown => readLink(`camera=0,0,5,0,0,0${lens}`).camera;
    expect(link('')).toMatchObject({ position: [0, 0, 5] });
    expect(link(',orthographic,1,0,0,1,0')).toMatchObject({ lens: { isOrthographic: true, high: 1 } });
    for (const lens of [
      ',orthographic',
      ',flat,1,0,0,1,0',
      ',perspective,0,0,0,1,0',
      ',perspective,1,0,0,1',
      ',perspective,1,-1,0,1,0',
    ]) {
      expect(link(lens)).toBeUndefined();
    }
    expect(link(',perspective,1,0,0,1,0,7')).toBeUndefined();
  });

  test('no more views than keys, with the lights of the file and those that suit the view first', () => {
    const found = { ...LIGHT, lightAzimuth: 10 };
    const { views, leftOut } = viewsOfFile(new Array<FileCamera>(20).fill(hero), LIGHT, found);
    expect([views.length, leftOut]).toEqual([MAX_VIEWS, 2 + 20 - MAX_VIEWS]);
    expect(views.slice(0, 3).map(({ name, camera, light }) => [name, camera !== undefined, light])).toEqual([
      ['Lights of the file', false, LIGHT],
      ['Light for the view', false, found],
      ['hero', true, LIGHT],
    ]);
  });
});

describe('lights of a file', () => {
  const sun: FileLight = { kind: 'directional', intensity: 3, position: [9, 9, 9], forwards: [0, -1, 0], angle: 0 };
  const spot: FileLight = { ...sun, kind: 'spot', position: [2, 0, 0], forwards: [-1, 0, 0], angle: Math.PI / 6 };

  test('the brightest in the middle of the model is the light, the next one the second sun', () => {
    const { settings, leftOut } = lightsOfFile([sun, { ...spot, intensity: 8 }, spot])!;
    expect(settings).toMatchObject({ lightKind: 'directional', lightElevation: 89, secondLight: 'free' });
    expect(settings).toMatchObject({ secondAzimuth: 90, secondElevation: 0, secondStrength: 67 });
    expect(leftOut).toBe(1);
  });

  test('a spot keeps its distance and its width, as far as the settings go', () => {
    const { settings, leftOut } = lightsOfFile([{ ...spot, intensity: 90 }, sun])!;
    expect(settings).toMatchObject({ lightKind: 'spot', lightAzimuth: 90, lightDistance: 2, spotAngle: 60 });
    expect([settings.secondLight, leftOut]).toEqual(['free', 0]);
    // A light that sends less than a twentieth of the brightest is left out.
    expect(lightsOfFile([{ ...spot, intensity: 900 }, sun])).toMatchObject({
      settings: { secondLight: 'none' },
      leftOut: 1,
    });
  });

  test('lights that do not shine on it do not count', () => {
    expect(lightsOfFile([])).toBe(undefined);
    expect(lightsOfFile([{ ...spot, forwards: [1, 0, 0] }])).toBe(undefined);
    expect(lightsOfFile([{ ...spot, kind: 'point', position: [0, 0, 0] }])).toBe(undefined);
  });
});
