import { describe, expect, it } from 'vitest';
import { TonalArtMap } from '../../../../src/material/tam/TonalArtMap.js';
import { presets, withPreset } from '../../../../src/scene/presets.js';
import { learnHand } from '../../../../src/strokes/hand/learnHand.js';
import { generateHatchImages } from '../../../../src/strokes/tamImages/generateHatchImages.js';
import { finish, requestOf } from '../../strokes/draw.js';
import { drawSwatch } from '../../strokes/hand/drawSwatch.js';

const hand = learnHand(drawSwatch({ rows: 8, taperEnd: 0.4, curvature: 0.06 }));
const size = { size: 64, tones: 4 };

describe('a TonalArtMap of a hand', () => {
  it('is drawn as in the worker, and has drawn thresholds', async () => {
    const map = await TonalArtMap.generate({ hand, ...size });
    const { images } = finish(generateHatchImages(requestOf({ hand, ...size })));
    for (const [tone, row] of images.entries()) expect(map.image(tone, 0)).toEqual(row[0]);
    expect(map.report.consistent).toBe(true);
    expect(map.strokeTexels).toBe(1.9);
    const styled = await TonalArtMap.generate(size);
    expect(map.thresholds(0)).not.toEqual(styled.thresholds(0));
  });

  it('is shared by all who ask for the same hand', async () => {
    const map = TonalArtMap.shared({ hand, ...size });
    expect(TonalArtMap.shared({ ...size, hand: structuredClone(hand) })).toBe(map);
    expect(TonalArtMap.shared(size)).not.toBe(map);
    expect(TonalArtMap.shared({ ...size, hand: { ...hand, mirror: true } })).not.toBe(map);
    await map.ready;
  });

  it('throws at once together with a style, and rejects when its strokes are wrong', async () => {
    expect(() => TonalArtMap.draw({ hand, style: 'ruled' })).toThrow(
      'TonalArtMap.draw: style is ruled, but must be left out beside a hand.',
    );
    await expect(TonalArtMap.generate({ hand: { ...hand, strokes: [] } })).rejects.toThrow(
      'TonalArtMap: hand: there are no strokes; draw at least one.',
    );
    await expect(TonalArtMap.generate({ hand: [] as never })).rejects.toThrow('TonalArtMap: hand is an array');
  });

  it('stops when it is aborted while its strokes are read', async () => {
    const signal = AbortSignal.abort(new Error('stop'));
    await expect(TonalArtMap.generate({ hand, signal })).rejects.toThrow('stop');
  });

  it('is the map of a preset that holds a hand', () => {
    const { tonalArtMap } = withPreset({ ...presets.pen, tonalArtMap: { hand, seed: 3 } });
    expect(tonalArtMap).toEqual({ hand, seed: 3 });
  });
});
