import { Group, MathUtils, Scene, WebGLRenderer } from 'three';
import type { TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../drawing/HatchedModel.js';
import type { Settings } from '../settings/settings.js';
import { AdaptiveResolution } from './AdaptiveResolution.js';
import { createCamera, DEFAULT_VIEW } from './createCamera.js';
import { FrameScheduler } from './FrameScheduler.js';
import { FrameTimer } from './FrameTimer.js';
import { LightRig } from './LightRig.js';
import { View } from './View.js';

const MAX_PIXEL_RATIO = 2;
/** A desk-filling sheet on a large screen is drawn with fewer pixels than it has, rather than slowly. */
const MAX_PIXELS = 8_000_000;

/** The picture: renderer, camera, lights, and one model drawn with one look or, compared, with two. */
export type HatchingScene = ReturnType<typeof createScene>;

/** A strip of a view, in the renderer's pixels. */
interface Tile {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
}

/**
 * Sets up the drawing on a canvas. Nothing is drawn until `invalidate` is called, and then once.
 */
export function createScene(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, viewport: HTMLElement) {
  const renderer = new WebGLRenderer({ canvas, context });
  const scene = new Scene();
  const camera = createCamera();
  const lights = new LightRig(scene);
  /** Holds the model; turned where its up is another. */
  const upright = new Group();
  scene.add(upright);
  let model: HatchedModel | undefined;
  /** The model before, until the new one has been drawn: programs that both use are not built again then. */
  let previousModel: HatchedModel | undefined;
  let map: TonalArtMap | undefined;
  let settings: Settings | undefined;

  const frameListeners: (() => void)[] = [];
  const scheduler = new FrameScheduler(() => draw());
  const resolution = new AdaptiveResolution(() => scheduler.invalidate());
  const timer = new FrameTimer(context, () => {
    resolution.measured(timer.milliseconds!);
    for (const listener of timeListeners) listener();
  });
  const timeListeners: (() => void)[] = [];
  const view = new View(canvas, camera, () => scheduler.invalidate());
  let lastFrame = 0;
  /** Share of the width that is drawn in the compared look, or undefined when there is one drawing only. */
  let divider: (() => number) | undefined;

  function draw(): void {
    const { clientWidth: width, clientHeight: height } = viewport;
    if (context.isContextLost() || width === 0 || height === 0) return;
    resolution.beforeFrame();
    move();
    if (renderer.getPixelRatio() !== pixelRatio()) renderer.setPixelRatio(pixelRatio());
    timer.measure(() => drawTile({ viewWidth: width, x: 0, width, height }, renderer.getPixelRatio()));
    previousModel?.dispose();
    previousModel = undefined;
    for (const listener of frameListeners) listener();
    if (model?.motion?.isPlaying) scheduler.invalidate();
  }

  /** Moves the model on by the time that has passed. */
  function move(): void {
    const now = performance.now();
    model?.motion?.advance((now - lastFrame) / 1000);
    lastFrame = now;
  }

  /**
   * Draws an upright strip of the view into the canvas as it is sized now: the strip begins `x` pixels from the left of a
   * view that is `viewWidth` wide. The strip of an ordinary frame is the whole view.
   *
   * @param pixelRatio pixels drawn per pixel of the page: strokes are as many times as wide, their edges as sharp
   */
  function drawTile({ viewWidth, x, width, height }: Tile, pixelRatio: number): void {
    const share = divider?.();
    if (model && settings) model.strokeWidth = settings.strokeWidth * pixelRatio;
    model?.useMaterials('drawn');
    if (share === undefined) {
      renderer.render(scene, camera);
      return;
    }
    const split = MathUtils.clamp(Math.round(share * viewWidth) - x, 0, width);
    renderer.setScissorTest(true);
    renderer.setScissor(split, 0, width - split, height);
    if (split < width) renderer.render(scene, camera);
    model?.useMaterials('compared');
    renderer.setScissor(0, 0, split, height);
    if (split > 0) renderer.render(scene, camera);
    renderer.setScissorTest(false);
  }

  function pixelRatio(): number {
    const { clientWidth: width, clientHeight: height } = viewport;
    const full = Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));
    return full * resolution.scale;
  }

  function resize(): void {
    const { clientWidth: width, clientHeight: height } = viewport;
    if (width === 0 || height === 0) return;
    renderer.setPixelRatio(pixelRatio());
    renderer.setSize(width, height, false);
    view.resized(width / height);
    timer.reset();
    // At once, not in the next frame: a canvas that changed its size is empty until it is drawn.
    draw();
  }

  function measureBounds(first?: readonly [number, number, number]): void {
    upright.updateMatrix();
    if (model) view.setBounds(model.bounds.clone().applyMatrix4(upright.matrix), first);
  }

  const sizes = new ResizeObserver(resize);
  sizes.observe(viewport);
  resize();

  return {
    renderer,
    scene,
    camera,
    view,
    lightPosition: lights.position,
    draw,
    drawTile,

    /** Draws on paper, or strokes and nothing else. */
    showPaper(shown: boolean): void {
      model?.showPaper(shown);
    },

    /** Calls back after each frame. */
    onFrame(listener: () => void): void {
      frameListeners.push(listener);
    },

    /** Calls back when {@link frameMilliseconds} has changed. */
    onFrameTime(listener: () => void): void {
      timeListeners.push(listener);
    },

    /** What a frame costs, or undefined before one was measured. */
    get frameMilliseconds(): number | undefined {
      return timer.milliseconds;
    },

    /** Whether frames are drawn in a lower resolution, because the machine is too slow for this movement. */
    get isCoarse(): boolean {
      return resolution.isCoarse;
    },

    get framesDrawn(): number {
      return scheduler.frames;
    },

    /** Whether a frame was asked for that is not drawn yet. */
    get isWaiting(): boolean {
      return scheduler.isWaiting;
    },

    /** Asks for one frame. */
    invalidate(): void {
      scheduler.invalidate();
    },

    /** Draws a model from now on, and frees the one before. `first` is the direction to the eye that shows it whole. */
    setModel(next: HatchedModel, first: readonly [number, number, number] = DEFAULT_VIEW): void {
      previousModel?.dispose();
      previousModel = model;
      previousModel?.root.removeFromParent();
      model = next;
      upright.add(next.root);
      timer.reset();
      if (map) next.tonalArtMap = map;
      if (settings) this.apply(settings);
      measureBounds(first);
      scheduler.invalidate();
    },

    get model(): HatchedModel | undefined {
      return model;
    },

    setTonalArtMap(next: TonalArtMap): void {
      map = next;
      if (model) model.tonalArtMap = map;
      scheduler.invalidate();
    },

    get tonalArtMap(): TonalArtMap | undefined {
      return map;
    },

    /** Draws a second technique left of a divider, whose place is asked for with every frame; or no longer does. */
    compareWith(share: (() => number) | undefined): void {
      divider = share;
      scheduler.invalidate();
    },

    /** Puts the settings in force. Cheap: nothing is rebuilt but, where a setting needs another program, that. */
    apply(next: Settings): void {
      settings = next;
      lights.apply(settings);
      const tilt = settings.upAxis === 'z' ? -Math.PI / 2 : 0;
      if (upright.rotation.x !== tilt) {
        upright.rotation.x = tilt;
        measureBounds();
      }
      renderer.setClearColor(settings.paper, 1);
      model?.apply(settings);
      scheduler.invalidate();
    },

    /** Whether there is all it takes to draw. */
    get isComplete(): boolean {
      return model !== undefined && map !== undefined;
    },

    dispose(): void {
      sizes.disconnect();
      view.dispose();
      scheduler.dispose();
      timer.reset();
      previousModel?.dispose();
      model?.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}
