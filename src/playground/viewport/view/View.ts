import { MathUtils, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { DEFAULT_VIEW } from '../../../viewer/sceneSetup/createCamera.js';
import { WHOLE_SHEET } from '../../../viewer/sceneSetup/fadeOnSheet.js';
import { type Framing, fitCamera, proportionOf, SHADOW_ROOM } from '../../../viewer/sceneSetup/framing.js';
import type { LensCamera } from '../../../viewer/sceneSetup/LensCamera.js';
import { roomiestView } from '../../../viewer/sceneSetup/placeCamera.js';
import type { CameraLens, CameraView } from '../../../viewer/settings/CameraView.js';
import { OrbitKeys } from './OrbitKeys.js';
import { turnedView } from './turnedView.js';

/** The smallest distance from the point that the camera orbits, in radii of the model: near enough to look into a room. */
const MIN_DISTANCE = 0.15;
/** The greatest one, unless the camera of a file is farther away. */
const MAX_DISTANCE = 30;
/** Share of the viewport that a model fills, of its width or its height: about two thirds of the sheet with its caption. */
const FILL = 0.76;
/** The same share for a sheet of paper, which holds nothing but the drawing. */
const ON_SHEET = { fill: 0.86, room: SHADOW_ROOM };
/** On a phone that is held upright, models go nearer to the sides. */
const UPRIGHT = { aspect: 0.65, fill: 0.9, room: { model: 0.94, shadow: 0.93, smaller: 1.18 } };
/** The shares of its width and height that they fill there at least, with room for their shadow. Those that are wide are turned for it. */
const UPRIGHT_LEAST = { width: 0.56, height: 0.41 };
/** What is framed before there is a model. */
const NO_OUTLINE = [-1, -1, -1, 1, 1, 1];

/** The view as Undo goes back to it. */
export interface ViewState extends CameraView {
  /** The viewport and the sheet that the model was framed for, in words of the view; none if the user has placed the camera. */
  framedFor?: string | undefined;
}

/** How a model is framed: points on its outer parts as xyz, the direction to the eye, and what {@link fitCamera} takes. */
interface ModelFraming extends Framing {
  outline: ArrayLike<number>;
  first: Vector3;
}

/** Controls the camera: orbited by the user, or placed so that the whole model is in the picture. */
export class View {
  readonly controls: OrbitControls;
  /** How many times wider than high the model is where it is framed. */
  proportion = 1;
  /** Called when the user has moved the camera. */
  onMoved: () => void = () => {};
  /** The viewport and the sheet that the model was framed for, empty before it was; undefined if the user has placed the camera. */
  private framedFor: string | undefined = '';
  private frames = 0;
  private isPlacing = false;
  private readonly first = new Vector3(...DEFAULT_VIEW);
  private outline: ArrayLike<number> = NO_OUTLINE;
  /** The shape of the viewport: that of the camera is another one while pictures are drawn. */
  private aspect = 1;
  private shownSheet: readonly [number, number] | undefined;

  /**
   * @param onChange called when a frame must be drawn
   * @param shadowOf xyz of points of the shadow that an outline casts by now, seen from a direction; undefined without one
   */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly camera: LensCamera,
    private readonly onChange: () => void,
    private readonly shadowOf: (outline: ArrayLike<number>, toEye: Vector3) => ArrayLike<number> | undefined,
  ) {
    this.controls = new OrbitControls(camera, canvas);
    this.controls.minDistance = MIN_DISTANCE;
    this.controls.zoomToCursor = true;
    this.controls.maxDistance = MAX_DISTANCE;
    this.controls.addEventListener('change', this.moved);
    // The controls send no event for a very small last step.
    this.controls.addEventListener('end', () => {
      if (this.round()) this.moved();
    });
    new OrbitKeys(canvas, camera, this.controls, this.frameForUser);
    canvas.addEventListener('dblclick', this.frameForUser);
  }

  private readonly moved = (): void => {
    this.takeZoom();
    this.round();
    if (!this.isPlacing) {
      this.framedFor = undefined;
      this.onMoved();
    }
    this.onChange();
  };

  /** As {@link frame}, because the user has asked for it. */
  readonly frameForUser = (): void => {
    this.frame();
    this.onMoved();
  };

  /** Zooms with the wheel only while an element has the focus, so that a page around it can be scrolled. */
  zoomsWhenFocused(element: HTMLElement): void {
    this.controls.enableZoom = false;
    element.addEventListener('focus', () => {
      this.controls.enableZoom = true;
    });
    element.addEventListener('blur', () => {
      this.controls.enableZoom = false;
    });
  }

  /** Whether the camera is where {@link frame} put it. If so, it is placed again for another shape of the viewport, or another sheet. */
  get isFramed(): boolean {
    return this.framedFor !== undefined;
  }

  /** How often a model was framed; 0 while the camera is where the user has placed it. */
  get framedCount(): number {
    return this.isFramed ? this.frames : 0;
  }

  /** xyz of points on the outer parts of the model. */
  get modelOutline(): ArrayLike<number> {
    return this.outline;
  }

  /** Places the camera so that the whole model is in the picture, and its shadow if that is not long. */
  readonly frame = (): void => {
    this.setLens(undefined);
    this.controls.target.copy(this.fit(this.camera));
    this.update();
    this.framedFor = this.frameFor(this.camera.aspect);
    this.frames++;
    this.onChange();
  };

  /** Frames a framed model anew where the viewport or the sheet asks for it. Otherwise the view stays: its lights may have moved since. */
  private frameAnew(): void {
    if (this.isFramed && this.framedFor !== this.frameFor(this.aspect)) this.frame();
  }

  private fit(camera: LensCamera): Vector3 {
    const { outline, first, ...framing } = this.framing;
    return fitCamera(camera, outline, first, framing);
  }

  /**
   * The view of a framed model, as much smaller as it may be drawn to leave room for its shadow: a shadow that lies wholly in the picture
   * is wholly on the sheet when the model is framed with it, and leaves the model in the middle.
   */
  get roomiest(): LensCamera {
    const { outline, first, room = SHADOW_ROOM, ...framing } = this.framing;
    const camera = this.camera.clone();
    roomiestView(camera, outline, first, { ...framing, room });
    return camera;
  }

  /**
   * The sheet in the middle of the viewport that a framed model is composed for, in shares of the viewport's width and height;
   * undefined for the viewport itself.
   */
  get sheet(): readonly [number, number] | undefined {
    return this.shownSheet;
  }

  set sheet(sheet: readonly [number, number] | undefined) {
    this.shownSheet = sheet;
    this.camera.sheet = sheet ?? WHOLE_SHEET;
    this.frameAnew();
  }

  /**
   * Composes a framed model for a sheet that the page does not show.
   *
   * @returns goes back to the sheet of the page, and to the very view before unless it was changed meanwhile
   */
  composeFor(sheet: readonly [number, number] | undefined): () => void {
    const { shownSheet, state, frames } = this;
    this.sheet = sheet;
    const composed = JSON.stringify(this.state);
    return () => {
      const isChanged = JSON.stringify(this.state) !== composed;
      this.sheet = shownSheet;
      if (isChanged) return;
      this.state = state;
      this.frames = frames;
    };
  }

  /** What the model is framed by, as {@link fitCamera} takes it. */
  get framing(): ModelFraming {
    const { outline, first } = this;
    const framing = { outline, first, fill: FILL, ...this.framingForSheet };
    return { ...framing, shadow: this.shadowOf(outline, framing.first) };
  }

  private get framingForSheet(): Partial<ModelFraming> {
    const { outline, first, shownSheet, aspect } = this;
    if (shownSheet) return { ...ON_SHEET, part: shownSheet };
    return aspect < UPRIGHT.aspect ? uprightFraming(outline, first, aspect) : {};
  }

  /**
   * Sets the outline of a new model, or of one that was turned.
   *
   * @param outline xyz of points on its outer parts
   * @param first direction to the eye when the model is framed; undefined keeps the current one
   */
  setOutline(outline: ArrayLike<number>, first?: readonly [number, number, number]): void {
    this.outline = outline;
    if (first) this.first.set(...first);
    this.proportion = proportionOf(outline, this.first);
    if (this.isFramed) this.frame();
  }

  /** To be called when the viewport has changed its size. */
  resized(aspect: number): void {
    this.aspect = aspect;
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.frameAnew();
  }

  get place(): CameraView {
    const { position, lens } = this.camera;
    return { position: position.toArray(), target: this.controls.target.toArray(), ...(lens && { lens }) };
  }

  /** As {@link place}; undefined if the camera is where {@link frame} would put it, as whoever frames the same model will see it. */
  get ownPlace(): CameraView | undefined {
    if (!this.isFramed) return this.place;
    const camera = this.camera.clone();
    const target = roundToSingle(this.fit(camera));
    const isThere = roundToSingle(camera.position).equals(this.camera.position) && target.equals(this.controls.target);
    return isThere ? undefined : this.place;
  }

  set place({ position, target, lens }: CameraView) {
    this.setLens(lens);
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.controls.maxDistance = Math.max(MAX_DISTANCE, this.camera.position.distanceTo(this.controls.target));
    this.update();
    if (lens) {
      // Controls turn a camera a little that looks straight down.
      this.camera.position.fromArray(position);
      this.camera.lookAt(this.controls.target);
    }
    this.framedFor = undefined;
    this.onChange();
  }

  get state(): ViewState {
    return { ...this.place, framedFor: this.framedFor };
  }

  set state({ framedFor, ...place }: ViewState) {
    this.place = place;
    this.framedFor = framedFor;
    this.frameAnew();
  }

  private setLens(lens: CameraLens | undefined): void {
    if (lens !== this.camera.lens) this.camera.lens = lens;
  }

  /** Controls zoom a camera without perspective by its lens, which then is another one. */
  private takeZoom(): void {
    const { zoom } = this.camera;
    if (zoom !== 1) this.camera.widen(1 / zoom);
  }

  private frameFor(aspect: number): string {
    return [aspect, ...(this.shownSheet ?? [])].join();
  }

  /** Takes over where the camera was put. */
  private update(): void {
    this.isPlacing = true;
    this.controls.update();
    this.isPlacing = false;
    this.round();
  }

  /** Keeps the view to single precision, as links do: whoever opens one sees the very same. @returns whether it was finer */
  private round(): boolean {
    const { camera, controls } = this;
    before.position.copy(camera.position);
    before.target.copy(controls.target);
    roundToSingle(camera.position);
    roundToSingle(controls.target);
    if (before.position.equals(camera.position) && before.target.equals(controls.target)) return false;
    camera.lookAt(controls.target);
    return true;
  }
}

function uprightFraming(outline: ArrayLike<number>, first: Vector3, aspect: number): Partial<ModelFraming> {
  const { fill, room } = UPRIGHT;
  const { width, height } = UPRIGHT_LEAST;
  const view = turnedView(outline, first, (fill * aspect) / room.smaller / height);
  const isAsWide = Math.min(1, proportionOf(outline, view) / aspect);
  const smaller = MathUtils.clamp((fill * isAsWide) / width, 1, room.smaller);
  return { first: view, fill, room: { ...room, smaller } };
}

const before = { position: new Vector3(), target: new Vector3() };

/** Distances below this, in radii of the model, are rounding errors. */
const NOTHING = 2 ** -24;

const toSingle = (value: number): number => (Math.abs(value) < NOTHING ? 0 : Math.fround(value));

const roundToSingle = (point: Vector3): Vector3 => point.set(toSingle(point.x), toSingle(point.y), toSingle(point.z));
