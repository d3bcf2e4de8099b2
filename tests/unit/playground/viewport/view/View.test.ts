import { BoxGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { View } from '../../../../../src/playground/viewport/View.js';
import { createCamera } from '../../../../../src/viewer/sceneSetup/LensCamera.js';
import type { CameraLens, CameraView } from '../../../../../src/viewer/settings/CameraView.js';
import { defaultSettings } from '../../../../../src/viewer/settings/settings.js';
import { readLink, writeLink } from '../../../../../src/viewer/settings/shareLink.js';

const framedPoints = new BoxGeometry(1.2, 1, 0.8).getAttribute('position').array as Float32Array;

/** A view of a box on an element of no page, which keys turn and move. */
function viewOf(
  shadowOf: (framedPoints: ArrayLike<number>, toEye: Vector3) => ArrayLike<number> | undefined = () => undefined,
) {
  const element = Object.assign(new EventTarget(), {
    style: {},
    getRootNode: () => new EventTarget(),
    ownerDocument: new EventTarget(),
    clientWidth: 800,
    clientHeight: 600,
  });
  const camera = createCamera();
  const view = new View(element as never, camera, () => {}, shadowOf);
  view.resized(4 / 3);
  view.setFramedPoints(framedPoints, [0.62, 0.36, 1]);
  const press = (key: string): void => void element.dispatchEvent(Object.assign(new Event('keydown'), { key }));
  return { view, camera, press };
}

describe('a view that a link brings back', () => {
  test('is identical to the last bit after every kind of movement', () => {
    const { view, camera, press } = viewOf();
    for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp', '+', 'w', 'd', '-', 'ArrowRight', 'ArrowDown', 'a']) {
      press(key);
      const other = viewOf();
      other.view.place = readLink(writeLink(defaultSettings(), view.ownPlace)).camera!;
      expect(other.view.place, key).toEqual(view.place);
      for (const one of [camera, other.camera]) one.updateMatrixWorld();
      expect(other.camera.matrixWorld.elements, key).toEqual(camera.matrixWorld.elements);
    }
    expect(view.isFramed).toBe(false);
  });

  test('is left out only if framing restores it', () => {
    let shadow: number[] | undefined = [3, -0.5, 0, 3, -0.5, 1];
    const { view } = viewOf(() => shadow);
    const framed = view.place;
    expect(view.ownPlace).toBeUndefined();
    // The light is moved: the picture stays, but whoever framed the model now would see another.
    shadow = [-3, -0.5, 0, -3, -0.5, 1];
    expect(view.ownPlace).toEqual(framed);
    expect(view.isFramed).toBe(true);
    view.frame();
    expect(view.ownPlace).toBeUndefined();
    expect(view.place).not.toEqual(framed);
  });
});

describe('a view through the camera of a file', () => {
  const lens: CameraLens = { isOrthographic: true, high: 1.25, aspect: 0, up: [1, 0, 0] };
  // From straight above, where controls alone would turn it.
  const above: CameraView = { position: [0, 50, 0], target: [0, 0, 0], lens };

  test('is exactly the view of the file, at any distance and in links', () => {
    const { view, camera } = viewOf();
    view.place = above;
    expect([view.place, view.isFramed]).toEqual([above, false]);
    expect(readLink(writeLink(defaultSettings(), view.ownPlace)).camera).toEqual(above);
    camera.updateMatrixWorld();
    expect(new Vector3(1.25, 0, 0).project(camera).y).toBeCloseTo(1, 5);
    // On a sheet in the middle it is as large as the sheet.
    view.sheet = [0.5, 0.5];
    expect(new Vector3(1.25, 0, 0).project(camera).y).toBeCloseTo(0.5, 5);
  });

  test('is zoomed by its lens where it has no perspective, and ends where the model is framed', () => {
    const { view, press } = viewOf();
    view.place = above;
    press('+');
    expect(view.place.lens?.high).toBe(Math.fround(1.25 / 1.1));
    expect(view.place.position[1]).toBeCloseTo(50, 3);
    press('-');
    expect(view.place.lens?.high).toBeCloseTo(1.25, 5);
    const { state } = view;
    press('Home');
    expect([view.place.lens, view.isFramed]).toEqual([undefined, true]);
    view.state = state;
    expect(view.state).toEqual(state);
    expect(viewOf().view.framing.first).toEqual(view.framing.first);
  });
});

describe('a view that Undo brings back', () => {
  test('is where it was, and framed if it was, also after the light has moved', () => {
    let shadow = [3, -0.5, 0];
    const { view, press } = viewOf(() => shadow);
    const { state } = view;
    shadow = [-3, -0.5, 0];
    press('ArrowLeft');
    expect(view.isFramed).toBe(false);
    view.state = state;
    expect(view.state).toEqual(state);
    expect(view.isFramed).toBe(true);
  });

  test('is framed anew in a viewport of another shape', () => {
    const { view, camera } = viewOf();
    const { state } = view;
    view.resized(0.5);
    const upright = view.place;
    view.state = state;
    expect(view.state).toEqual({ ...upright, framedFor: '0.5' });
    expect(camera.aspect).toBe(0.5);
  });
});

test('a framed model is composed for the sheet that is shown, and for the viewport again without it', () => {
  const { view, camera, press } = viewOf();
  const before = view.state;
  const distance = () => camera.position.distanceTo(view.controls.target);
  const whole = distance();
  view.sheet = [0.5, 0.9];
  const onSheet = view.state;
  expect(distance()).toBeGreaterThan(1.4 * whole);
  expect(view.ownPlace).toBeUndefined();
  view.sheet = undefined;
  expect(view.state).toEqual(before);
  // Undo goes back to when the sheet was shown, which it is no more.
  view.state = onSheet;
  expect(view.state).toEqual(before);
  press('ArrowLeft');
  const turned = view.place;
  view.sheet = [0.5, 0.9];
  expect(view.place).toEqual(turned);
});

test('a model that is framed while a picture of another shape is drawn is framed again for the viewport', () => {
  const { view, camera } = viewOf();
  const { state } = view;
  camera.aspect = 0.5;
  view.frame();
  expect(view.state).not.toEqual(state);
  view.resized(4 / 3);
  expect(view.state).toEqual(state);
});

describe('a view, after the light has moved', () => {
  /** A framed view of a box whose light was moved since. */
  function litAnew() {
    let shadow = [3, -0.5, 0];
    const made = viewOf(() => shadow);
    shadow = [-3, -0.5, 0];
    return made;
  }

  test('stays in a viewport of the same shape, and is framed with the new shadow in another one', () => {
    const { view, camera, press } = litAnew();
    const { state, framedCount } = view;
    // As after a picture, whose pixels have nearly the same shape.
    camera.aspect = 1.33;
    view.resized(4 / 3);
    expect(camera.aspect).toBe(4 / 3);
    expect([view.state, view.framedCount]).toEqual([state, framedCount]);
    view.resized(2);
    view.resized(4 / 3);
    const framed = view.state;
    expect(framed).not.toEqual(state);
    expect(view.ownPlace).toBeUndefined();
    press('ArrowLeft');
    const turned = view.state;
    for (const aspect of [2, 4 / 3]) view.resized(aspect);
    expect(view.state).toEqual(turned);
  });

  test('stays when a picture was composed for a sheet that is not shown', () => {
    const { view } = litAnew();
    const { state, framedCount } = view;
    const goBack = view.composeFor([0.5, 0.9]);
    expect(view.ownPlace).toBeUndefined();
    expect(view.place.position).not.toEqual(state.position);
    goBack();
    expect([view.state, view.framedCount, view.sheet]).toEqual([state, framedCount, undefined]);
  });

  test('keeps the user’s camera from while a picture was composed', () => {
    const { view, press } = litAnew();
    const goBack = view.composeFor([0.5, 0.9]);
    press('ArrowLeft');
    const turned = view.state;
    goBack();
    expect([view.state, view.sheet]).toEqual([turned, undefined]);
  });
});
