import type { CameraView } from '../settings/CameraView.js';
import type { Settings } from '../settings/settings.js';
import { readLink } from '../settings/shareLink.js';
import { askToFetch } from './ask.js';
import type { DrawingState } from './DrawingState.js';
import type { Keeper } from './Keeper.js';
import { LatestRequest } from './LatestRequest.js';
import type { MapLoader } from './MapLoader.js';
import type { ModelLoader } from './ModelLoader.js';
import type { Status } from './Status.js';

/** What links are shown with. */
interface LinkHost {
  settings: Settings;
  keeper: Keeper;
  modelLoader: ModelLoader;
  mapLoader: MapLoader;
  status: Status;
  /** Takes over settings and camera, and loads the model and the map that they ask for. */
  showState(state: DrawingState): void;
  /** As `showState`, but for the model. */
  showLook(settings: Settings, camera: CameraView | undefined): void;
  recordChange(): void;
}

/**
 * Shows drawings that take a while, because the user is asked first or the browser keeps them. The latest is shown: of one that was
 * asked for before, nothing more is done.
 */
export class LinkFollower {
  private readonly asked = new LatestRequest();

  constructor(private readonly host: LinkHost) {}

  /** Shows what the page's address asks for. Resolves when that is known and loading. */
  async follow(): Promise<void> {
    const { keeper, settings } = this.host;
    // Nobody is to agree to what the address does not ask for any more.
    this.asked.drop();
    if (keeper.asked !== undefined) return this.openKept(keeper.asked);
    const { settings: next, camera, address } = readLink(location.hash);
    // While a model from the web is asked about and fetched, the one that is shown stays.
    if (address === undefined) this.host.showState({ settings: next, camera, files: undefined });
    else this.host.showLook({ ...next, model: settings.model }, camera);
    this.host.recordChange();
    if (address !== undefined) await this.showAddress(address, camera === undefined);
  }

  /** Shows a model from another site, if the user agrees. */
  async showAddress(address: string, isFramed: boolean): Promise<void> {
    const isAgreed = await this.asked.run((signal) => askToFetch(address, signal));
    const { modelLoader } = this.host;
    if (isAgreed) modelLoader.showAddress(address, isFramed);
    else if (isAgreed === false) modelLoader.showSomething();
  }

  /** Shows a kept drawing. */
  async openKept(id: string): Promise<void> {
    const { keeper, modelLoader, mapLoader, status } = this.host;
    const isShown = await this.asked.run(async (signal) => {
      const kept = await keeper.open(id, signal);
      if (signal.aborted) return;
      if (kept) {
        const { settings: next, address: origin } = readLink(kept.drawing.link);
        const { model: files, map } = kept.files;
        if (files) next.model = 'file';
        if (files && origin !== undefined) modelLoader.cameFrom(files, origin);
        this.host.showState({ settings: next, camera: kept.drawing.camera, files });
        if (map) await mapLoader.showFiles(map, true);
      } else {
        status.say('That drawing is no longer kept.');
        modelLoader.showSomething();
        void mapLoader.showChosen();
      }
      return true;
    });
    if (isShown) this.host.recordChange();
  }
}
