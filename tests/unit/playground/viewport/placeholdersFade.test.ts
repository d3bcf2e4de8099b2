import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Frames } from '../../../../src/playground/viewport/Frames.js';
import { eventually } from '../../patience.js';

let endFading: () => void;
let isMotionReduced = false;
/** The canvas that lies over the drawing, and what was copied into it. */
let copy: { hidden: boolean; width: number; copied: string[] };

beforeEach(() => {
  isMotionReduced = false;
  vi.stubGlobal('devicePixelRatio', 1);
  vi.stubGlobal('matchMedia', () => ({ matches: isMotionReduced }));
  vi.stubGlobal('requestAnimationFrame', () => 1);
  vi.stubGlobal('document', {
    createElement: () => {
      const copied: string[] = [];
      copy = Object.assign(
        {
          hidden: false,
          width: 0,
          copied,
          setAttribute: () => {},
          getContext: () => ({ drawImage: ({ shows }: { shows: string }) => copied.push(shows) }),
        },
        { animate: () => ({ finished: new Promise<void>((resolve) => (endFading = resolve)) }) },
      );
      return copy;
    },
  });
});

afterEach(() => void vi.unstubAllGlobals());

/** Frames of a viewport, and a way to put another model on it. */
function makeFrames() {
  const shown = { isPlaceholder: false, name: '', disposePrevious: () => {}, model: {} };
  const canvas = { width: 100, height: 100, shows: '', after: () => {} };
  const painter = {
    canvas,
    drawTile: () => {
      canvas.shows = shown.name;
    },
    placeLights: () => {},
  };
  const quality = { measure: (draw: () => void) => draw(), share: 1 };
  const viewport = { clientWidth: 100, clientHeight: 100 };
  const frames = new Frames(painter as never, { shown } as never, quality as never, viewport as never);
  const replace = (name: string, isPlaceholder: boolean): void => {
    if (shown.isPlaceholder) frames.fadeIntoNext();
    Object.assign(shown, { name, isPlaceholder });
    frames.draw();
  };
  return { frames, replace };
}

test('a placeholder fades into the next one, and that into the model', async () => {
  const { frames, replace } = makeFrames();
  replace('first', true);
  expect(copy.hidden).toBe(true);
  replace('other', true);
  expect([copy.hidden, copy.copied.at(-1)]).toEqual([false, 'first']);
  // What is drawn while it fades leaves the fading picture as it is.
  frames.draw();
  expect(copy.copied).not.toContain('other');
  endFading();
  await eventually(() => expect(copy.hidden).toBe(true));
  // No frame was drawn since: the placeholder is drawn once more, to be copied.
  replace('model', false);
  expect([copy.hidden, copy.copied.at(-1)]).toEqual([false, 'other']);
});

test('nothing fades with reduced motion', () => {
  isMotionReduced = true;
  const { replace } = makeFrames();
  replace('first', true);
  replace('other', true);
  expect([copy.hidden, copy.width]).toEqual([true, 0]);
  replace('model', false);
  expect([copy.hidden, copy.width]).toEqual([true, 0]);
});
