import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Frames } from '../../../../src/playground/viewport/Frames.js';

/** What was asked of the page's next frame. */
let frames: (() => void)[] = [];

beforeEach(() => {
  frames = [];
  vi.useFakeTimers();
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => frames.push(draw));
  vi.stubGlobal('devicePixelRatio', 1);
  vi.stubGlobal('matchMedia', () => ({ matches: false }));
  vi.stubGlobal('document', { createElement: () => copy });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const drawImage = vi.fn();
const animate = vi.fn(() => ({ finished: new Promise<void>(() => {}) }));
const copy = { getContext: () => ({ drawImage }), setAttribute: () => {}, hidden: true, width: 0, height: 0, animate };

/** Frames of a sheet with a model, how often pictures were drawn, and whether each was of a movement. */
function makeFrames() {
  for (const mock of [drawImage, animate]) mock.mockClear();
  copy.hidden = true;
  const drawTile = vi.fn();
  const moving: boolean[] = [];
  const quality = {
    measure(draw: () => void, isMoving: boolean): void {
      moving.push(isMoving);
      draw();
    },
    isSketch: false,
    isBusy: false,
    isCoarse: false,
    share: 1,
    finishSketch: () => {},
    drawnUnmeasured: () => {},
  };
  const drawing = { after: () => {}, width: 100, height: 100 };
  const painter = {
    canvas: drawing,
    drawTile,
    placeLights: vi.fn(),
    release: () => {},
    isBuilding: false,
    isLost: false,
  };
  const scenery = { shown: { model: {}, isPlaceholder: false, disposePrevious: () => {} }, showSketch: vi.fn() };
  const sheet = new Frames(
    painter as never,
    scenery as never,
    quality as never,
    { clientWidth: 100, clientHeight: 100 } as never,
  );
  vi.runAllTimers();
  drawImage.mockClear();
  const next = (): void => {
    for (const draw of frames.splice(0)) draw();
  };
  return { sheet, scenery, quality, painter, drawTile, moving, next };
}

test('a picture that is to fade is drawn a second time, unless it was copied because that was known before', () => {
  const { sheet, drawTile, next } = makeFrames();
  sheet.refine();
  next();
  sheet.fadeIntoNext();
  expect([drawTile.mock.calls.length, drawImage.mock.calls.length]).toEqual([2, 1]);
  sheet.refine();
  next();
  expect([drawTile.mock.calls.length, animate.mock.calls.length]).toEqual([3, 1]);

  const known = makeFrames();
  known.sheet.keepPictures();
  known.sheet.refine();
  known.next();
  expect([known.drawTile.mock.calls.length, drawImage.mock.calls.length, animate.mock.calls.length]).toEqual([1, 1, 0]);
  known.sheet.fadeIntoNext();
  known.sheet.leavePictures();
  known.sheet.refine();
  known.next();
  expect([known.drawTile.mock.calls.length, drawImage.mock.calls.length, animate.mock.calls.length]).toEqual([2, 1, 1]);
});

test('a picture that was copied for nothing does not fade into a later one', () => {
  const { sheet, next } = makeFrames();
  sheet.keepPictures();
  sheet.refine();
  next();
  sheet.leavePictures();
  sheet.refine();
  next();
  expect([drawImage.mock.calls.length, animate.mock.calls.length]).toEqual([1, 0]);
});

test('a frame that only adds detail is not part of a movement', () => {
  const { sheet, moving, next } = makeFrames();
  sheet.refine();
  next();
  sheet.refine();
  sheet.invalidate();
  next();
  sheet.refine();
  next();
  expect(moving).toEqual([false, true, false]);
});

test('while a screen compiles programs, frames are pending and not drawn', () => {
  const { sheet, next } = makeFrames();
  const screen = {
    canvas: { hidden: true },
    canDraw: true,
    isBuilding: true,
    prepare: () => true,
    draw: vi.fn(() => {
      screen.isBuilding = true;
    }),
    dispose: () => {},
  };
  const ask = (): number => {
    sheet.refine();
    next();
    return screen.draw.mock.calls.length;
  };
  sheet.drawOn(screen as never);
  expect([ask(), sheet.isWaiting]).toEqual([0, true]);
  screen.isBuilding = false;
  expect([ask(), sheet.isWaiting]).toEqual([1, true]);
  expect(ask()).toBe(1);
  screen.isBuilding = false;
  expect(sheet.isWaiting).toBe(false);
});

test('before there is a model, no ground is drawn', () => {
  const { sheet, scenery, next } = makeFrames();
  sheet.refine();
  next();
  expect(scenery.showSketch).not.toHaveBeenCalled();
  Object.assign(scenery.shown, { model: undefined });
  sheet.refine();
  next();
  expect(scenery.showSketch).toHaveBeenCalledTimes(1);
});

test('a frame waits for a slow one on the graphics card, and is drawn without another request', () => {
  const { sheet, quality, painter, drawTile, next } = makeFrames();
  const onWait = vi.fn();
  sheet.onWait(onWait);
  quality.isBusy = true;
  sheet.invalidate();
  for (let i = 0; i < 3; i++) next();
  // The handles of lights go on to follow the pointer.
  expect([onWait.mock.calls.length, painter.placeLights.mock.calls.length]).toEqual([3, 3]);
  expect([drawTile.mock.calls.length, sheet.isWaiting, sheet.count]).toEqual([0, true, 0]);
  quality.isBusy = false;
  next();
  expect([drawTile.mock.calls.length, sheet.isWaiting, sheet.count]).toEqual([1, false, 1]);
});

test('the picture is final once no frame is pending, being drawn or coarse, and nothing fades', async () => {
  const { sheet, quality, painter, next } = makeFrames();
  expect(sheet.isSettled).toBe(true);
  sheet.refine();
  expect(sheet.isSettled).toBe(false);
  next();
  expect(sheet.isSettled).toBe(true);
  for (const [part, state] of [
    [quality, 'isBusy'],
    [quality, 'isCoarse'],
    [quality, 'isSketch'],
    [painter, 'isBuilding'],
  ] as const) {
    Object.assign(part, { [state]: true });
    expect(sheet.isSettled, state).toBe(false);
    Object.assign(part, { [state]: false });
  }
  let end = (): void => {};
  const finished = new Promise<void>((resolve) => {
    end = resolve;
  });
  animate.mockReturnValueOnce({ finished });
  sheet.fadeIntoNext();
  sheet.refine();
  next();
  expect(sheet.isSettled).toBe(false);
  end();
  await finished;
  expect(sheet.isSettled).toBe(true);
});

test('nothing moves while a picture is drawn in tiles, though the graphics card is busy', () => {
  const { sheet, quality, painter, drawTile, next } = makeFrames();
  quality.isBusy = true;
  sheet.isHeld = true;
  sheet.invalidate();
  next();
  expect([painter.placeLights.mock.calls.length, drawTile.mock.calls.length]).toEqual([0, 0]);
});
