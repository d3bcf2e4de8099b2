import { BoxGeometry, Mesh, MeshBasicMaterial } from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { drawsLines } from '../../../src/look/queries.js';
import { type FittedToneCurve, fittedCurve } from '../../../src/material/fitToneCurve.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { HatchingOutlineMaterial } from '../../../src/material/outlines/HatchingOutlineMaterial.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { type PresetName, presets } from '../../../src/scene/presets.js';
import { scalePreset } from '../../../src/scene/scalePreset.js';

const names = Object.keys(presets) as PresetName[];

afterEach(() => vi.restoreAllMocks());

/** The printed tone of a light, as the shader computes it. */
const printedTone = ({ start, spans, cubics }: FittedToneCurve, light: number): number =>
  Array.from({ length: spans.length / 2 }, (_, i) => {
    const t = Math.min(Math.max((light - spans[2 * i]) * spans[2 * i + 1], 0), 1);
    return t * (cubics[3 * i] + t * (cubics[3 * i + 1] + t * cubics[3 * i + 2]));
  }).reduce((sum, rise) => sum + rise, start);

describe('presets', () => {
  test.each(names)('%s sets nothing that its technique or its outlines do not use', (name) => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const { material, outlines } = presets[name];
    const made = new HatchingMaterial(material);
    for (const [property, value] of Object.entries(material)) {
      const got: unknown = made[property as keyof HatchingMaterial];
      if (property === 'ink' || property === 'paper') expect(`#${made[property].getHexString()}`).toBe(value);
      else if (property === 'composition') expect(got).toMatchObject(value as object);
      else expect(got, property).toEqual(value);
    }
    const drawn = new HatchingOutlineMaterial(outlines);
    expect(drawn.outlineWidth).toBe(outlines.outlineWidth);
    expect(`#${drawn.ink.getHexString()}`).toBe(material.ink);
    expect(warn).not.toHaveBeenCalled();
  });

  test.each(names)('%s cannot be changed, at any depth', (name) => {
    const frozen = (value: unknown): boolean =>
      typeof value !== 'object' || value === null || (Object.isFrozen(value) && Object.values(value).every(frozen));
    expect(frozen(presets[name])).toBe(true);
  });

  test.each(names)('%s leaves lights as paper and never prints more than it can', (name) => {
    const { toneCurve = 'linear' } = presets[name].material;
    const fitted = fittedCurve(toneCurve)!;
    const printed = Array.from({ length: 50 }, (_, i) => printedTone(fitted, i / 49));
    // With chalk the strokes are the light, and the paper is the shade.
    const fromPaper = name === 'chalk' ? printed.toReversed() : printed;
    expect(fromPaper[0]).toBeLessThan(0.05);
    for (const [i, tone] of fromPaper.slice(1).entries()) expect(tone - fromPaper[i]).toBeGreaterThan(-1e-6);
  });

  test('applyHatching takes one as it is, draws its map and frees it', async () => {
    const generate = vi.spyOn(TonalArtMap, 'generate');
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const { material, outlines } = presets.chalk;
    const hatched = await applyHatching(mesh, {
      ...presets.chalk,
      tonalArtMap: { style: 'stippling', size: 64, tones: 4 },
      material: { ...material, ink: 'navy' },
    });
    expect(generate.mock.calls[0][0]).toMatchObject({ style: 'stippling', size: 64, tones: 4 });
    const [made] = hatched.materials;
    expect(made.technique).toBe(material.technique);
    expect(made.ink.getHexString()).toBe('000080');
    const map = made.tonalArtMap as TonalArtMap;
    expect(map.size).toBe(64);
    expect(hatched.outlines[0].material.outlineWidth).toBe(outlines.outlineWidth);
    let isFreed = false;
    map.texture.addEventListener('dispose', () => (isFreed = true));
    hatched.dispose();
    expect(isFreed).toBe(true);
  });

  test.each(['engraving', 'stipple', 'woodcut'] as const)('%s needs no map, and has none drawn', async (name) => {
    const generate = vi.spyOn(TonalArtMap, 'generate');
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const { material, outlines } = presets[name];
    (await applyHatching(mesh, { material, outlines })).dispose();
    expect(generate).not.toHaveBeenCalled();
  });

  test.each([
    [{ stile: 'woodcut' }, TypeError, /tonalArtMap: unknown option "stile".*style, seed/],
    [{ style: 'lithograph' }, RangeError, /style is lithograph/],
    ['woodcut', TypeError, /no TonalArtMap/],
  ])('applyHatching refuses the map %j before it does anything', async (tonalArtMap, kind, message) => {
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
    const before = mesh.geometry;
    const error: Error = await applyHatching(mesh, { tonalArtMap: tonalArtMap as never }).catch((thrown) => thrown);
    expect(error).toBeInstanceOf(kind);
    expect(error.message).toMatch(message);
    expect(mesh.geometry).toBe(before);
  });
});

describe('scalePreset', () => {
  test.each(names)('%s grows in every size and in nothing else', (name) => {
    const { material, outlines, tonalArtMap } = presets[name];
    const scaled = scalePreset(presets[name], 2);
    const sizes = ['strokeWidth', 'strokeLength', 'lineSpacing', 'paperGrainSize', 'outlineWidth', 'wobble'];
    for (const [from, to] of [
      [material, scaled.material],
      [outlines, scaled.outlines],
    ] as const) {
      for (const [key, value] of Object.entries(from)) {
        const got = to[key as keyof typeof to] as unknown;
        expect(got, key).toEqual(sizes.includes(key) ? 2 * Number(value) : value);
      }
    }
    expect(drawsLines(material.technique!) ? scaled.material.lineSpacing : scaled.material.strokeWidth).toBeGreaterThan(
      0,
    );
    expect(scaled.outlines.outlineWidth).toBe(2 * outlines.outlineWidth!);
    expect(scaled.tonalArtMap).toBe(tonalArtMap);
  });

  test('spacing on the object is the same at every resolution, and in between as far as it is on the screen', () => {
    const spacingAt = (screenSpaceShare: number | undefined) =>
      scalePreset({ ...presets.engraving, material: { lineSpacing: 5, screenSpaceShare } }, 4).material.lineSpacing;
    expect([spacingAt(1), spacingAt(0.5), spacingAt(0), spacingAt(undefined)]).toEqual([20, 10, 5, 20]);
  });

  test.each([0, -1, Number.NaN, Infinity])('refuses the factor %d', (factor) => {
    expect(() => scalePreset(presets.pen, factor)).toThrow(RangeError);
  });
});
