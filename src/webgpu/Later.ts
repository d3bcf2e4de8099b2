/** Code that is fetched when a material first needs it. */
export class Later<Code> {
  /** Undefined until it is there. */
  code: Code | undefined;
  private fetching: Promise<void> | undefined;

  /** @param what it does, as a part of a sentence. @param without what is drawn until it is there, as a part of a sentence */
  constructor(
    private readonly what: string,
    private readonly without: string,
    private readonly load: () => Promise<Code>,
  ) {}

  /** Fetches it, once. If that fails, it says so, and the next call tries again. @throws Error that says what could not be fetched */
  fetch(): Promise<void> {
    this.fetching ??= this.load().then(
      (code) => {
        this.code = code;
      },
      (cause: unknown) => {
        this.fetching = undefined;
        const message = `HatchingNodeMaterial: the code that ${this.what} could not be fetched; ${this.without}. Serve all files of the package; the next frame, or "ready", tries again.`;
        console.error(message);
        throw new Error(message, { cause });
      },
    );
    return this.fetching;
  }

  /** Asks for it, and does not wait. @param whenThere called when it is there */
  ask(whenThere?: () => void): void {
    // The failure is told of where it happens.
    this.fetch().then(whenThere, () => {});
  }
}
