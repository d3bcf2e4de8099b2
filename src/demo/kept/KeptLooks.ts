import { acceptLook, type OwnLook } from '../settings/ownLook.js';
import { plainName } from '../settings/plainName.js';

/** A look that the user has given a name. */
export interface KeptLook {
  id: string;
  name: string;
  look: OwnLook;
  /** What was drawn with it when it was kept, as the address of a small image. */
  picture: string | undefined;
}

const STORED = 'three-hatching looks';
/** So many are read, whatever is stored. */
export const MOST_LOOKS = 60;
/** Characters of a thumbnail; ours have a tenth of it. */
const LONGEST_PICTURE = 100_000;

/**
 * The looks that the browser keeps for the page. What it does not keep stays until the page is closed.
 *
 * @param storage of the browser; reading and writing may throw
 */
export class KeptLooks {
  private looks: readonly KeptLook[] = [];
  /** Whether the browser has what is here. */
  private isStored = true;

  constructor(private readonly storage: () => Storage) {
    this.refresh();
  }

  get list(): readonly KeptLook[] {
    return this.looks;
  }

  /** Takes over what another tab has changed. */
  refresh(): void {
    if (!this.isStored) return;
    try {
      this.looks = readLooks(this.storage().getItem(STORED));
    } catch {
      // A browser that keeps nothing has nothing.
    }
  }

  /** Changes them. @returns whether the browser keeps the change */
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

/** Looks from text that anything may have written. What is none is left out. */
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
