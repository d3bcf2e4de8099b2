import type { Status } from './Status.js';
import { sentenceFor } from './Status.js';

/**
 * Loads parts of the page on demand, because everything loaded at the start delays the first drawing. Failures are shown in the status
 * line.
 */
export class LaterParts {
  private fetching = 0;

  constructor(private readonly status: Status) {}

  /** Whether a requested part is still loading. */
  get isFetching(): boolean {
    return this.fetching > 0;
  }

  /** Calls `use` with the loaded part. Reports in the status line if either fails. */
  whenFetched<Part>(part: Promise<Part>, use: (part: Part) => unknown): void {
    this.fetching++;
    part
      .then(use)
      .catch((error) => this.status.fail(sentenceFor(error)))
      .finally(() => this.fetching--);
  }

  /** @param create imports the script of the part and creates the part */
  later<Part>(create: () => Promise<Part>): LaterPart<Part> {
    return new LaterPart(this, create);
  }
}

/** A part of the page that is created once, on demand. */
export class LaterPart<Part> {
  /** The part, once it is loaded. */
  present: Part | undefined;
  private pending: Promise<Part> | undefined;

  constructor(
    private readonly parts: LaterParts,
    private readonly create: () => Promise<Part>,
  ) {}

  /** Loads the part. Rejects if that fails, and tries again at the next call. */
  fetch(): Promise<Part> {
    this.pending ??= this.create().then(
      (part) => {
        this.present = part;
        return part;
      },
      (error) => {
        this.pending = undefined;
        throw error;
      },
    );
    return this.pending;
  }

  /** Calls `use` with the part, as {@link LaterParts.whenFetched} does. */
  use(use: (part: Part) => unknown): void {
    this.parts.whenFetched(this.fetch(), use);
  }
}
