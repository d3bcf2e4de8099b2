import { acceptLook, type OwnLook } from '../../viewer/settings/ownLook.js';
import { plainName } from '../../viewer/settings/plainName.js';

/** A look to which the user has given a name. */
export interface KeptLook {
  id: string;
  name: string;
  look: OwnLook;
  /** A thumbnail of the drawing from which the look was kept, as a data URL. */
  picture: string | undefined;
}

const STORED = 'three-hatching looks';
/** How many looks are kept. If more are stored, the rest is ignored. */
export const MOST_LOOKS = 60;
/** The most characters that a stored thumbnail may have. Those that the page makes have about a tenth of that. */
const LONGEST_PICTURE = 100_000;

/**
 * The looks that the browser keeps for the page in its local storage. Where it cannot, they last until the page is closed.
 *
 * @param storage returns the local storage. Calling it, reading and writing may throw.
 */
export class KeptLooks {
  private looks: readonly KeptLook[] = [];
  /** Whether the browser has stored these looks. */
  private isStored = true;

  constructor(private readonly storage: () => Storage) {
    this.refresh();
  }

  get list(): readonly KeptLook[] {
    return this.looks;
  }

  /** Reads the looks again, because another tab may have changed them. */
  refresh(): void {
    if (!this.isStored) return;
    try {
      this.looks = readLooks(this.storage().getItem(STORED));
    } catch {
      // Where nothing can be read, nothing was stored.
    }
  }

  /** Changes the looks. @returns whether the browser has stored the change */
  change(edit: (looks: readonly KeptLook[]) => readonly KeptLook[]): boolean {
    this.refresh();
    this.looks = edit(this.looks);
    try {
      this.storage().setItem(STORED, JSON.stringify(this.looks));
      this.isStored = true;
    } catch {
      this.isStored = false;
    }
    return this.isStored;
  }
}

/** Reads looks from text that may have been written by anything. Entries that are no looks are left out. */
function readLooks(text: string | null): KeptLook[] {
  let stored: unknown;
  try {
    stored = JSON.parse(text ?? '[]');
  } catch {
    return [];
  }
  return Array.isArray(stored) ? stored.slice(0, MOST_LOOKS).flatMap(readLook) : [];
}

function readLook(stored: unknown): KeptLook[] {
  if (!isRecord(stored) || !isRecord(stored.look) || typeof stored.id !== 'string') return [];
  const name = plainName(String(stored.name));
  return name ? [{ id: stored.id, name, look: acceptLook(stored.look), picture: readPicture(stored.picture) }] : [];
}

const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null;

const readPicture = (stored: unknown): string | undefined =>
  typeof stored === 'string' && /^data:image\/(webp|png);/.test(stored) && stored.length <= LONGEST_PICTURE
    ? stored
    : undefined;
