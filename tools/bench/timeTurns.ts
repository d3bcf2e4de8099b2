import type { Object3D } from 'three';
import type { Stage } from './Stage.js';

const WARM_UP_TURNS = 2;

/** Milliseconds that a frame of each object takes, one per turn; all objects are drawn in every turn, so that a slow moment slows all of them. */
export async function timeTurns(
  stage: Pick<Stage, 'timeFrame'>,
  objects: Readonly<Record<string, Object3D>>,
  turns: number,
): Promise<Record<string, number[]>> {
  const order = Object.keys(objects);
  const times = Object.fromEntries(order.map((name) => [name, [] as number[]]));
  for (let turn = -WARM_UP_TURNS; turn < turns; turn++) {
    // Every other turn backwards: what is drawn before may make a difference.
    for (const name of turn % 2 === 0 ? order : order.toReversed()) {
      const time = await stage.timeFrame(objects[name]);
      if (turn >= 0) times[name].push(time);
    }
  }
  return times;
}
