import { Group, MathUtils, type Matrix4, Scene, Vector3, WebGLRenderer } from 'three';
import { MovingResolution, type TonalArtMap } from 'three-hatching';
import type { HatchedModel } from '../drawing/HatchedModel.js';
import { releaseGraphics } from '../drawing/releaseGraphics.js';
import { Slices } from '../files/common/Slices.js';
import { drawnSettings } from '../settings/drawnSettings.js';
import { SETTING_KEYS, SETTINGS, type Settings } from '../settings/settings.js';
import { drawsWithMap, UPRIGHT } from '../settings/settingValues.js';
import { CrossFade } from './CrossFade.js';
import { createCamera, DEFAULT_VIEW } from './createCamera.js';
import { FrameScheduler } from './FrameScheduler.js';
import { fullPixelRatio } from './fullPixelRatio.js';
import { Ground } from './Ground.js';
import type { LastPicture } from './LastPicture.js';
import { LightRig } from './LightRig.js';
import { LostContextError } from './LostContextError.js';
import type { Layer } from './layers.js';
import { ProgramBuilder } from './ProgramBuilder.js';
import { strokeShare } from './strokeShare.js';
import { View } from './View.js';

/** Pixels of the longer side of a picture that is larger than a screen. */
const LARGE = 2048;

/** Renderer, camera, lights and one model, drawn with one technique or with two side by side. */
export type HatchingScene = ReturnType<typeof createScene>;

/**
 * The first frame of a model is a sketch, so that there is something to see early on a slow machine: in a lower resolution, by this
 * factor per side, without lines and ground, whose programs are built later.
 */
const SKETCH_SHARE = 0.5;
/** A sketch of a stand-in that takes longer stays until the model itself is there. */
const LONG_MILLISECONDS = 500;

/** Of a comparison. */
const SIDES = ['drawn', 'compared'] as const;
/** The settings that programs depend on are among those that are chosen from a list. */
const CHOICES = SETTING_KEYS.filter((name) => SETTINGS[name].kind === 'choice');

/** The part of a picture that is drawn into the canvas at once, in the renderer's pixels. */
interface Tile {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
}

/** A picture that is drawn in tiles: where it lies on the whole view of the page, in pixels of the picture. */
interface TiledPicture {
  viewWidth: number;
  viewHeight: number;
  left: number;
  top: number;
  /** Pixels of the picture per CSS pixel of the page, by which strokes and lines are sized. */
  scale: number;
}

/** A part of a picture, in its pixels. */
interface Part {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** How a picture is drawn: on which ground, and what of it. */
export interface PictureLook {
  ground: Settings['pictureGround'];
  /** One layer alone, on a transparent ground. */
  layer?: Layer;
}

/** Sets up the scene on a canvas. A frame is drawn after `invalidate`, and when the viewport changes its size. */
export function createScene(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, viewport: HTMLElement) {
  const renderer = new WebGLRenderer({ canvas, context });
  // Costs nothing while no light casts a shadow. Drawn anew where something moves that casts one, not where the camera does.
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  const scene = new Scene();
  const camera = createCamera();
  const lights = new LightRig(scene);
  /** Holds the model, turned so that its up axis is y. */
  const upright = new Group();
  scene.add(upright);
  let model: HatchedModel | undefined;
  /** Kept until the new model has been drawn, so that programs used by both are not compiled again. */
  let previousModels: HatchedModel[] = [];
  /** The model that a stand-in has taken the place of: it comes back if the one that is waited for does not come. */
  let replacedModel: HatchedModel | undefined;
  /** The directions from which the model, and the replaced one, are seen when they are framed. */
  let firstView: readonly [number, number, number] = DEFAULT_VIEW;
  let replacedView = firstView;
  let isStandIn = false;
  /** Whether the first frame of a model is being drawn: see {@link SKETCH_SHARE}. */
  let isSketch = false;
  let map: TonalArtMap | undefined;
  let settings: Settings | undefined;
  let upAxis: Settings['upAxis'] = 'y';
  /** Whether the model throws a shadow on what it stands on, for which it goes aside. */
  let showsShadow = false;

  const frameListeners: (() => void)[] = [];
  const scheduler = new FrameScheduler(() => {
    // The last frame stays until then.
    if (!builder.isBuilding) draw();
  });
  const builder = new ProgramBuilder(renderer, () => scheduler.invalidate());
  /** What programs depend on, as it was when they were last built. */
  let builtFor = '';
  const ground = new Ground(scene, () => scheduler.invalidate());
  const resolution = new MovingResolution(renderer, {
    onRest: () => scheduler.invalidate(),
    onMeasured: () => {
      if (!isSketch) {
        for (const listener of timeListeners) listener();
      } else if (!isStandIn || resolution.milliseconds! < LONG_MILLISECONDS) {
        // A whole frame of a stand-in that takes long would only delay the model itself.
        finishSketch();
      }
    },
  });
  const timeListeners: (() => void)[] = [];
  const view = new View(
    canvas,
    camera,
    () => {
      isOutdated = true;
      scheduler.invalidate();
    },
    (outline, toEye) => (showsShadow ? lights.shadowOf(outline, ground.height, toEye) : undefined),
  );
  const crossFade = new CrossFade(canvas);
  /** From the first loss of the context on: pages that have lost it once are those that lose it again. */
  let lastPicture: LastPicture | undefined;
  let lastFrame = 0;
  /** Share of the width that shows the compared technique; undefined if nothing is compared. */
  let divider: (() => number) | undefined;

  /** Whether a picture is being drawn in tiles: nothing may move, and the canvas holds the latest tile. */
  let isHeld = false;
  /** Whether what the tiles show was changed meanwhile. */
  let isOutdated = false;

  function draw(): void {
    if (isHeld) return;
    const { clientWidth: width, clientHeight: height } = viewport;
    if (context.isContextLost() || width === 0 || height === 0) return;
    resolution.frame(() => drawFrame(width, height));
    if (isStandIn) crossFade.keep();
    else crossFade.start();
    if (!isSketch) disposePrevious();
    lastPicture?.frameDrawn();
    for (const listener of frameListeners) listener();
    if (model?.motion?.isPlaying) scheduler.invalidate();
  }

  function drawFrame(width: number, height: number): void {
    advanceMotion();
    const isLightMoved = settings !== undefined && lights.place(camera);
    if (isLightMoved || model?.motion) renderer.shadowMap.needsUpdate = true;
    const { needsUpdate } = renderer.shadowMap;
    if (lights.setShadowQuality(isCoarse() ? 'coarse' : 'usual', needsUpdate)) renderer.shadowMap.needsUpdate = true;
    if (isSketch) {
      model?.showLines(false);
      ground.hide();
    }
    const share = isSketch ? SKETCH_SHARE : resolution.scale;
    const pixelRatio = fullPixelRatio(width, height) * share;
    if (renderer.getPixelRatio() !== pixelRatio) renderer.setPixelRatio(pixelRatio);
    drawTile({ viewWidth: width, x: 0, width, height }, pixelRatio, share);
  }

  /** Draws the picture once more, which is no movement. @returns whether there is one */
  function redraw(): boolean {
    const { clientWidth: width, clientHeight: height } = viewport;
    if (isHeld || context.isContextLost() || width === 0 || height === 0) return false;
    drawTile({ viewWidth: width, x: 0, width, height }, renderer.getPixelRatio());
    return true;
  }

  function disposePrevious(): void {
    for (const previous of previousModels) previous.dispose();
    previousModels = [];
  }

  const isCoarse = (): boolean => resolution.scale < 1;

  /** Puts `next` in the place of the present model, which is returned. */
  function exchange(next: HatchedModel): HatchedModel | undefined {
    isOutdated = true;
    const before = model;
    before?.root.removeFromParent();
    model = next;
    upright.add(next.root);
    builtFor = '';
    resolution.reset();
    if (map) next.tonalArtMap = map;
    return before;
  }

  /** The first frame of a model is on the page: the rest is added in the next one. */
  function finishSketch(): void {
    isSketch = false;
    resolution.reset();
    applyToScene();
  }

  /** Draws the model that was put in the place of another. `first` is the direction to the eye when it is framed. */
  function showPresent(first: readonly [number, number, number]): void {
    firstView = first;
    applyToScene();
    measureBounds(first);
    scheduler.invalidate();
  }

  /** Advances the model's animation by the time since the last frame. */
  function advanceMotion(): void {
    const now = performance.now();
    model?.motion?.advance((now - lastFrame) / 1000);
    lastFrame = now;
  }

  /**
   * Draws one tile of a picture that is `viewWidth` wide. The tile begins `x` pixels from the left and fills the
   * canvas. The tile of an ordinary frame is the whole picture.
   *
   * @param pixelRatio pixels of the picture per CSS pixel; the widths of strokes and lines go with it
   * @param share of the full resolution, where it is drawn in a lower one
   */
  function drawTile({ viewWidth, x, width, height }: Tile, pixelRatio: number, share = 1): void {
    const shown = divider?.();
    if (settings) setWidths(settings, pixelRatio, share);
    model?.useMaterials('drawn');
    if (shown === undefined) {
      renderer.render(scene, camera);
      return;
    }
    const split = MathUtils.clamp(Math.round(shown * viewWidth) - x, 0, width);
    renderer.setScissorTest(true);
    renderer.setScissor(split, 0, width - split, height);
    if (split < width) renderer.render(scene, camera);
    model?.useMaterials('compared');
    renderer.setScissor(0, 0, split, height);
    if (split > 0) renderer.render(scene, camera);
    renderer.setScissorTest(false);
  }

  function setWidths(settings: Settings, pixelRatio: number, share = 1): void {
    const strokeRatio = pixelRatio * strokeShare(viewport.clientWidth, viewport.clientHeight);
    model?.setWidths(settings, strokeRatio, share);
    ground.setWidths(settings, strokeRatio, share);
  }

  function resize(): void {
    const { clientWidth: width, clientHeight: height } = viewport;
    if (width === 0 || height === 0) return;
    isOutdated = true;
    if (isHeld) return;
    renderer.setPixelRatio(fullPixelRatio(width, height) * resolution.scale);
    renderer.setSize(width, height, false);
    view.resized(width / height);
    resolution.reset();
    // At once and not in the next frame, because resizing clears the canvas.
    draw();
  }

  function drawPart({ viewWidth, viewHeight, left, top, scale }: TiledPicture, { x, y, width, height }: Part): void {
    if (isOutdated) throw new Error('The drawing was changed while it was being saved; save it again.');
    // Even the same size would give the canvas new memory.
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
    camera.setViewOffset(viewWidth, viewHeight, left + x, top + y, width, height);
    drawTile({ viewWidth, x: left + x, width, height }, scale);
    camera.clearViewOffset();
    throwIfLost();
  }

  function throwIfLost(): void {
    if (context.isContextLost()) throw new LostContextError();
  }

  /** Shows or hides the paper. Without it, only strokes are drawn. */
  function showPaper(shown: boolean): void {
    model?.showPaper(shown);
    ground.showPaper(shown);
  }

  /** Draws one layer alone, on a transparent ground; or all of them again. */
  function showLayer(layer: Layer | undefined): void {
    if (!settings) return;
    model?.showLayer(layer, settings);
    ground.showLayer(layer, settings);
  }

  function measureBounds(first?: readonly [number, number, number]): void {
    upright.updateMatrix();
    if (!model) return;
    const bounds = model.bounds.clone().applyMatrix4(upright.matrix);
    ground.height = bounds.min.y;
    view.setOutline(turned(model.outline, upright.matrix), first);
  }

  /** Applies the settings to the lights, the model and what it stands on. Shadows stay as they are. */
  function applyToScene(): void {
    if (!settings) return;
    lights.apply(settings);
    const hadShadow = showsShadow;
    showsShadow = settings.shadows === 'on' && settings.ground !== 'none';
    if (upAxis !== settings.upAxis) {
      upAxis = settings.upAxis;
      upright.rotation.set(...UPRIGHT[upAxis]);
      renderer.shadowMap.needsUpdate = true;
      measureBounds();
    } else if (showsShadow !== hadShadow && view.isFramed) view.frame();
    renderer.setClearColor(settings.paper, 1);
    model?.apply(settings);
    ground.apply(settings);
    buildPrograms(settings);
    scheduler.invalidate();
  }

  /** Numbers and colours build no programs. */
  function buildPrograms(settings: Settings): void {
    // The few of a sketch are built by its frame.
    if (isSketch || !model || context.isContextLost()) return;
    const key = CHOICES.map((name) => settings[name]).join();
    if (key === builtFor) return;
    builtFor = key;
    // Lines that are not drawn by hand have a program of their own.
    setWidths(settings, renderer.getPixelRatio());
    builder.build(() => {
      for (const side of settings.compare === 'none' ? SIDES.slice(0, 1) : SIDES) {
        model?.useMaterials(side);
        renderer.compile(scene, camera);
      }
    });
  }

  function applyDrawn(): void {
    applyToScene();
    renderer.shadowMap.needsUpdate = true;
  }

  const onLost = (): void => {
    if (isSketch) finishSketch();
    resolution.reset();
    builder.stop();
    builtFor = '';
    disposePrevious();
    releaseGraphics(scene);
    if (replacedModel) {
      releaseGraphics(replacedModel.root);
      replacedModel.releaseMaterials();
    }
    model?.releaseMaterials();
    lastPicture?.lost();
  };
  const onRestored = (): void => {
    renderer.shadowMap.needsUpdate = true;
    // three.js goes back to black, which saved pictures would have between strokes.
    if (settings) renderer.setClearColor(settings.paper, 1);
    if (lastPicture) lastPicture.restored();
    else void keepLastPicture();
  };

  async function keepLastPicture(): Promise<void> {
    // Without it the page goes on as before.
    const part = await import('./LastPicture.js').catch(() => undefined);
    if (!part || lastPicture) return;
    lastPicture = new part.LastPicture(canvas, redraw);
    scheduler.invalidate();
  }

  canvas.addEventListener('webglcontextlost', onLost);
  canvas.addEventListener('webglcontextrestored', onRestored);
  const resizeObserver = new ResizeObserver(resize);
  resizeObserver.observe(viewport);
  resize();

  return {
    canvas,
    renderer,
    scene,
    camera,
    view,
    lights,
    lightPosition: lights.position,
    secondLightPosition: lights.secondPosition,
    draw,

    /** Draws the picture that is shown once more, so that it can be copied in the same task. @returns whether there is one */
    redraw,

    /**
     * Stops frames and animation, so that a picture can be drawn in tiles, until {@link release}.
     *
     * @param size pixels of the longer side of the picture
     */
    hold(size: number): void {
      if (isSketch) finishSketch();
      isHeld = true;
      isOutdated = false;
      if (lights.setShadowQuality(size > LARGE ? 'fine' : 'usual', true)) renderer.shadowMap.needsUpdate = true;
    },

    /** Goes on with frames: draws one at once, so that the page never shows a tile. */
    release(): void {
      isHeld = false;
      resize();
    },

    /** Whether the view, the model or the settings have changed since {@link hold}. */
    get isOutdated(): boolean {
      return isOutdated;
    },

    /** Shows, while the scene is held, what a picture is to show; until {@link endPicture}. */
    beginPicture({ ground: onto, layer }: PictureLook): void {
      renderer.setPixelRatio(1);
      if (onto !== 'paper' || layer) renderer.setClearAlpha(0);
      if (layer) showLayer(layer);
      else if (onto === 'strokes') showPaper(false);
    },

    endPicture(): void {
      showLayer(undefined);
      renderer.setClearAlpha(1);
    },

    /**
     * Draws one tile of a picture that was begun into the canvas, which keeps it until the end of the task.
     *
     * @param tile its place in the picture, in pixels
     * @throws Error with a sentence for the user
     */
    drawPart,

    /**
     * Draws one tile of a picture that was begun, and reads its pixels: RGBA multiplied with alpha, the lowest row first.
     *
     * @param tile its place in the picture, in pixels
     * @param pixels to be filled
     * @throws Error with a sentence for the user
     */
    readTile(picture: TiledPicture, tile: Part, pixels: Uint8Array): void {
      drawPart(picture, tile);
      context.readPixels(0, 0, tile.width, tile.height, context.RGBA, context.UNSIGNED_BYTE, pixels);
      throwIfLost();
    },

    /** Has shadows drawn anew, because something has moved that casts or throws them. */
    outdateShadows(): void {
      renderer.shadowMap.needsUpdate = true;
    },

    /** Calls back after each frame. */
    onFrame(listener: () => void): void {
      frameListeners.push(listener);
    },

    /** Calls back when {@link frameMilliseconds} was measured anew. */
    onFrameTime(listener: () => void): void {
      timeListeners.push(listener);
    },

    /** The time a frame takes, or undefined before one was measured. */
    get frameMilliseconds(): number | undefined {
      return resolution.milliseconds;
    },

    /** Whether the graphics context is lost. What is changed meanwhile is drawn when it comes back. */
    get isLost(): boolean {
      return context.isContextLost();
    },

    /** Whether the last picture before the loss of the context is on the page. */
    get showsLastPicture(): boolean {
      return context.isContextLost() && lastPicture?.isKept === true;
    },

    /** Whether frames are drawn in a lower resolution, because the machine is too slow for the movement. */
    get isCoarse(): boolean {
      return isCoarse();
    },

    get framesDrawn(): number {
      return scheduler.frames;
    },

    /** Whether a frame was requested and is not drawn yet, or a model was drawn as a sketch only. */
    get isWaiting(): boolean {
      return scheduler.isWaiting || builder.isBuilding || (isSketch && !context.isContextLost());
    },

    /** Requests one frame. */
    invalidate(): void {
      scheduler.invalidate();
    },

    /**
     * Gives a model the look of the settings before it is set, in slices, so that {@link setModel} finds little to do. Rejects with the
     * signal's reason.
     */
    async dress(next: HatchedModel, signal: AbortSignal): Promise<void> {
      const slices = new Slices(signal);
      if (map) next.tonalArtMap = map;
      for (const _ of settings ? next.applying(settings) : []) await slices.next();
      signal.throwIfAborted();
    },

    /**
     * Replaces the model and disposes the previous one. `first` is the direction to the eye when the model is framed.
     */
    setModel(next: HatchedModel, first: readonly [number, number, number] = DEFAULT_VIEW): void {
      disposePrevious();
      const before = exchange(next);
      previousModels = [before, replacedModel].filter((one) => one !== undefined);
      // After a stand-in all programs are there, and its shadows are those of the model.
      isSketch = !isStandIn && !context.isContextLost();
      if (!isStandIn) renderer.shadowMap.needsUpdate = true;
      isStandIn = false;
      replacedModel = undefined;
      showPresent(first);
    },

    /** Shows a model until {@link setModel} sets the one that is waited for, or {@link removeStandIn} brings back the one before. */
    setStandIn(next: HatchedModel, first: readonly [number, number, number] = DEFAULT_VIEW): void {
      disposePrevious();
      const before = exchange(next);
      if (isStandIn) {
        if (before) previousModels.push(before);
      } else {
        replacedModel = before;
        replacedView = firstView;
      }
      isStandIn = true;
      isSketch = !context.isContextLost();
      renderer.shadowMap.needsUpdate = true;
      showPresent(first);
    },

    /** Takes away the stand-in, if one is shown. */
    removeStandIn(): void {
      if (!isStandIn) return;
      disposePrevious();
      if (model) previousModels.push(model);
      model?.root.removeFromParent();
      model = undefined;
      if (replacedModel) exchange(replacedModel);
      replacedModel = undefined;
      isStandIn = false;
      isSketch = false;
      crossFade.forget();
      renderer.shadowMap.needsUpdate = true;
      showPresent(replacedView);
    },

    /** Whether the model only stands in for one that is still being baked. */
    get isStandIn(): boolean {
      return isStandIn;
    },

    get model(): HatchedModel | undefined {
      return model;
    },

    setTonalArtMap(next: TonalArtMap): void {
      map = next;
      isOutdated = true;
      if (model) model.tonalArtMap = map;
      ground.tonalArtMap = map;
      scheduler.invalidate();
    },

    get tonalArtMap(): TonalArtMap | undefined {
      return map;
    },

    /**
     * Shows the compared technique left of a divider. `share` returns its place in every frame; undefined ends the
     * comparison.
     */
    compareWith(share: (() => number) | undefined): void {
      divider = share;
      scheduler.invalidate();
    },

    /** Applies the settings. Cheap: at most a program is compiled, where a setting needs another one. */
    apply(next: Settings): void {
      settings = drawnSettings(next);
      isOutdated = true;
      applyDrawn();
    },

    /** How high the ground under the model lies. */
    get groundHeight(): number {
      return ground.height;
    },

    /** Whether there is a model, and a map if one is drawn with. */
    get isComplete(): boolean {
      return model !== undefined && (map !== undefined || (settings !== undefined && !drawsWithMap(settings)));
    },

    dispose(): void {
      resizeObserver.disconnect();
      canvas.removeEventListener('webglcontextlost', onLost);
      canvas.removeEventListener('webglcontextrestored', onRestored);
      lastPicture?.dispose();
      view.dispose();
      scheduler.dispose();
      resolution.dispose();
      builder.stop();
      disposePrevious();
      replacedModel?.dispose();
      crossFade.dispose();
      model?.dispose();
      ground.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

/** Points, given as xyz, after a rotation. */
function turned(points: Float32Array, rotation: Matrix4): Float32Array {
  const point = new Vector3();
  const result = points.slice();
  for (let i = 0; i < points.length; i += 3) point.fromArray(points, i).applyMatrix4(rotation).toArray(result, i);
  return result;
}
