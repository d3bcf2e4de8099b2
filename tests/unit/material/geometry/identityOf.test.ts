import { BoxGeometry, Mesh } from 'three';
import { describe, expect, test } from 'vitest';
import { identityOf } from '../../../../src/material/geometry/identityOf.js';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { pulledVerticesOf } from '../../../../src/material/geometry/pulledVerticesOf.js';
import { reactive } from './reactive.js';

describe('identityOf', () => {
  test('is the same for an object and its proxies, in any order, and differs between objects', () => {
    const [a, b] = [new Mesh(), new Mesh()];
    expect(identityOf(a)).toBe(identityOf(reactive(a)));
    expect(identityOf(reactive(b))).toBe(identityOf(b));
    expect(identityOf(a)).not.toBe(identityOf(b));
    expect(identityOf(a)).toBe(identityOf(a));
  });

  test('does not appear in listings, copies or JSON', () => {
    const thing = { name: 'thing' };
    identityOf(thing);
    expect(Object.keys(thing)).toEqual(['name']);
    expect(JSON.stringify(thing)).toBe('{"name":"thing"}');
    expect(identityOf({ ...thing })).not.toBe(identityOf(thing));
    expect(structuredClone(thing)).toEqual({ name: 'thing' });
  });

  test('of a frozen object is the object itself', () => {
    const frozen = Object.freeze({});
    expect(identityOf(frozen)).toBe(frozen);
  });
});

test('the textures of a geometry are found behind a proxy, and none where there are none', async () => {
  const geometry = await prepareHatchingGeometry(new BoxGeometry(), { layout: 'pull' });
  const vertices = pulledVerticesOf(geometry);
  expect(vertices).toBeDefined();
  expect(pulledVerticesOf(reactive(geometry))).toBe(vertices);
  expect(pulledVerticesOf(reactive(geometry).clone())).toBe(vertices);
  for (const hatching of [undefined, null, 5, 'none', {}]) {
    const other = new BoxGeometry();
    other.userData.hatching = hatching;
    expect(pulledVerticesOf(other)).toBeUndefined();
  }
});
