import { describe, expect, test } from 'vitest';
import { chooseParts } from '../../../../src/command/draw/chooseParts.js';
import { octahedronObj } from '../../../../tools/modelFiles/modelFiles.js';
import { draw, refusal, SMALL, useWorkFolder } from './drawing.js';

useWorkFolder();

const NAMES = ['Body', 'Wheel', 'Wheel 2', 'Door (left)', 'Lamp'];
const choose = (hide: string[], only: string[] = [], linked: number[] = []): number[] =>
  chooseParts(NAMES, { hide, only }, linked, 'car.obj');

describe('parts by name', () => {
  test.each([
    [['Wheel'], [], [1]],
    [[' lamp ', 'BODY'], [], [0, 4]],
    [['wheel*'], [], [1, 2]],
    [['*(left)'], [], [3]],
    [[], ['Wheel'], [0, 2, 3, 4]],
    [['Wheel 2'], ['*e*'], [0, 2, 4]],
  ])('--hide %j --only %j hide %j', (hide, only, hidden) => {
    expect(choose(hide, only)).toEqual(hidden);
  });

  test('those that a link hides stay hidden, unless the only ones are named', () => {
    expect(choose([], [], [0, 9])).toEqual([0]);
    expect(choose(['Lamp'], [], [0])).toEqual([0, 4]);
    expect(choose([], ['Body'], [0])).toEqual([1, 2, 3, 4]);
  });

  test.each([
    ['Whel', 'Wheel, Wheel 2, Body'],
    ['door', 'Door (left), Body, Lamp'],
    ['x*', 'Body, Lamp, Wheel'],
  ])('an unknown name, %s, offers the nearest', (name, offered) => {
    expect(() => choose([name])).toThrow(`car.obj has no part ${name}; the nearest names are ${offered}.`);
    expect(() => choose([], [name])).toThrow('the nearest names are');
  });
});

const [head, ...faces] = octahedronObj.split(/^(?=f )/m);
const halves = [head, 'o Low\n', ...faces.slice(0, 4), '\no High\n', ...faces.slice(4)]
  .join('')
  .replace(/^mtllib.*$/m, '');

describe('a drawing', () => {
  test('has the parts that are asked for, where they are in the whole', async () => {
    const link = ['--link', 'preset=engraving', '--view', '31.8 17'];
    const [whole, low, high, same] = await Promise.all([
      draw('a.obj', halves, ...SMALL, ...link),
      draw('b.obj', halves, ...SMALL, ...link, '--only', 'low'),
      draw('c.obj', halves, ...SMALL, ...link, '--hide', 'Low'),
      draw('d.obj', halves, ...SMALL, '--link', 'preset=engraving&hidden=1', '--view', '31.8 17'),
    ]);
    expect(low.svgs[0]).not.toBe(high.svgs[0]);
    expect(Math.max(low.drawn[0], high.drawn[0])).toBeLessThan(whole.drawn[0]);
    expect(same.svgs).toEqual(high.svgs);
  });

  test('of a model of one part has nothing to choose from', async () => {
    expect(await refusal('a.obj', octahedronObj.replace(/^usemtl.*$/gm, ''), '--hide', 'Low')).toBe(
      'a.obj has only one part, so --hide and --only have nothing to choose from.',
    );
    expect(await refusal('b.obj', halves, '--hide', 'Lo')).toBe(
      'b.obj has no part Lo; the nearest names are Low, High.',
    );
  });
});
