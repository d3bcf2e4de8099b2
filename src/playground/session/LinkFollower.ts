import { ModelError } from '../../viewer/files/common/ModelError.js';
import { SETTINGS } from '../../viewer/settings/settings.js';
import type { ModelChoice } from '../../viewer/settings/shareLink.js';
import { askToFetch } from '../loading/ask.js';
import type { DrawingState } from './DrawingState.js';
import type { DrawingStore } from './DrawingStore.js';
import type { PageAddress } from './PageAddress.js';
import type { Session } from './Session.js';

/** Runs one request at a time. A later request replaces the previous one and aborts its signal. */
export class LatestRequest {
  private controller: AbortController | undefined;

  /** @returns the result, or undefined if the request was replaced. @throws the error of the request, unless it was replaced */
  async run<Result>(task: (signal: AbortSignal) => Promise<Result>): Promise<Result | undefined> {
    this.drop();
    const controller = new AbortController();
    this.controller = controller;
    try {
      const result = await task(controller.signal);
      return controller.signal.aborted ? undefined : result;
    } catch (error) {
      if (controller.signal.aborted) return undefined;
      throw error;
    } finally {
      if (this.controller === controller) this.controller = undefined;
    }
  }

  /** Aborts the request, if there is one. */
  drop(): void {
    this.controller?.abort();
    this.controller = undefined;
  }
}

/** Opens drawings that need the user's consent or have to be read from storage. The latest request replaces earlier ones. */
export class LinkFollower {
  private readonly asked = new LatestRequest();

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly store: DrawingStore,
  ) {}

  /** Shows the drawing of the page's address. Resolves when loading has begun. */
  async follow(): Promise<void> {
    const { session } = this;
    // Withdraws a question about an earlier address.
    this.asked.drop();
    const { drawing } = this.address;
    const linked = session.linked(this.address.read());
    const { settings: next, namesModel, camera, address, views, hand, choice } = linked;
    if (drawing !== undefined) return this.openKept(drawing);
    const { ownFiles, choice: before } = session.modelLoader;
    if (!namesModel && ownFiles) session.showState({ ...linked, ...this.onOwnModel(linked, before), files: ownFiles });
    // The shown model stays until the user has agreed and the model has been fetched.
    else if (address === undefined) session.showState({ ...linked, files: undefined });
    else session.showLook({ settings: { ...next, model: session.settings.model }, camera, views, hand });
    session.recordChange();
    if (address !== undefined) await this.showAddress(address, camera === undefined, choice);
  }

  /**
   * The state for a link without a model: the present model in its present orientation, and with what is selected of its file unless the
   * link selects otherwise.
   */
  private onOwnModel(
    { settings: next, choice }: Pick<DrawingState, 'settings' | 'choice'>,
    before: ModelChoice,
  ): Pick<DrawingState, 'settings' | 'choice'> {
    const { upAxis } = this.session.settings;
    return {
      settings: { ...next, model: 'file', upAxis: next.upAxis === SETTINGS.upAxis.default ? upAxis : next.upAxis },
      choice: {
        variant: choice.variant ?? before.variant,
        clip: choice.clip ?? before.clip,
        switched: choice.switched ?? before.switched,
        hidden: choice.hidden ?? before.hidden,
      },
    };
  }

  /** Shows a model from another site, if the user agrees. */
  async showAddress(address: string, isFramed: boolean, choice: ModelChoice): Promise<void> {
    const isAgreed = await this.asked.run((signal) => askToFetch(address, signal));
    const { modelLoader } = this.session;
    if (isAgreed) modelLoader.showAddress(address, isFramed, choice);
    else if (isAgreed === false) modelLoader.showSomething();
  }

  /** Shows a stored drawing. @throws ModelError with one sentence for the user, if there is none */
  async openKept(id: string): Promise<void> {
    const { session, store } = this;
    const { modelLoader, mapLoader } = session;
    const isShown = await this.asked.run(async (signal) => {
      const kept = await store.open(id, signal).catch(() => 'unreadable' as const);
      if (signal.aborted) return;
      if (kept === undefined || kept === 'unreadable') {
        void mapLoader.showChosen();
        throw new ModelError(
          kept === undefined
            ? 'That drawing is no longer kept.'
            : 'The browser does not return the drawing that it keeps: open your model again.',
        );
      }
      const linked = session.linked(kept.drawing.link);
      const { settings: next, address: origin } = linked;
      const { model: files, map } = kept.files;
      if (files) next.model = 'file';
      if (files && origin !== undefined) modelLoader.cameFrom(files, origin);
      session.showState({ ...linked, camera: kept.drawing.camera, files });
      if (map) await mapLoader.showFiles(map, true);
      return true;
    });
    if (isShown) session.recordChange();
  }
}
