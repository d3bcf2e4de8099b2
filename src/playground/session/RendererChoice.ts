import type { LaterParts } from '../tasks/LaterParts.js';
import type { Status } from '../tasks/Status.js';
import type { Screen } from '../viewport/Frames.js';
import type { Session } from './Session.js';

/** Draws frames with WebGPURenderer while the settings ask for it, and returns to WebGL if that fails. */
export class RendererChoice {
  /** Whether the browser offers WebGPU with a graphics card; undefined until asked. */
  private isThere: boolean | undefined;
  private isWanted = false;
  private screen: Screen | undefined;

  constructor(
    private readonly session: Session,
    private readonly parts: LaterParts,
    private readonly status: Status,
  ) {
    session.listen({ applied: () => this.update() });
  }

  /** Whether the choice is shown: if WebGPU is available, or a link chose it. */
  get isOffered(): boolean {
    return this.isThere === true || this.session.settings.renderer === 'webgpu';
  }

  /** A sentence on what WebGL draws although WebGPU is chosen; empty if it is not chosen. */
  get note(): string {
    const { settings, viewport } = this.session;
    if (settings.renderer !== 'webgpu') return '';
    const lack = viewport.scenery.look?.lackOfNodes;
    if (lack === undefined) return 'Pictures, prints, videos and vector files are drawn by WebGL.';
    return `WebGL draws this, because WebGPU lacks ${lack}.`;
  }

  /** Checks for WebGPU. Called on demand, because some browsers start a process for it. */
  async ask(): Promise<boolean> {
    this.isThere ??= (await navigator.gpu?.requestAdapter().catch(() => null)) != null;
    return this.isThere;
  }

  private update(): void {
    const isWanted = this.session.settings.renderer === 'webgpu';
    if (isWanted === this.isWanted) return;
    this.isWanted = isWanted;
    if (isWanted) this.parts.whenFetched(this.start(), () => this.session.viewport.frames.refine());
    else this.stop();
  }

  private async start(): Promise<void> {
    const { viewport } = this.session;
    if (!(await this.ask())) {
      this.leave('This browser has no WebGPU for the page; WebGL draws on.');
      return;
    }
    try {
      const { NodeScreen } = await import('../viewport/NodeScreen.js');
      const screen = await NodeScreen.create({
        painter: viewport.painter,
        scenery: viewport.scenery,
        refine: () => viewport.frames.refine(),
        onLost: () => this.leave('The graphics card has let go of WebGPU; WebGL draws on.'),
      });
      // The choice may have changed while the renderer was created.
      if (!this.isWanted || this.screen) screen.dispose();
      else this.use(screen);
    } catch {
      this.leave('WebGPU could not be set up; WebGL draws on.');
    }
  }

  private use(screen: Screen | undefined): void {
    const { frames } = this.session.viewport;
    this.screen = screen;
    frames.drawOn(screen);
  }

  private stop(): void {
    if (!this.screen) return;
    this.use(undefined);
    // The painter has freed its programs.
    this.session.viewport.rebuildPrograms();
  }

  /** Returns to WebGL, without a step in the history. */
  private leave(sentence: string): void {
    if (!this.isWanted) return;
    this.session.settings.renderer = 'webgl';
    this.session.adopt();
    this.status.fail(sentence);
  }
}
