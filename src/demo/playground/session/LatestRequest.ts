/** Waits for one thing at a time. What is asked for later takes the place of what was, which is told so by its signal. */
export class LatestRequest {
  private controller: AbortController | undefined;

  /** @returns what came; undefined if something else was asked for meanwhile. @throws what went wrong, unless nobody waits for it */
  async run<Result>(task: (signal: AbortSignal) => Promise<Result>): Promise<Result | undefined> {
    this.drop();
    const controller = new AbortController();
    this.controller = controller;
    try {
      const result = await task(controller.signal);
      return controller.signal.aborted ? undefined : result;
    } catch (error) {
      if (controller.signal.aborted) return undefined;
      throw error;
    } finally {
      if (this.controller === controller) this.controller = undefined;
    }
  }

  /** Nobody waits any more. */
  drop(): void {
    this.controller?.abort();
    this.controller = undefined;
  }
}
