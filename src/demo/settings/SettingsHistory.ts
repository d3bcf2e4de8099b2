import { SETTING_KEYS, type Settings } from './settings.js';

/** Changes of one source closer together than this are one change: a slider that is dragged, a lamp that is moved. */
const PAUSE_MILLISECONDS = 900;
const KEPT = 100;

/** Remembers how settings were before each change. */
export class SettingsHistory {
  private readonly past: Settings[] = [];
  private now: Settings;
  private lastSource: string | undefined;
  private lastTime = -Infinity;

  constructor(private readonly settings: Settings) {
    this.now = { ...settings };
  }

  /**
   * The settings were changed.
   *
   * @param source names what moved, so that a movement in many steps counts as one change; undefined: a change by itself
   */
  changed(source?: string): void {
    const time = performance.now();
    const continues = source !== undefined && source === this.lastSource && time - this.lastTime < PAUSE_MILLISECONDS;
    this.lastSource = source;
    this.lastTime = time;
    if (!continues) {
      this.past.push(this.now);
      if (this.past.length > KEPT) this.past.shift();
    }
    this.now = { ...this.settings };
  }

  /** The settings are others for a reason that is not to be undone. */
  adopt(): void {
    this.now = { ...this.settings };
    this.lastSource = undefined;
  }

  /**
   * The settings as they were before the last change, or undefined when there is none. A person's own file cannot be
   * brought back.
   */
  undo(): Settings | undefined {
    for (let before = this.past.pop(); before; before = this.past.pop()) {
      if (before.model === 'file') before.model = this.settings.model;
      if (SETTING_KEYS.every((key) => before[key] === this.settings[key])) continue;
      this.now = before;
      this.lastSource = undefined;
      return { ...before };
    }
    return undefined;
  }

  get isEmpty(): boolean {
    return this.past.length === 0;
  }
}
