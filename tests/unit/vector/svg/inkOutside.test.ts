import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  LatheGeometry,
  Mesh,
  SphereGeometry,
  TorusKnotGeometry,
  Vector2,
} from 'three';
import { describe, expect, test } from 'vitest';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import type { PresetName } from '../../../../src/scene/presets.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cases } from '../../../selection.mjs';
import { cameraAt, sceneOf } from '../hatchedScene.js';
import { inkOutside } from '../inkOutside.js';

const SIDE = 90;
/** The greatest share of ink that may lie outside. */
const MOST = 0.001;
/** Outlines lie on both sides of the silhouette, and wobble: their reach, in millimetres at 192 dots per inch. */
const OUTLINE_REACH = 0.55;
/** Lines of surfaces stay inside, to half a pixel of the measurement. */
const LINE_REACH = 0.05;
const MOST_OF_LINES = 0.0001;

const MODELS: Readonly<Record<string, () => BufferGeometry>> = {
  ball: () => new SphereGeometry(1, 12, 8),
  box: () => new BoxGeometry(1.1, 1.1, 1.1),
  cone: () => new ConeGeometry(0.7, 1.5, 24, 1),
  knot: () => new TorusKnotGeometry(0.6, 0.22, 96, 12),
  vase: () =>
    new LatheGeometry(
      [0.5, 0.3, 0.62, 0.45, 0.2, 0.35].map((radius, i) => new Vector2(radius, 0.36 * i - 0.9)),
      20,
    ),
};
const PRESETS: readonly PresetName[] = ['pen', 'crossHatching', 'engraving', 'banknote', 'technical', 'woodcut'];

/** The shares of ink outside: of all layers, and of lines on surfaces. */
async function outside(model: string, preset: PresetName): Promise<{ all: number; lines: number }> {
  const scene = sceneOf(new Mesh(MODELS[model]()));
  await applyHatching(scene, preset);
  const camera = cameraAt(0.6, 0.9, 0.8);
  const { svg } = await drawSVG(scene, camera, { sheet: [SIDE, SIDE], margin: 0, dpi: 192 });
  const share = (layers: RegExp, reach: number) => inkOutside(svg, layers, scene, camera, { side: SIDE, reach });
  return { all: share(/./, OUTLINE_REACH), lines: share(/^(?!outlines)/, LINE_REACH) };
}

describe('no ink of a print lies outside of what is drawn', () => {
  const all = Object.keys(MODELS).flatMap((model) => PRESETS.map((preset) => [model, preset] as const));
  test.each(cases<typeof all>([['ball', 'engraving']], all))(
    'a %s in %s',
    { tags: ['more'] },
    async (model, preset) => {
      const { all, lines } = await outside(model, preset);
      expect(all).toBeLessThan(MOST);
      expect(lines).toBeLessThan(MOST_OF_LINES);
    },
  );
});
