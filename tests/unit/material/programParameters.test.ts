import { describe, expect, it } from 'vitest';
import { isRigid, type ProgramParameters } from '../../../src/material/programDefines.js';

const none = { skinning: false, instancing: false, batching: false, morphTargets: false, morphNormals: false };

describe('isRigid', () => {
  it('holds if vertices move only with their object', () => {
    expect(isRigid(none as ProgramParameters)).toBe(true);
  });

  it.each(Object.keys(none))('does not hold with %s', (name) => {
    expect(isRigid({ ...none, [name]: true } as ProgramParameters)).toBe(false);
  });
});
