import {
  Box3,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  MathUtils,
  Mesh,
  NoBlending,
  NormalBlending,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { HatchingMaterial, type TonalArtMap } from 'three-hatching';
import { applyToMaterial, TEXELS_PER_STROKE } from './applyToMaterial.js';
import type { DrawnModel } from './DrawnModel.js';
import { FrameClock } from './FrameClock.js';
import { FrameTimer } from './FrameTimer.js';
import { framingDistance } from './framingDistance.js';
import { LightRig } from './LightRig.js';
import { MovingResolution } from './MovingResolution.js';
import { OrbitKeys } from './OrbitKeys.js';
import type { Settings } from './settings.js';
import type { CameraView } from './shareLink.js';

const FIELD_OF_VIEW = 26;
/** The direction most models are looked at from at first: a little from the side and from above. */
const USUAL_VIEW = [0.22, 0.18, 1] as const;
const MAX_PIXEL_RATIO = 2;
/** A desk-filling sheet on a large screen is drawn with fewer pixels than it has, rather than slowly. */
const MAX_PIXELS = 8_000_000;

/** The picture: renderer, camera, lights, and one model drawn with one material or, compared, with two. */
export type HatchingScene = ReturnType<typeof createScene>;

/** A strip of a view, in the renderer's pixels. */
interface Piece {
  viewWidth: number;
  x: number;
  width: number;
  height: number;
}

/**
 * Sets up the drawing on a canvas. Nothing is drawn until `invalidate` is called, and then once.
 */
export function createScene(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, plate: HTMLElement) {
  const renderer = new WebGLRenderer({ canvas, context });
  const scene = new Scene();
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 100);
  const controls = new OrbitControls(camera, canvas);
  const lights = new LightRig(scene);
  const material = new HatchingMaterial();
  const compared = new HatchingMaterial();
  let strokeWidth = 2;
  const mesh = new Mesh(new BufferGeometry(), material);
  mesh.visible = false;
  scene.add(mesh);
  controls.minDistance = 1.3;
  controls.maxDistance = 30;

  const frameListeners: (() => void)[] = [];
  const clock = new FrameClock(() => draw());
  const moving = new MovingResolution(() => clock.invalidate());
  const timer = new FrameTimer(context, () => {
    moving.measured(timer.milliseconds!);
    for (const listener of timeListeners) listener();
  });
  const timeListeners: (() => void)[] = [];
  /** Share of the width that is drawn with the compared material, or undefined when there is one drawing only. */
  let divider: (() => number) | undefined;

  function draw(): void {
    const { clientWidth: width, clientHeight: height } = plate;
    if (context.isContextLost() || width === 0 || height === 0) return;
    moving.beforeFrame();
    if (renderer.getPixelRatio() !== pixelRatio()) renderer.setPixelRatio(pixelRatio());
    timer.measure(() => drawPiece({ viewWidth: width, x: 0, width, height }, renderer.getPixelRatio()));
    for (const listener of frameListeners) listener();
  }

  /**
   * Draws an upright strip of the view into the canvas as it is sized now: the strip begins `x` pixels from the left of a
   * view that is `viewWidth` wide. The strip of an ordinary frame is the whole view.
   *
   * @param pixelRatio pixels drawn per pixel of the page: strokes are as many times as wide, their edges as sharp
   */
  function drawPiece({ viewWidth, x, width, height }: Piece, pixelRatio: number): void {
    const share = divider?.();
    for (const each of [material, compared]) each.texelPixels = (strokeWidth / TEXELS_PER_STROKE) * pixelRatio;
    mesh.material = material;
    if (share === undefined) {
      renderer.render(scene, camera);
      return;
    }
    const split = MathUtils.clamp(Math.round(share * viewWidth) - x, 0, width);
    renderer.setScissorTest(true);
    renderer.setScissor(split, 0, width - split, height);
    if (split < width) renderer.render(scene, camera);
    mesh.material = compared;
    renderer.setScissor(0, 0, split, height);
    if (split > 0) renderer.render(scene, camera);
    renderer.setScissorTest(false);
  }

  /** Draws on paper, or strokes and nothing else: a surface without paper still hides what is behind it. */
  function showPaper(shown: boolean): void {
    for (const each of [material, compared]) {
      each.paperOpacity = shown ? 1 : 0;
      // Written as it is instead of blended, so that no stroke of the far side shows between those of the near one.
      each.blending = shown ? NormalBlending : NoBlending;
      each.premultipliedAlpha = !shown;
      each.needsUpdate = true;
    }
  }

  function pixelRatio(): number {
    const { clientWidth: width, clientHeight: height } = plate;
    const full = Math.min(devicePixelRatio, MAX_PIXEL_RATIO, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));
    return full * moving.share;
  }

  function resize(): void {
    const { clientWidth: width, clientHeight: height } = plate;
    if (width === 0 || height === 0) return;
    renderer.setPixelRatio(pixelRatio());
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (framed) frameModel();
    timer.reset();
    // At once, not in the next frame: a canvas that changed its size is empty until it is drawn.
    draw();
  }

  /** Whether the view is the one that shows the whole model; it follows changes of the sheet's size then. */
  let framed = true;
  const firstView = new Vector3(...USUAL_VIEW);
  const bounds = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  let isFraming = false;

  function measureBounds(): void {
    if (mesh.geometry.hasAttribute('position')) bounds.setFromObject(mesh);
  }

  function frameModel(): void {
    isFraming = true;
    controls.target.set(0, 0, 0);
    camera.position.copy(firstView).setLength(framingDistance(bounds, firstView, camera));
    controls.update();
    isFraming = false;
    framed = true;
    clock.invalidate();
  }

  controls.addEventListener('change', () => {
    if (!isFraming) framed = false;
    clock.invalidate();
  });
  const keys = new OrbitKeys(canvas, camera, controls, frameModel);
  canvas.addEventListener('dblclick', frameModel);
  const sizes = new ResizeObserver(resize);
  sizes.observe(plate);
  resize();

  return {
    renderer,
    scene,
    camera,
    controls,
    material,
    compared,
    lightPosition: lights.position,
    draw,
    drawPiece,
    showPaper,
    frameModel,

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
      return moving.isCoarse;
    },

    get framesDrawn(): number {
      return clock.frames;
    },

    /** Whether a frame was asked for that is not drawn yet. */
    get isWaiting(): boolean {
      return clock.isWaiting;
    },

    /** Asks for one frame. */
    invalidate(): void {
      clock.invalidate();
    },

    /** Draws a model from now on, and frees the one before. `view` is the direction to the eye that shows it whole. */
    setModel(model: DrawnModel, view: readonly [number, number, number] = USUAL_VIEW): void {
      firstView.set(...view);
      mesh.geometry.dispose();
      mesh.geometry = model.geometry;
      mesh.visible = true;
      timer.reset();
      measureBounds();
      if (framed) frameModel();
      for (const each of [material, compared]) {
        // An open surface shows its inside.
        each.side = model.borderEdges > 0 || model.nonManifoldEdges > 0 ? DoubleSide : FrontSide;
        each.vertexColors = model.hasColors;
        each.needsUpdate = true;
      }
      clock.invalidate();
    },

    setTonalArtMap(map: TonalArtMap): void {
      material.tonalArtMap = map;
      compared.tonalArtMap = map;
      clock.invalidate();
    },

    get tonalArtMap(): TonalArtMap | undefined {
      return material.tonalArtMap ?? undefined;
    },

    /** Draws a second technique left of a divider, whose place is asked for with every frame; or no longer does. */
    compareWith(share: (() => number) | undefined): void {
      divider = share;
      clock.invalidate();
    },

    /** Puts the settings in force. Cheap: nothing is rebuilt but, where a setting needs another program, that. */
    apply(settings: Settings): void {
      lights.apply(settings);
      const tilt = settings.upAxis === 'z' ? -Math.PI / 2 : 0;
      if (mesh.rotation.x !== tilt) {
        mesh.rotation.x = tilt;
        measureBounds();
      }
      renderer.setClearColor(settings.paper, 1);
      strokeWidth = settings.strokeWidth;
      applyToMaterial(material, settings);
      applyToMaterial(compared, settings, settings.compare === 'none' ? settings.technique : settings.compare);
      clock.invalidate();
    },

    /** Whether there is all it takes to draw. */
    get isComplete(): boolean {
      return mesh.visible && material.tonalArtMap !== null;
    },

    isFramed(): boolean {
      return framed;
    },

    getView(): CameraView {
      return { position: camera.position.toArray(), target: controls.target.toArray() };
    },

    setView({ position, target }: CameraView): void {
      camera.position.fromArray(position);
      controls.target.fromArray(target);
      controls.update();
      clock.invalidate();
    },

    dispose(): void {
      sizes.disconnect();
      keys.dispose();
      controls.dispose();
      clock.dispose();
      timer.reset();
      mesh.geometry.dispose();
      material.dispose();
      compared.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}
