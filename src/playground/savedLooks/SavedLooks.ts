import { plainName } from '../../viewer/settings/CameraView.js';
import { acceptLook, hasLook, type OwnLook } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { findElement } from '../page/elements.js';
import { newId } from '../session/DrawingStore.js';
import { thumbnailOf } from '../session/KeptPicture.js';
import type { Viewport } from '../viewport/Viewport.js';
import { type BarItems, type ListWords, NamedBar, NamedListDialog } from './NamedListDialog.js';
import { freeName, type NamedItem, type NamedList, type SavedViews } from './SavedViews.js';

const WORDS = {
  looks: {
    title: 'Looks of your own',
    about:
      'A look is how things are drawn: strokes, lines, tone, colours, shadows. This browser keeps it, beside the presets.',
    add: 'Keep this look',
    full: 'There is no room for more: delete one first.',
  },
  views: {
    title: 'Views of this drawing',
    about: 'A view is a camera and the lights. Views belong to the drawing, and a link to it brings them along.',
    add: 'Keep this view',
    full: 'Each of the keys 1 to 9 has a view: delete one first.',
  },
} as const satisfies Record<string, ListWords>;

/** The user's looks and views, as buttons beside the presets and in a dialog, and the variants of the model. */
export class SavedLooks {
  private readonly looks: OwnLooks;
  private readonly bars: readonly NamedBar[];
  private readonly dialog = new NamedListDialog();

  constructor(
    viewport: Viewport,
    settings: Settings,
    private readonly views: SavedViews,
    variants: BarItems,
    onLook: (look: OwnLook) => void,
  ) {
    const picture = () =>
      viewport.isComplete && viewport.frames.redraw() ? thumbnailOf(viewport.frames.canvas) : undefined;
    this.looks = new OwnLooks(settings, picture, onLook, () => this.refresh());
    this.bars = [
      new NamedBar(findElement('own-looks'), this.looks),
      new NamedBar(findElement('saved-views'), views),
      new NamedBar(findElement('variants'), variants),
    ];
  }

  /** Call this when settings or the view have changed. */
  refresh(): void {
    for (const bar of this.bars) bar.refresh();
  }

  open(which: keyof typeof WORDS): void {
    this.dialog.open(this[which], WORDS[which]);
  }
}

/** Shows variants of a model. */
interface VariantShower {
  readonly variants: readonly string[];
  /** Index of the shown variant, if one was chosen. */
  readonly variant: number | undefined;
  showVariant(variant: number | undefined): void;
}

/** The material variants of the shown model. */
export class ModelVariants implements BarItems {
  constructor(private readonly loader: VariantShower) {}

  get items(): readonly NamedItem[] {
    return this.loader.variants.map((name) => ({ name }));
  }

  /** Shows a variant; choosing the shown one again returns to the file's default materials. */
  choose(index: number): void {
    this.loader.showVariant(this.isShown(index) ? undefined : index);
  }

  isShown(index: number): boolean {
    return this.loader.variant === index;
  }
}

/** A look named by the user. */
export interface KeptLook {
  id: string;
  name: string;
  look: OwnLook;
  /** A thumbnail of the drawing from which the look was saved, as a data URL. */
  picture: string | undefined;
}

const STORED = 'three-hatching looks';
/** The maximum number of stored looks. Further ones are ignored. */
export const MOST_LOOKS = 60;
/** The maximum length of a stored thumbnail. Those of the page have about a tenth of that. */
const LONGEST_PICTURE = 100_000;

/**
 * The looks stored in the browser's local storage. Where that fails, they last until the page is closed.
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
      // Without readable storage there are no looks.
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

/** Parses looks from untrusted text. Invalid entries are left out. */
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

/** The user's saved looks, stored by this browser. */
class OwnLooks implements NamedList {
  private readonly kept = new KeptLooks(() => localStorage);

  constructor(
    private readonly settings: Settings,
    /** Draws the drawing and returns a thumbnail of it. */
    private readonly picture: () => string | undefined,
    private readonly onChoose: (look: OwnLook) => void,
    /** Called when the list has changed. */
    private readonly onChange: () => void,
  ) {
    // Another tab has changed the stored looks.
    addEventListener('storage', () => {
      this.kept.refresh();
      onChange();
    });
  }

  get items(): readonly NamedItem[] {
    return this.kept.list;
  }

  get isFull(): boolean {
    return this.kept.list.length >= MOST_LOOKS;
  }

  get freeName(): string {
    return freeName('Look', this.items);
  }

  add(name: string): string | undefined {
    const { settings } = this;
    const added = {
      id: newId(),
      name: plainName(name) || this.freeName,
      look: acceptLook(settings),
      picture: this.picture(),
    };
    const sentence = this.change((looks) => [...looks, added].slice(0, MOST_LOOKS));
    if (sentence || (settings.mapStyle !== 'file' && settings.mapStyle !== 'ownHand')) return sentence;
    return 'Your own strokes stay with this drawing: the look draws with the strokes called Hatching.';
  }

  choose(index: number): void {
    const kept = this.kept.list[index];
    if (kept) this.onChoose(kept.look);
  }

  rename(index: number, name: string): string | undefined {
    const id = this.kept.list[index]?.id;
    return this.change((looks) =>
      looks.map((look) => (look.id === id ? { ...look, name: plainName(name) || look.name } : look)),
    );
  }

  remove(index: number): string | undefined {
    const id = this.kept.list[index]?.id;
    return this.change((looks) => looks.filter((look) => look.id !== id));
  }

  isShown(index: number): boolean {
    return hasLook(this.settings, this.kept.list[index].look);
  }

  private change(edit: Parameters<KeptLooks['change']>[0]): string | undefined {
    const isKept = this.kept.change(edit);
    this.onChange();
    return isKept
      ? undefined
      : 'This browser stores nothing for this page, or has no room: your looks last until the page is closed.';
  }
}
