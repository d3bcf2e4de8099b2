import { Mesh, PlaneGeometry } from 'three';
import { expect, test } from 'vitest';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { bakeOcclusion } from '../../../../src/scene/bakeOcclusion.js';
import { type PresetName, presets } from '../../../../src/scene/presets.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf } from '../paths.js';

/** Deep hollows darken gradually from the tones around them. Lengths in millimetres. */

const SIDE = 120;
const PIXEL = 25.4 / 96;
/** Width and depth of a hollow, on a plate of side 1.1. */
const WIDTH = 0.2;
const DEPTH = 0.4;
/** Reach of the hollow from its middle, on the sheet. */
const REACH = 28;
const BOX = 1.4;
const PRESETS: readonly PresetName[] = [
  'stipple',
  'pen',
  'crossHatching',
  'engraving',
  'banknote',
  'technical',
  'woodcut',
];

/** The ink in rings around the middle of a hollow, from the innermost on, a millimetre apart. */
async function profileOf(preset: PresetName): Promise<number[]> {
  const plate = new PlaneGeometry(1.1, 1.1, 64, 64);
  const { position } = plate.attributes;
  for (let i = 0; i < position.count; i++) {
    const away = (position.getX(i) ** 2 + position.getY(i) ** 2) / WIDTH ** 2;
    position.setZ(i, -DEPTH * Math.exp(-away));
  }
  plate.computeVertexNormals();
  const scene = sceneOf(new Mesh(plate));
  await applyHatching(scene, { ...presets[preset], outlines: false });
  await bakeOcclusion(scene);
  const { svg } = await drawSVG(scene, cameraAt(0, 0, 1, true), { sheet: [SIDE, SIDE], margin: 0 });
  const paths = pathsOf(svg);
  return Array.from({ length: REACH }, (_, ring) => {
    const count = Math.max(8, Math.round((2 * Math.PI * ring) / 3));
    let sum = 0;
    for (let k = 0; k < count; k++) {
      const angle = (2 * Math.PI * (k + 0.5)) / count;
      const [x, y] = [Math.cos(angle), Math.sin(angle)].map((along) => SIDE / 2 + (ring + 0.5) * along - BOX / 2);
      sum += coverageOf(paths, [x, y, BOX, BOX], 10) / count;
    }
    return sum;
  });
}

for (const preset of PRESETS) {
  test(`a deep hollow grows dark over at least six line spacings: ${preset}`, {
    tags: preset === 'stipple' ? [] : ['all'],
  }, async () => {
    const profile = await profileOf(preset);
    const { material } = presets[preset];
    const spacing = PIXEL * (material.lineSpacing ?? 4.4);
    expect(Math.max(...profile)).toBeGreaterThan(0.95);
    // From the middle outwards: where it is no longer nearly black, and where hardly any ink is left.
    const dark = profile.findLastIndex((ink) => ink > 0.9);
    const light = profile.findIndex((ink, ring) => ring > dark && ink < 0.1);
    expect(light).toBeGreaterThan(dark);
    expect((light - dark) / spacing).toBeGreaterThan(6);
    // No hard edge: from one line to the next the ink never falls by a fifth.
    const rings = Math.round(spacing);
    for (let ring = 4; ring + rings < REACH; ring++) {
      const step = ((profile[ring] - profile[ring + rings]) * spacing) / rings;
      expect(step, `at ${ring}`).toBeLessThan(0.2);
    }
  });
}
