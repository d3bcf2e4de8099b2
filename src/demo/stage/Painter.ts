import { WebGLRenderer } from 'three';
import type { Look } from '../settings/lookOf.js';
import type { ShadowQuality } from './light/LightRig.js';
import { ProgramBuilder } from './ProgramBuilder.js';
import type { Scenery } from './Scenery.js';
import { SideBySide, sidesOf, type Tile } from './SideBySide.js';
import { strokeShare } from './strokeShare.js';
import { createCamera } from './view/createCamera.js';

/** Draws the scenery into the canvas, as the camera sees it. */
export class Painter {
  readonly renderer: WebGLRenderer;
  readonly camera = createCamera();
  readonly sides: SideBySide;
  private readonly builder: ProgramBuilder;
  /** What programs depend on, as it was when they were last built. */
  private builtFor = '';

  /** @param onBuilt called when programs that were waited for are ready */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly context: WebGL2RenderingContext,
    private readonly viewport: HTMLElement,
    private readonly scenery: Scenery,
    onBuilt: () => void,
  ) {
    const renderer = new WebGLRenderer({ canvas, context });
    // Costs nothing while no light casts a shadow. Drawn anew where something moves that casts one, not where the camera does.
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.autoUpdate = false;
    this.renderer = renderer;
    this.builder = new ProgramBuilder(renderer, onBuilt);
    this.sides = new SideBySide(
      renderer,
      (side) => scenery.shown.model?.useMaterials(side),
      () => renderer.render(scenery.scene, this.camera),
    );
  }

  /** Whether the graphics context is lost. What is changed meanwhile is drawn when it comes back. */
  get isLost(): boolean {
    return this.context.isContextLost();
  }

  /** Pixels of the canvas per CSS pixel. */
  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Sets {@link pixelRatio}. The same gives the canvas no new memory. */
  set pixelRatio(ratio: number) {
    if (ratio !== this.pixelRatio) this.renderer.setPixelRatio(ratio);
  }

  /** Sets the colour of what nothing is drawn on. */
  setPaper(color: string): void {
    this.renderer.setClearColor(color, 1);
  }

  /**
   * Draws one tile of a picture, or a whole frame.
   *
   * @param pixelRatio pixels of the picture per CSS pixel; the widths of strokes and lines go with it
   * @param share of the full resolution, where it is drawn in a lower one
   */
  drawTile(tile: Tile, pixelRatio: number, share = 1): void {
    this.setWidths(pixelRatio, share);
    this.sides.drawTile(tile);
  }

  /** Has shadows drawn anew, because something has moved that casts or throws them. */
  outdateShadows(): void {
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Places the lights, and has shadows drawn anew where they or the model have moved. */
  placeLights(quality: ShadowQuality): void {
    const { scenery } = this;
    const hasMoved = scenery.look !== undefined && scenery.lights.place(this.camera);
    if (hasMoved || scenery.shown.model?.motion) this.outdateShadows();
    this.setShadowQuality(quality, this.renderer.shadowMap.needsUpdate);
  }

  /** As {@link LightRig.setShadowQuality}. */
  setShadowQuality(quality: ShadowQuality, areDrawn: boolean): void {
    if (this.scenery.lights.setShadowQuality(quality, areDrawn)) this.outdateShadows();
  }

  /** Whether programs are being built. The last frame stays until then. */
  get isBuilding(): boolean {
    return this.builder.isBuilding;
  }

  /** Has the programs built that a look asks for, where they differ from those of the last time: numbers and colours build none. */
  buildPrograms(look: Look): void {
    const { scenery, renderer, camera } = this;
    const { model } = scenery.shown;
    if (!model || this.isLost) return;
    if (look.programs === this.builtFor) return;
    this.builtFor = look.programs;
    // Lines that are not drawn by hand have a program of their own.
    this.setWidths(this.pixelRatio);
    this.builder.build(() => {
      for (const side of sidesOf(look)) {
        model.useMaterials(side);
        renderer.compile(scenery.scene, camera);
      }
    });
  }

  /** To be called when programs are needed that the look does not tell of: those of another model, or of another context. */
  forgetPrograms(): void {
    this.builtFor = '';
  }

  stopBuilding(): void {
    this.builder.stop();
  }

  private setWidths(pixelRatio: number, share = 1): void {
    const { clientWidth, clientHeight } = this.viewport;
    this.scenery.setWidths(pixelRatio * strokeShare(clientWidth, clientHeight), share);
  }
}
