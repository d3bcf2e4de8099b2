import { acceptLook, hasLook, type OwnLook } from '../../viewer/settings/ownLook.js';
import { plainName } from '../../viewer/settings/savedViews.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { newId } from '../session/DrawingStore.js';
import { KeptLooks, MOST_LOOKS } from '../storage/KeptLooks.js';
import { freeName, type NamedItem, type NamedList } from './NamedList.js';

/** The user's saved looks, stored by this browser. */
export class OwnLooks implements NamedList {
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
