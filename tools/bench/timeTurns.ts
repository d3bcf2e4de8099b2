const WARM_UP_TURNS = 2;

/** Milliseconds that a frame of each object takes, one per turn; all objects are drawn in every turn, so that a slow moment slows all of them. */
export async function timeTurns<Drawn>(
  stage: { timeFrame(drawn: Drawn): Promise<number> },
  objects: Readonly<Record<string, Drawn>>,
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
