import { isLitBy, lightOf, MAX_VIEWS, plainName, type SavedView } from '../../viewer/settings/CameraView.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import type { Settings } from '../../viewer/settings/settings.js';
import type { Viewport } from '../viewport/Viewport.js';

/** A look or a view named by the user. */
export interface NamedItem {
  name: string;
  /** A thumbnail, as a data URL. */
  picture?: string | undefined;
  /** The key that chooses the item. */
  key?: string;
}

/** A list of named items. Methods that change it may return a sentence for the user. */
export interface NamedList {
  readonly items: readonly NamedItem[];
  readonly isFull: boolean;
  /** An unused name. */
  readonly freeName: string;
  /** Adds the present look or view. */
  add(name: string): string | undefined;
  choose(index: number): void;
  rename(index: number, name: string): string | undefined;
  remove(index: number): string | undefined;
  /** Whether the drawing shows the item. */
  isShown(index: number): boolean;
}

/** The first free name of the form `Look 1`, `Look 2` and so on, starting from the number of items plus one. */
export function freeName(word: string, items: readonly NamedItem[]): string {
  for (let number = items.length + 1; ; number++) {
    const name = `${word} ${number}`;
    if (!items.some((item) => item.name === name)) return name;
  }
}

/** The saved views of the drawing, each with a camera and lights. */
export class SavedViews implements NamedList {
  /** Immutable, because Undo returns to earlier lists. */
  list: readonly SavedView[] = [];

  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    /** Called when the user has changed the list, or has chosen a view. */
    private readonly onChange: () => void,
  ) {}

  get items(): readonly NamedItem[] {
    return this.list.map(({ name }, i) => ({ name, key: String(i + 1) }));
  }

  get isFull(): boolean {
    return this.list.length >= MAX_VIEWS;
  }

  get freeName(): string {
    return freeName('View', this.list);
  }

  add(name: string): undefined {
    const { ownPlace: camera } = this.viewport.view;
    this.change([...this.list, { name: plainName(name) || this.freeName, camera, light: lightOf(this.settings) }]);
  }

  choose(index: number): void {
    const view = this.list[index];
    if (!view) return;
    const { viewport, settings } = this;
    Object.assign(settings, view.light);
    // Settings are applied first, because a model is framed together with its shadow, which depends on the lights.
    viewport.apply(lookOf(settings));
    if (view.camera) viewport.view.place = view.camera;
    else viewport.view.frame();
    this.onChange();
  }

  rename(index: number, name: string): undefined {
    this.change(this.list.map((view, i) => (i === index ? { ...view, name: plainName(name) || view.name } : view)));
  }

  remove(index: number): undefined {
    this.change(this.list.filter((_, i) => i !== index));
  }

  isShown(index: number): boolean {
    const { camera, light } = this.list[index];
    return isLitBy(this.settings, light) && JSON.stringify(camera) === JSON.stringify(this.viewport.view.ownPlace);
  }

  private change(list: readonly SavedView[]): void {
    this.list = list;
    this.onChange();
  }
}
