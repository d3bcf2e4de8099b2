import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { dataOf } from '../../../../../src/viewer/files/common/ModelFile.js';

/** What the platform makes of a data URI. */
const fetched = async (uri: string) => new Uint8Array(await (await fetch(uri)).arrayBuffer());

describe('a data URI', () => {
  test('in base64 gives its bytes', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 200 }), (bytes) => {
        const read = dataOf(`data:application/octet-stream;base64,${Buffer.from(bytes).toString('base64')}`);
        expect(read).toEqual(new Uint8Array(bytes));
      }),
    );
  });

  test.each([
    'data:,plain%20text',
    'data:text/plain;charset=utf-8,%C3%A4%zz%4',
    'data:text/plain,\u00e4',
    'data:;base64,AAEC/w==',
    'data:;base64,AAEC%2Fw%3D%3D',
    'data:a/b; base64 ,AAEC',
    'data:a/b;name=x,y;base64,AAEC',
  ])('%s gives what fetch gives', async (uri) => {
    expect(dataOf(uri)).toEqual(await fetched(uri));
  });

  test.each(['data:', 'data:;base64', 'data:;base64,!!!!', 'data:;base64,%'])('%s is damaged', (uri) => {
    expect(dataOf(uri)).toBeUndefined();
  });
});
