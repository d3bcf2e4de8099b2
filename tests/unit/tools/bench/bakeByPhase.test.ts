import { BoxGeometry, type BufferGeometry, TorusGeometry } from 'three';
import { expect, test } from 'vitest';
import { bakeByPhase } from '../../../../tools/bench/bake/bakeByPhase.js';
import { bakeCorners, bakeIndexed, bakePull } from '../../../../tools/bench/internals.js';
import { PhaseClock } from '../../../../tools/bench/PhaseClock.js';

function finish<Result>(task: Generator<number, Result, void>): Result {
  for (;;) {
    const step = task.next();
    if (step.done) return step.value;
  }
}

function requestFor({ attributes, index }: BufferGeometry) {
  const mesh = { positions: new Float32Array(attributes.position!.array), indices: new Uint32Array(index!.array) };
  return { label: 'test', mesh, creaseAngle: Math.PI / 2, wantsNormals: false, attributes: [] };
}

test.each([
  ['a torus', new TorusGeometry(1, 0.4, 12, 24)],
  ['a box', new BoxGeometry(1, 1, 1, 3, 3, 3)],
])('the phases that are measured make the same geometry of %s as the bakes', (_, geometry) => {
  const request = requestFor(geometry);
  const clock = new PhaseClock();
  const { corner, pull, indexed } = bakeByPhase(request.mesh, clock.run);
  expect(finish(bakeCorners(request))).toMatchObject(corner);
  expect(finish(bakePull(request))).toMatchObject(pull);
  const { indices, ...rest } = indexed;
  const baked = finish(bakeIndexed(request));
  expect(baked).toMatchObject(rest);
  expect([...baked.indices]).toEqual([...indices]);
  expect(Object.keys(clock.times)).toEqual([
    'check',
    'weld',
    'pair',
    'join',
    'creases',
    'normals',
    'pack corner',
    'pack pull',
    'pack indexed',
  ]);
});
