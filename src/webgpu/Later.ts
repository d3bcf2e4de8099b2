/** Code that is imported when a material first needs it. */
export class Later<Code> {
  /** Undefined until it is loaded. */
  code: Code | undefined;
  private fetching: Promise<void> | undefined;

  /** @param what the task of the code, as a verb phrase. @param without the effect while it is missing, as a clause */
  constructor(
    private readonly what: string,
    private readonly without: string,
    private readonly load: () => Promise<Code>,
  ) {}

  /** Imports the code, once. After a failure the next call tries again. @throws Error that says what could not be fetched */
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

  /** Starts the import without waiting for it. @param whenThere called once it is loaded */
  ask(whenThere?: () => void): void {
    // `fetch` reports its failure itself.
    this.fetch().then(whenThere, () => {});
  }
}
