/** Runs one request at a time. A later request replaces the one before, whose signal is aborted. */
export class LatestRequest {
  private controller: AbortController | undefined;

  /** @returns the result, or undefined if the request was replaced. @throws the error of the request, unless it was replaced */
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

  /** Aborts the request, if there is one. */
  drop(): void {
    this.controller?.abort();
    this.controller = undefined;
  }
}
