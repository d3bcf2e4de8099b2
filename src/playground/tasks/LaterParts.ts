import type { Status } from './Status.js';
import { sentenceFor } from './sentenceFor.js';

/**
 * Fetches parts of the page when they are first asked for, because everything that is fetched at once delays the first drawing. The
 * status line shows what could not be fetched.
 */
export class LaterParts {
  private fetching = 0;

  constructor(private readonly status: Status) {}

  /** Whether a part that was asked for is still being fetched. */
  get isFetching(): boolean {
    return this.fetching > 0;
  }

  /** Calls `use` with what is fetched. Shows it in the status line if either fails. */
  whenFetched<Part>(part: Promise<Part>, use: (part: Part) => unknown): void {
    this.fetching++;
    part
      .then(use)
      .catch((error) => this.status.fail(sentenceFor(error)))
      .finally(() => this.fetching--);
  }

  /** @param create fetches the script of the part and creates the part */
  later<Part>(create: () => Promise<Part>): LaterPart<Part> {
    return new LaterPart(this, create);
  }
}

/** A part of the page that is created once, when it is first asked for. */
export class LaterPart<Part> {
  /** The part, once it has been fetched. */
  present: Part | undefined;
  private pending: Promise<Part> | undefined;

  constructor(
    private readonly parts: LaterParts,
    private readonly create: () => Promise<Part>,
  ) {}

  /** The part. Rejects if it cannot be fetched, and fetches it again when it is next asked for. */
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
