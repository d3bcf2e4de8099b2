import { SETTING_KEYS, type Settings } from './settings.js';

/**
 * Changes from one source that follow each other faster than this are one step: dragging a slider or the light, say.
 */
const PAUSE_MILLISECONDS = 900;
const KEPT = 100;

/** Keeps the earlier settings, for Undo. */
export class SettingsHistory {
  private readonly past: Settings[] = [];
  private now: Settings;
  private lastSource: string | undefined;
  private lastTime = -Infinity;

  constructor(private readonly settings: Settings) {
    this.now = { ...settings };
  }

  /**
   * To be called after the user has changed the settings.
   *
   * @param source what was changed. Quick changes from the same source count as one step. Without it, the change is a
   *   step of its own.
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

  /** To be called after the settings have changed for a reason that Undo does not undo. */
  adopt(): void {
    this.now = { ...this.settings };
    this.lastSource = undefined;
  }

  /**
   * The settings before the last change, or undefined if there is none. If the model was a user's own file, the current
   * model is kept, because the file cannot be loaded again.
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
