import { MathUtils, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Framing, fitCamera, proportionOf, SHADOW_ROOM } from '../../viewer/sceneSetup/framing.js';
import { WHOLE_SHEET } from '../../viewer/sceneSetup/groundShadow.js';
import { DEFAULT_VIEW, type LensCamera } from '../../viewer/sceneSetup/LensCamera.js';
import { roomiestView } from '../../viewer/sceneSetup/placeCamera.js';
import type { CameraLens, CameraView } from '../../viewer/settings/CameraView.js';
import { turnedView } from './turnedView.js';

/** The minimum distance of the camera from its target, in radii of the model: near enough to look into a room. */
const MIN_DISTANCE = 0.15;
/** The maximum distance, unless the camera of a file is farther away. */
const MAX_DISTANCE = 30;
/** The share of the viewport's width or height that a model fills: about two thirds of the sheet with its caption. */
const FILL = 0.76;
/** The same share for a sheet of paper, which holds nothing but the drawing. */
const ON_SHEET = { fill: 0.86, room: SHADOW_ROOM };
/** On a phone in portrait orientation, models come nearer to the sides. */
const UPRIGHT = { aspect: 0.65, fill: 0.9, room: { model: 0.94, shadow: 0.93, smaller: 1.18 } };
/** The minimum shares of width and height that models fill there, with room for their shadow. Wide models are turned to achieve that. */
const UPRIGHT_LEAST = { width: 0.56, height: 0.41 };
/** The points that are framed before there is a model. */
const NO_POINTS = [-1, -1, -1, 1, 1, 1];

/** The view as Undo restores it. */
export interface ViewState extends CameraView {
  /** A key of the viewport and the sheet for which the model was framed; undefined if the user has placed the camera. */
  framedFor?: string | undefined;
}

/** How a model is framed: points on its outer parts as xyz, the direction to the eye, and the options of {@link fitCamera}. */
interface ModelFraming extends Framing {
  framedPoints: ArrayLike<number>;
  first: Vector3;
}

/** Controls the camera: orbited by the user, or placed to frame the model. */
export class View {
  readonly controls: OrbitControls;
  /** The aspect of the model in the direction in which it is framed. */
  proportion = 1;
  /** Called when the user has moved the camera. */
  onMoved: () => void = () => {};
  /**
   * A key of the viewport and the sheet for which the model was framed, empty before the first framing; undefined if the user has placed
   * the camera.
   */
  private framedFor: string | undefined = '';
  private frames = 0;
  private isPlacing = false;
  private readonly first = new Vector3(...DEFAULT_VIEW);
  private points: ArrayLike<number> = NO_POINTS;
  /** The aspect of the viewport; the camera's differs while pictures are drawn. */
  private aspect = 1;
  private shownSheet: readonly [number, number] | undefined;

  /**
   * @param onChange called when a frame must be drawn
   * @param shadowOf xyz of the shadow of points, seen from a direction; undefined without a shadow
   */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly camera: LensCamera,
    private readonly onChange: () => void,
    private readonly shadowOf: (framedPoints: ArrayLike<number>, toEye: Vector3) => ArrayLike<number> | undefined,
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

  /** Calls {@link frame} on the user's request. */
  readonly frameForUser = (): void => {
    this.frame();
    this.onMoved();
  };

  /** Lets the wheel zoom only while an element has the focus, so that a surrounding page can be scrolled. */
  zoomsWhenFocused(element: HTMLElement): void {
    this.controls.enableZoom = false;
    element.addEventListener('focus', () => {
      this.controls.enableZoom = true;
    });
    element.addEventListener('blur', () => {
      this.controls.enableZoom = false;
    });
  }

  /** Whether the camera is where {@link frame} put it. If so, it is placed again for another viewport size or sheet. */
  get isFramed(): boolean {
    return this.framedFor !== undefined;
  }

  /** The number of framings; 0 while the camera is where the user has placed it. */
  get framedCount(): number {
    return this.isFramed ? this.frames : 0;
  }

  /** The direction to the eye when the model is framed. */
  get firstDirection(): Vector3 {
    return this.first;
  }

  /** xyz of points on the outer parts of the model. */
  get framedPoints(): ArrayLike<number> {
    return this.points;
  }

  /** Frames the whole model, and its shadow unless that is long. */
  readonly frame = (): void => {
    this.setLens(undefined);
    this.controls.target.copy(this.fit(this.camera));
    this.update();
    this.framedFor = this.frameFor(this.camera.aspect);
    this.frames++;
    this.onChange();
  };

  /** Frames a framed model again if the viewport or the sheet has changed. Otherwise the view stays: its lights may have moved since. */
  private frameAnew(): void {
    if (this.isFramed && this.framedFor !== this.frameFor(this.aspect)) this.frame();
  }

  /** Frames the whole model from another direction, as if the user had placed the camera there. */
  frameFrom(direction: Vector3): void {
    this.setLens(undefined);
    this.controls.target.copy(this.fit(this.camera, direction));
    this.update();
    this.framedFor = undefined;
    this.onChange();
  }

  private fit(camera: LensCamera, from = this.first): Vector3 {
    const { framedPoints, first, ...framing } = this.framingFrom(from);
    return fitCamera(camera, framedPoints, first, framing);
  }

  /**
   * The view of a framed model, shrunk as far as allowed to leave room for its shadow. A shadow that fits in this picture fits on the sheet
   * when the model is framed with it, without moving the model aside.
   */
  get roomiest(): LensCamera {
    const { framedPoints, first, room = SHADOW_ROOM, ...framing } = this.framing;
    const camera = this.camera.clone();
    roomiestView(camera, framedPoints, first, { ...framing, room });
    return camera;
  }

  /**
   * The sheet in the middle of the viewport for which a framed model is composed, in shares of the viewport's width and height; undefined
   * for the viewport itself.
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
   * @returns a function that restores the sheet of the page, and the exact view before unless it was changed meanwhile
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

  /** The arguments of {@link fitCamera} for the model. */
  get framing(): ModelFraming {
    return this.framingFrom(this.first);
  }

  private framingFrom(first: Vector3): ModelFraming {
    const { framedPoints } = this;
    const framing = { framedPoints, first, fill: FILL, ...this.framingForSheet(first) };
    return { ...framing, shadow: this.shadowOf(framedPoints, framing.first) };
  }

  private framingForSheet(first: Vector3): Partial<ModelFraming> {
    const { framedPoints, shownSheet, aspect } = this;
    if (shownSheet) return { ...ON_SHEET, part: shownSheet };
    return aspect < UPRIGHT.aspect ? uprightFraming(framedPoints, first, aspect) : {};
  }

  /**
   * Sets the points by which a new model, or one that was turned, is framed.
   *
   * @param framedPoints xyz of points on its outer parts
   * @param first direction to the eye when the model is framed; undefined keeps the present one
   */
  setFramedPoints(framedPoints: ArrayLike<number>, first?: readonly [number, number, number]): void {
    this.points = framedPoints;
    if (first) this.first.set(...first);
    this.proportion = proportionOf(framedPoints, this.first);
    if (this.isFramed) this.frame();
  }

  /** Call this when the viewport was resized. */
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

  /** As {@link place}; undefined if the camera is where {@link frame} would put it, so that anyone who frames the model sees the same. */
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
      // The controls turn a camera slightly that looks straight down.
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

  /** The controls zoom an orthographic camera by its lens, which then changes. */
  private takeZoom(): void {
    const { zoom } = this.camera;
    if (zoom !== 1) this.camera.widen(1 / zoom);
  }

  private frameFor(aspect: number): string {
    return [aspect, ...(this.shownSheet ?? [])].join();
  }

  /** Applies the camera's new position. */
  private update(): void {
    this.isPlacing = true;
    this.controls.update();
    this.isPlacing = false;
    this.round();
  }

  /** Rounds the view to single precision, as links do, so that a link shows exactly the same view. @returns whether this changed it */
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

function uprightFraming(framedPoints: ArrayLike<number>, first: Vector3, aspect: number): Partial<ModelFraming> {
  const { fill, room } = UPRIGHT;
  const { width, height } = UPRIGHT_LEAST;
  const view = turnedView(framedPoints, first, (fill * aspect) / room.smaller / height);
  const isAsWide = Math.min(1, proportionOf(framedPoints, view) / aspect);
  const smaller = MathUtils.clamp((fill * isAsWide) / width, 1, room.smaller);
  return { first: view, fill, room: { ...room, smaller } };
}

const before = { position: new Vector3(), target: new Vector3() };

/** Distances below this, in radii of the model, are rounding errors. */
const NOTHING = 2 ** -24;

const toSingle = (value: number): number => (Math.abs(value) < NOTHING ? 0 : Math.fround(value));

const roundToSingle = (point: Vector3): Vector3 => point.set(toSingle(point.x), toSingle(point.y), toSingle(point.z));

const TURN = MathUtils.degToRad(5);
const FINE_TURN = MathUtils.degToRad(1);
const ZOOM = 1.1;

/** Moves the camera by keyboard: arrows orbit (with Shift in small steps), plus and minus zoom, WASD pan, Home frames the model. */
class OrbitKeys {
  constructor(
    element: HTMLElement,
    private readonly camera: LensCamera,
    private readonly controls: OrbitControls,
    private readonly frameModel: () => void,
  ) {
    element.addEventListener('keydown', this.onKey);
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = event.shiftKey ? FINE_TURN : TURN;
    const moves: Record<string, () => void> = {
      arrowleft: () => this.turn(-turn, 0),
      arrowright: () => this.turn(turn, 0),
      arrowup: () => this.turn(0, -turn),
      arrowdown: () => this.turn(0, turn),
      '+': () => this.zoom(1 / ZOOM),
      '=': () => this.zoom(1 / ZOOM),
      '-': () => this.zoom(ZOOM),
      a: () => this.pan(-1, 0),
      d: () => this.pan(1, 0),
      w: () => this.pan(0, 1),
      s: () => this.pan(0, -1),
      home: this.frameModel,
    };
    const move = moves[event.key.toLowerCase()];
    if (!move) return;
    event.preventDefault();
    move();
    this.controls.update();
  };

  private turn(azimuth: number, polar: number): void {
    const offset = new Vector3().subVectors(this.camera.position, this.controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += azimuth;
    spherical.phi += polar;
    spherical.makeSafe();
    this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(spherical));
  }

  private zoom(factor: number): void {
    if (this.camera.lens?.isOrthographic) {
      this.camera.widen(factor);
      this.controls.dispatchEvent({ type: 'change' });
      return;
    }
    const offset = new Vector3().subVectors(this.camera.position, this.controls.target).multiplyScalar(factor);
    offset.clampLength(this.controls.minDistance, this.controls.maxDistance);
    this.camera.position.copy(this.controls.target).add(offset);
  }

  private pan(right: number, up: number): void {
    const step = this.camera.position.distanceTo(this.controls.target) * 0.03;
    const shift = new Vector3(right * step, up * step, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(shift);
    this.controls.target.add(shift);
  }
}
