/** Changes from one source with shorter pauses than this make one step, as with keys or the wheel. */
const PAUSE_MILLISECONDS = 900;
const KEPT = 100;

/** The history behind Undo and Redo. */
export class EditHistory<State> {
  private readonly past: State[] = [];
  private readonly future: State[] = [];
  private now: State;
  private lastSource: string | undefined;
  private lastTime = -Infinity;
  private lastPress: number | undefined;

  /**
   * @param read returns the present state, as an object that is never changed
   * @param isSame whether two states look the same to the user
   * @param press number of the pointer press in progress; undefined without one
   */
  constructor(
    private readonly read: () => State,
    private readonly isSame: (a: State, b: State) => boolean,
    private readonly press: () => number | undefined = () => undefined,
  ) {
    this.now = read();
  }

  /**
   * Records a change by the user, and clears the redo steps.
   *
   * @param source what was changed. Changes from one source make one step if they come in one press, however long, or in quick succession.
   *   Without a source, the change is a step of its own.
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

  /** Takes the present state over without a step, after a change that is not the user's. */
  adopt(): void {
    this.now = this.read();
    this.lastSource = undefined;
  }

  /** Forgets all steps: the present state becomes the first. */
  clear(): void {
    this.past.length = 0;
    this.future.length = 0;
    this.adopt();
  }

  /** The state before the last change, or undefined if there is none. The caller applies it. */
  undo(): State | undefined {
    return this.step(this.past, this.future);
  }

  /** The state before the last Undo, or undefined if there is none. The caller applies it. */
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
      // A step may lead to the present state, for instance where a model could not be loaded.
      if (this.isSame(next, present)) continue;
      to.push(present);
      this.now = next;
      this.lastSource = undefined;
      return next;
    }
    return undefined;
  }
}
