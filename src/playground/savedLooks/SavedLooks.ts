import type { OwnLook } from '../../viewer/settings/presets.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { findElement } from '../page/elements.js';
import { thumbnailOf } from '../session/KeptPicture.js';
import type { Viewport } from '../viewport/Viewport.js';
import { type BarItems, type ListWords, NamedBar, NamedListDialog } from './NamedListDialog.js';
import { OwnLooks } from './OwnLooks.js';
import type { NamedItem, SavedViews } from './SavedViews.js';

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
