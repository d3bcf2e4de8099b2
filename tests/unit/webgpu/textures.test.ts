import { expect, test } from 'vitest';
import { blankFloats, blankIntegers, blankPoses } from '../../../src/webgpu/nodes/base/uniforms.js';

test.each([blankIntegers, blankFloats, blankPoses])(
  'each uniform has a blank of its own, or else three.js 0.186 would take one uniform for several: %o',
  (blank) => {
    const [one, other] = [blank(), blank()];
    expect(one.uuid).not.toBe(other.uuid);
    expect([one.format, one.type]).toEqual([other.format, other.type]);
  },
);
