import type { ModelFile } from '../../viewer/files/common/ModelFile.js';
import { EditHistory } from '../../viewer/settings/EditHistory.js';
import { type Look, lookOf } from '../../viewer/settings/lookOf.js';
import type { SettingKey, Settings } from '../../viewer/settings/settings.js';
import { choosesMap } from '../../viewer/settings/settingValues.js';
import { type LinkedDrawing, readLink, writeLink } from '../../viewer/settings/shareLink.js';
import { MapLoader } from '../loading/MapLoader.js';
import { type ModelEnd, ModelLoader, type OpenedModel } from '../loading/ModelLoader.js';
import { SavedViews } from '../savedLooks/SavedViews.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';
import { type DrawingState, isSameState, type LookState, linkedHand, type OwnHand } from './DrawingState.js';
import { watchPresses } from './watchPresses.js';

/** Events of a session. */
export interface SessionListener {
  /** The settings have been applied to the viewport. */
  applied?(): void;
  /** The user has moved the camera. */
  moved?(): void;
  /** The steps to undo or redo may have changed. */
  stepped?(): void;
  /** Another model is shown; its settings are not applied yet. */
  modelShown?(): void;
  /** Another map is in use. */
  mapShown?(): void;
}

type SessionEvent = keyof SessionListener;

/** The user's drawing: settings, model, map, views and history. */
export class Session {
  readonly modelLoader: ModelLoader;
  readonly mapLoader: MapLoader;
  readonly views: SavedViews;
  private readonly history: EditHistory<DrawingState>;
  private readonly listeners: SessionListener[] = [];

  constructor(
    readonly viewport: Viewport,
    readonly settings: Settings,
    tasks: TaskRunner,
  ) {
    this.mapLoader = new MapLoader(
      viewport,
      settings,
      tasks,
      () => this.mapShown(),
      (isRestored) => (isRestored ? this.apply() : this.recordChange()),
      () => this.adopt(),
    );
    this.modelLoader = new ModelLoader(viewport, settings, tasks, (end, opened) => this.modelLoaded(end, opened));
    this.views = new SavedViews(viewport, settings, () => this.recordChange());
    this.history = new EditHistory(() => this.state, isSameState, watchPresses());
    viewport.view.onMoved = () => {
      this.history.changed('camera');
      this.tell('stepped');
      this.tell('moved');
    };
  }

  /** Adds a listener. Listeners are called in the order in which they were added. */
  listen(listener: SessionListener): void {
    this.listeners.push(listener);
  }

  /** Applies the settings as the state before the first step. */
  start(): void {
    this.history.adopt();
    this.apply();
  }

  // ── Changes by the user ──

  /**
   * Applies settings that the user has changed, and records the earlier ones for Undo.
   *
   * @param source see {@link EditHistory.changed}
   */
  recordChange(source?: string): void {
    // The settings are applied first, so that the step includes how the view reacts to them.
    this.apply();
    this.history.changed(source);
    this.tell('stepped');
  }

  /** Changes settings that need no other map, as one step. */
  change(values: Partial<Settings>): void {
    Object.assign(this.settings, values);
    this.recordChange();
  }

  /** Changes settings as one step, and loads the map that they need. */
  useLook(look: Partial<Settings>): void {
    this.change(look);
    void this.mapLoader.showChosen();
  }

  /** Shows the clip that the user has chosen, by index. */
  chooseClip(index: number): void {
    this.modelLoader.clip = index;
    this.recordChange();
  }

  /** Call this when the user has changed one setting with its control. */
  settingChanged(key: SettingKey): void {
    if (key === 'model') this.modelLoader.changeModel();
    if (choosesMap(key)) void this.mapLoader.showChosen();
    this.recordChange(key);
  }

  /** Hides parts of the model by their indices, in rising order, and shows the others, as one step. */
  hideParts(hidden: readonly number[]): void {
    if (this.modelLoader.hide(hidden)) this.recordChange();
  }

  /** Shows the drawing of a link, as one step. */
  useLink(link: string): void {
    this.showState({ ...this.linked(link), files: undefined });
    this.recordChange();
  }

  /**
   * Sets the user's own hand, with the settings that it needs.
   *
   * @param source see {@link EditHistory.changed}
   */
  handChanged(hand: OwnHand | undefined, values: Partial<Settings> = {}, source?: string): void {
    this.mapLoader.hand = hand;
    Object.assign(this.settings, values);
    this.recordChange(source);
  }

  // ── Steps ──

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  undo(): void {
    this.step(this.history.undo());
  }

  redo(): void {
    this.step(this.history.redo());
  }

  /** Clears the history. */
  forgetSteps(): void {
    this.history.clear();
    this.tell('stepped');
  }

  private step(state: DrawingState | undefined): void {
    if (state) this.showState(state);
    this.apply();
    this.tell('stepped');
  }

  // ── States ──

  private get state(): DrawingState {
    const { settings, viewport, views } = this;
    return {
      settings: { ...settings },
      camera: viewport.view.state,
      files: settings.model === 'file' ? this.modelLoader.ownFiles : undefined,
      views: views.list,
      hand: this.mapLoader.hand,
      choice: this.modelLoader.choice,
    };
  }

  /** The drawing as the text of a link. */
  get link(): string {
    const { modelLoader, mapLoader, views } = this;
    const { address, choice } = modelLoader;
    return writeLink(this.settings, this.viewport.view.ownPlace, address, views.list, mapLoader.hand?.link, choice);
  }

  /** Whether a link to the drawing includes its model. */
  get isModelInLink(): boolean {
    return this.settings.model !== 'file' || this.modelLoader.address !== undefined;
  }

  /** Whether a link to the drawing includes the hand that it is drawn with. */
  get isHandInLink(): boolean {
    return this.settings.mapStyle !== 'ownHand' || this.mapLoader.hand?.link !== undefined;
  }

  /** The state of a link, whose hand is not read yet. */
  linked(link: string): LinkedDrawing & LookState {
    const drawing = readLink(link);
    // A link without a hand keeps the user's own one, so that it can be chosen again.
    return { ...drawing, hand: linkedHand(drawing.handText) ?? this.mapLoader.hand };
  }

  /** The files of the user's own map or hand, if the drawing uses them. */
  get ownStrokes(): readonly ModelFile[] | undefined {
    const { hand, ownFiles } = this.mapLoader;
    return { ownHand: hand?.files, file: ownFiles }[this.settings.mapStyle as string];
  }

  /** Applies settings, camera and views, and loads their model and map. */
  showState(state: DrawingState): void {
    const { settings: next, camera: place, files, choice } = state;
    // Files that are gone cannot be shown again.
    const { model } = this.settings;
    this.showLook({ ...state, settings: { ...next, ...(next.model === 'file' && !files && { model }) } });
    const isFramed = place === undefined || place.framedFor !== undefined;
    this.modelLoader.restore({ model: this.settings.model, files, choice }, isFramed);
  }

  /** Applies settings, camera and views, and loads their map. */
  showLook({ settings: next, camera: place, views: kept, hand }: LookState): void {
    const { viewport, settings } = this;
    Object.assign(settings, next);
    this.views.list = kept;
    this.mapLoader.hand = hand;
    void this.mapLoader.showChosen();
    // Applied first: the model is framed together with its shadow, which depends on the lights.
    viewport.apply(this.look);
    if (place) viewport.view.state = place;
    else viewport.view.frame();
  }

  private get look(): Look {
    const { settings, mapLoader } = this;
    return lookOf({ ...settings, tilesPerObjectUnit: settings.tilesPerObjectUnit * mapLoader.tileScale });
  }

  private mapShown(): void {
    // Its tiles may be smaller than those of the previous map.
    this.viewport.apply(this.look);
    this.tell('mapShown');
  }

  private apply(): void {
    this.viewport.apply(this.look);
    this.tell('applied');
  }

  /** Applies settings that the page has changed by itself, which is no step. */
  adopt(): void {
    this.apply();
    this.history.adopt();
  }

  private modelLoaded(end: ModelEnd, opened: OpenedModel | undefined): void {
    if (opened) this.takeOver(opened);
    if (end === 'opened' || end === 'restored') this.tell('modelShown');
    if (end === 'opened') this.recordChange();
    else this.adopt();
  }

  /** Applies the look that came with a model. It is checked like that of a link; an address in it is ignored. */
  private takeOver({ isOther, drawing, views: ofFile }: OpenedModel): void {
    if (isOther) this.views.list = ofFile;
    if (!drawing) return;
    const { settings: next, camera, views, hand, choice } = this.linked(drawing.link);
    const { model } = this.settings;
    this.showLook({ settings: { ...next, model }, camera, views, hand });
    this.modelLoader.restore({ model, files: this.modelLoader.ownFiles, choice }, false);
    if (drawing.strokes.length > 0)
      void this.mapLoader.showFiles(drawing.strokes, true).then(() => this.history.adopt());
  }

  private tell(event: SessionEvent): void {
    for (const listener of this.listeners) listener[event]?.();
  }
}
