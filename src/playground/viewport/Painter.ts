import { MathUtils, type WebGLInfo, WebGLRenderer } from 'three';
import { strokeShare } from '../../viewer/sceneSetup/framing.js';
import { type SheetPart, WHOLE_SHEET } from '../../viewer/sceneSetup/groundShadow.js';
import { createCamera } from '../../viewer/sceneSetup/LensCamera.js';
import type { ShadowQuality } from '../../viewer/sceneSetup/LightRig.js';
import type { Look } from '../../viewer/settings/lookOf.js';
import type { Scenery } from './Scenery.js';

/** The sides of a comparison: the technique of the settings, and the compared one. */
type Side = 'drawn' | 'compared';

/** The part of a picture that fills the canvas, in device pixels. */
interface Tile {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
  /** Whether only the technique of the settings is drawn, even during a comparison. */
  isUndivided?: boolean;
}

/**
 * Pixels drawn beyond the edge of a part that continues: outlines examine their surroundings. Wide accents of large prints look no farther
 * than this.
 */
export const MARGIN = 64;

/** The sides that a look draws. */
const sidesOf = ({ compared }: Look): Side[] => (compared ? ['drawn', 'compared'] : ['drawn']);

/** Draws one technique, or two side by side, with the compared one left of a divider. */
class SideBySide {
  /** Returns the position of the divider in every frame, as a share of the width; undefined without a comparison. */
  divider: (() => number) | undefined;

  /**
   * @param use selects the materials of a side for the next rendering
   * @param render draws with them
   */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly use: (side: Side) => void,
    private readonly render: () => void,
  ) {}

  /**
   * Draws one tile of a picture that is `viewWidth` wide. The tile begins `x` pixels from the left and fills the canvas. An ordinary frame
   * is one tile.
   */
  drawTile({ viewWidth, x, width, height, isUndivided = false }: Tile): void {
    const { renderer } = this;
    const share = isUndivided ? undefined : this.divider?.();
    this.use('drawn');
    if (share === undefined) {
      this.render();
      return;
    }
    const split = MathUtils.clamp(Math.round(share * viewWidth) - x, 0, width);
    renderer.setScissorTest(true);
    // The part beyond the divider is overdrawn by the other side.
    const from = Math.max(0, split - MARGIN);
    renderer.setScissor(from, 0, width - from, height);
    if (split < width) this.render();
    this.use('compared');
    renderer.setScissor(0, 0, split, height);
    if (split > 0) this.render();
    renderer.setScissorTest(false);
  }
}

const POLL_MILLISECONDS = 10;

/** Compiles the programs of a scene in the background, so that the first frame that needs them does not block the page. */
class ProgramBuilder {
  private readonly gl: WebGL2RenderingContext;
  /** A fence that is signalled when the browser has passed the programs to the driver. */
  private fence: WebGLSync | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param onBuilt called when the programs are ready */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly onBuilt: () => void,
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
  }

  get isBuilding(): boolean {
    return this.timer !== undefined;
  }

  /** Builds programs. @param compile calls the renderer's `compile` for everything that is drawn next */
  build(compile: () => void): void {
    const newest = this.programs.at(-1);
    compile();
    if (this.programs.at(-1) === newest) return;
    this.stop();
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    this.wait();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.gl.deleteSync(this.fence);
    this.fence = null;
  }

  private get programs(): NonNullable<WebGLInfo['programs']> {
    return this.renderer.info.programs ?? [];
  }

  private get areReady(): boolean {
    const { gl, fence } = this;
    if (gl.isContextLost()) return true;
    if (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
    const parallel = gl.getExtension('KHR_parallel_shader_compile');
    // The promise of compileAsync would throw if a material is disposed of meanwhile.
    return (
      !parallel ||
      this.programs.every(({ program }) =>
        gl.getProgramParameter(program as WebGLProgram, parallel.COMPLETION_STATUS_KHR),
      )
    );
  }

  private wait(): void {
    this.timer = setTimeout(() => {
      if (!this.areReady) {
        this.wait();
        return;
      }
      this.stop();
      // three.js queries the uniforms of a program once. During a frame, that would wait for earlier draw calls.
      for (const program of this.programs) program.getUniforms();
      this.onBuilt();
    }, POLL_MILLISECONDS);
  }
}

/** Draws the scenery into the canvas with WebGLRenderer. */
export class Painter {
  readonly renderer: WebGLRenderer;
  readonly camera = createCamera();
  readonly sides: SideBySide;
  private readonly builder: ProgramBuilder;
  /** The key of the programs that were built last; empty without any. */
  private builtFor = '';
  /** Whether the scenery may have resources on the graphics card. */
  private isUsed = false;
  /** The part of the picture that is the sheet. */
  sheetOf: () => SheetPart = () => WHOLE_SHEET;
  /** The number of times the shadow maps were outdated. */
  shadowChanges = 0;

  /** @param onBuilt called when programs are ready */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly context: WebGL2RenderingContext,
    private readonly viewport: HTMLElement,
    private readonly scenery: Scenery,
    onBuilt: () => void,
  ) {
    const renderer = new WebGLRenderer({ canvas, context });
    // Shadows cost nothing while no light casts them. Their maps are redrawn when a light or the model moves, not with the camera.
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

  /** Whether the graphics context is lost. Changes meanwhile are drawn when it is restored. */
  get isLost(): boolean {
    return this.context.isContextLost();
  }

  /** Device pixels per CSS pixel. */
  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Does nothing if the ratio is the same, because setting it reallocates the canvas. */
  set pixelRatio(ratio: number) {
    if (ratio !== this.pixelRatio) this.renderer.setPixelRatio(ratio);
  }

  /** Sets the colour of the background. */
  setPaper(color: string): void {
    this.renderer.setClearColor(color, 1);
  }

  /**
   * Draws one tile of a picture, or a whole frame.
   *
   * @param scale of a picture relative to the page, which scales the widths of strokes and outlines
   */
  drawTile(tile: Tile, scale = 1): void {
    this.scenery.takeBack();
    this.isUsed = true;
    this.setWidths(scale);
    this.sides.drawTile(tile);
  }

  /** Makes the next frame redraw the shadow maps, because a light or the model has moved. */
  outdateShadows(): void {
    this.renderer.shadowMap.needsUpdate = true;
    this.shadowChanges++;
  }

  /** Places the lights, and outdates the shadow maps if they or the model have moved. */
  placeLights(quality: ShadowQuality): void {
    const { scenery } = this;
    const hasMoved = scenery.look !== undefined && scenery.lights.place(this.camera);
    if (hasMoved || scenery.shown.model?.motion) this.outdateShadows();
    this.setShadowQuality(quality, this.renderer.shadowMap.needsUpdate);
  }

  /** Sets the quality of shadows, as {@link LightRig.setShadowQuality} does. */
  setShadowQuality(quality: ShadowQuality, areDrawn: boolean): void {
    if (this.scenery.lights.setShadowQuality(quality, areDrawn)) this.outdateShadows();
  }

  /** True while programs compile. */
  get isBuilding(): boolean {
    return this.builder.isBuilding;
  }

  /** Builds the programs of a look where they differ from the last ones: changed numbers and colours need none. */
  buildPrograms(look: Look): void {
    const { scenery, renderer, camera } = this;
    const { drawn } = scenery.shown;
    if (!drawn || this.isLost) return;
    if (look.programs === this.builtFor) return;
    this.builtFor = look.programs;
    scenery.takeBack();
    this.isUsed = true;
    // Lines without hand-drawn wobble have a program of their own.
    this.setWidths();
    this.builder.build(() => {
      for (const side of sidesOf(look)) {
        drawn.useMaterials(side);
        drawn.announce();
        renderer.compile(scenery.scene, camera);
      }
    });
  }

  /** Call this when the same look needs other programs: those of another model, or of a restored context. */
  forgetPrograms(): void {
    this.builtFor = '';
  }

  stopBuilding(): void {
    this.builder.stop();
  }

  /** Frees all GPU resources except the context, because another renderer draws frames. They are uploaded again when needed. */
  release(): void {
    if (!this.isUsed || this.isLost) return;
    this.isUsed = false;
    this.stopBuilding();
    this.forgetPrograms();
    this.scenery.takeBack();
    this.scenery.releaseGraphics();
    this.outdateShadows();
    this.pixelRatio = 1;
    this.renderer.setSize(1, 1, false);
  }

  /** Sets the widths of strokes and outlines, and the end of the shadow on the ground. @param scale of a picture relative to the page */
  setWidths(scale = 1): void {
    const { clientWidth, clientHeight } = this.viewport;
    this.scenery.setWidths(strokeShare(clientWidth, clientHeight), scale);
    this.scenery.endShadow(this.camera, this.sheetOf());
  }
}
