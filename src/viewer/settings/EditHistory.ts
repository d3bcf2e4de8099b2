/** Changes from one source that follow each other faster than this are one step: by keys or the wheel, say. */
const PAUSE_MILLISECONDS = 900;
const KEPT = 100;

/** Keeps earlier states, for Undo, and those that were undone, for Redo. */
export class EditHistory<State> {
  private readonly past: State[] = [];
  private readonly future: State[] = [];
  private now: State;
  private lastSource: string | undefined;
  private lastTime = -Infinity;
  private lastPress: number | undefined;

  /**
   * @param read returns the present state, as an object that nothing will change
   * @param isSame whether nobody could tell two states from each other
   * @param press which press of a pointer lasts, by a number of its own; undefined if nothing is pressed
   */
  constructor(
    private readonly read: () => State,
    private readonly isSame: (a: State, b: State) => boolean,
    private readonly press: () => number | undefined = () => undefined,
  ) {
    this.now = read();
  }

  /**
   * To be called after the user has changed something. What was undone before is gone then.
   *
   * @param source what was changed. Changes from the same source count as one step: during one press, however long it pauses, or
   *   quick ones without. Without a source, the change is a step of its own.
   */
  changed(source?: string): void {
    const time = performance.now();
    const press = this.press();
    const follows = press === undefined ? time - this.lastTime < PAUSE_MILLISECONDS : press === this.lastPress;
    const continues = source !== undefined && source === this.lastSource && follows;
    this.lastSource = source;
    this.lastTime = time;
    this.lastPress = press;
    if (!continues) {
      this.past.push(this.now);
      if (this.past.length > KEPT) this.past.shift();
    }
    this.future.length = 0;
    this.now = this.read();
  }

  /** To be called after something has changed for a reason that is no step of its own. */
  adopt(): void {
    this.now = this.read();
    this.lastSource = undefined;
  }

  /** Forgets all steps: the present state is the first. */
  clear(): void {
    this.past.length = 0;
    this.future.length = 0;
    this.adopt();
  }

  /** The state before the last change, or undefined if there is none. The caller makes it the present one. */
  undo(): State | undefined {
    return this.step(this.past, this.future);
  }

  /** The state before the last Undo, or undefined if there is none. The caller makes it the present one. */
  redo(): State | undefined {
    return this.step(this.future, this.past);
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  private step(from: State[], to: State[]): State | undefined {
    const present = this.read();
    for (let next = from.pop(); next !== undefined; next = from.pop()) {
      // A model that could not be loaded, say, leaves a step to where the page is already.
      if (this.isSame(next, present)) continue;
      to.push(present);
      this.now = next;
      this.lastSource = undefined;
      return next;
    }
    return undefined;
  }
}
