import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../../src/look/vectors.js';
import { mirroredRoom, shareOfRoom } from '../../../../src/vector/shading/metal.js';
import { shadedTone, type ToneLook } from '../../../../src/vector/shading/tone.js';

/** A direction in the plane of the eye, by its angle above the horizon in degrees. */
const raised = (degrees: number): Vec3 => [0, Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];

describe('metal', () => {
  test('mirrors light above the horizon, dark below, and a floor that is light again', () => {
    // From level with it, a surface that leans by an angle mirrors what is twice as high.
    const light = (height: number): number => mirroredRoom(raised(height / 2), raised(0));
    for (const height of [4, 20, 60, 90, 150]) expect(light(height), `${height}`).toBe(1);
    for (const height of [-4, -10, -17]) expect(light(height), `${height}`).toBeLessThan(0.1);
    expect(light(-90)).toBeGreaterThan(0.7);
    expect(light(0)).toBeGreaterThan(0.3);
    expect(light(0)).toBeLessThan(0.7);
  });

  test('mirrors what is where the eye is, straight before it', () => {
    expect(mirroredRoom(raised(30), raised(30))).toBe(1);
    expect(mirroredRoom(raised(-10), raised(-10))).toBeLessThan(0.1);
  });

  test('mirrors nothing where it is rough or no metal', () => {
    expect(shareOfRoom({ metalness: 1, roughness: 0.7 })).toBe(0);
    expect(shareOfRoom({ metalness: 0, roughness: 0 })).toBe(0);
    const shares = [0, 0.4, 0.5, 0.6].map((roughness) => shareOfRoom({ metalness: 1, roughness }));
    expect(shares[0]).toBe(shares[1]);
    expect(shares[2]).toBeLessThan(shares[1]);
    expect(shares[3]).toBeLessThan(shares[2]);
    expect(shareOfRoom({ metalness: 0.5, roughness: 0 })).toBeCloseTo(shares[0] / 2, 9);
  });

  const look: ToneLook = {
    ...{ curve: null, steps: 0, exposure: [1, 0], highlightRamp: [0, 1], toneEnds: [0, 1] },
    ...{ occlusion: 1, hollowStrength: 0, openOcclusion: 0, darkness: 0 },
  };

  test('has the tone of the room in place of a share of its shading, and is darker in hollows', () => {
    const tone = (room: number, share: number, occluded = 0): number =>
      shadedTone(0.5, occluded, look, { room, share });
    expect(tone(1, 1)).toBe(0);
    expect(tone(0, 1)).toBe(1);
    expect(tone(0, 0.5)).toBeCloseTo(0.75, 9);
    expect(tone(1, 0)).toBe(shadedTone(0.5, 0, look));
    expect(tone(1, 1, 0.5)).toBeCloseTo(0.5, 9);
  });
});
