import { Box2, MathUtils, type PerspectiveCamera, Spherical, Vector2, Vector3 } from 'three';
import { SETTINGS } from '../../viewer/settings/settings.js';
import type { LightPlace } from '../../viewer/settings/settingValues.js';
import {
  intersectSphere,
  isBehind,
  isHidden,
  nearestOutlinePoint,
  radiusWithin,
  Silhouette,
  ViewportProjection,
} from './handleGeometry.js';

const STEP = 5;
const FINE_STEP = 1;
/** The minimum distance of the handle from the viewport's edges, in pixels, so that it can always be grabbed. */
const MARGIN = 26;
/** Closer to an edge than this, in pixels, the hint above the handle is moved so that it is not cut off. */
const HINT_MARGIN = { beside: 44, above: 64 };
/** The radius around a handle that is kept clear of the model, and the maximum move to achieve that, in pixels. */
const CLEAR = { radius: 27, way: 200 };
/** The minimum distance from the model's centre, in pixels, since the light's distance is scaled by a ratio of such distances. */
const MIN_REACH = 32;
/**
 * How far past the outline or the edge of the sheet a drag must go before the light moves behind the model, in pixels, since hands waver.
 */
const PAST_OUTLINE = 14;
/** A sun has no distance: its handle moves over the largest sphere within these limits whose outline is on the sheet. */
const SUN_RADIUS = { min: 0.45, max: 1.45 };

/** What the handle needs from its owner. */
interface LightHandleHost {
  /** The element below the handle. Its client size is the size of the picture. */
  viewport: HTMLElement;
  camera: PerspectiveCamera;
  /** The accessible name of the light. */
  name: string;
  /** The position of the light, in world coordinates. The model's centre is the origin. */
  lightPosition: Vector3;
  /** xyz of points of the model. */
  framedPoints(): ArrayLike<number>;
  /** The number of framings; 0 while the model is not framed. */
  framedCount(): number;
  /** Whether the light's position is relative to the viewer instead of the model. */
  isWithViewer(): boolean;
  /** The position of the light. A sun has no distance. */
  place(): LightPlace;
  /** The position after a double click. */
  home(): LightPlace;
  /** Moves the light. */
  onMove(place: Partial<LightPlace>): void;
  /** A drag begins or ends. The camera must not move meanwhile. */
  onDrag(dragging: boolean): void;
}

/**
 * The handle of a light. Dragging moves it over a sphere around the model; past the sphere's outline, or the edge of the sheet if that is
 * nearer, and back takes it behind the model. Shift or a second finger changes the distance of a point or spot light. Arrow keys move it by
 * 5°, with Shift by 1°. A sun has only a direction, so its handle moves aside from a newly framed model instead of covering it.
 */
export class LightHandle {
  private readonly projection: ViewportProjection;
  /** The handle's position in world coordinates: in the light's direction, at its distance if it has one. */
  private readonly shown = new Vector3();
  /** The offset of the handle from the projected position of the light, in pixels. */
  private readonly aside = new Vector2();
  /** The framing count for which that offset was computed. */
  private framedCount = 0;
  private behind = false;
  private beyondOutline = false;
  private pointer: { id: number; grip: Vector2 } | undefined;
  private second: { id: number; start: number; distance: number } | undefined;

  constructor(
    private readonly element: HTMLElement,
    private readonly host: LightHandleHost,
  ) {
    this.projection = new ViewportProjection(host.viewport, host.camera);
    element.tabIndex = 0;
    element.setAttribute('role', 'slider');
    element.setAttribute('aria-label', host.name);
    element.setAttribute('aria-valuemin', '-180');
    element.setAttribute('aria-valuemax', '180');
    element.title = 'Drag to move the light. Past the edge and back takes it behind the model.';
    element.append(createLampIcon());
    element.addEventListener('pointerdown', this.onPointerDown);
    element.addEventListener('pointermove', this.onPointerMove);
    element.addEventListener('pointerup', this.onPointerEnd);
    element.addEventListener('pointercancel', this.onPointerEnd);
    element.addEventListener('keydown', this.onKeyDown);
    element.addEventListener('dblclick', this.onDoubleClick);
  }

  /** Moves the handle to the light's place in the picture. Call this in every frame. */
  update(): void {
    const { camera } = this.host;
    const { azimuth, elevation, distance } = this.host.place();
    const { width } = this.projection.size;
    this.shown.copy(this.host.lightPosition);
    if (distance === undefined) this.shown.setLength(this.sunRadius());
    this.goAside(distance === undefined);
    const { x: left, y: top } = this.placeOnSheet();
    this.element.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
    this.element.classList.toggle('is-at-left', left < HINT_MARGIN.beside);
    this.element.classList.toggle('is-at-right', left > width - HINT_MARGIN.beside);
    this.element.classList.toggle('is-at-top', top < HINT_MARGIN.above);
    if (!this.pointer) this.behind = isBehind(this.shown, camera.position);
    this.element.classList.toggle('is-behind', isHidden(this.shown, camera.position));
    this.element.setAttribute('aria-valuenow', azimuth.toFixed(0));
    const texts = [
      `${azimuth.toFixed(1)}° around`,
      `${elevation.toFixed(1)}° high`,
      this.behind ? 'behind the model' : 'in front of the model',
    ];
    if (distance !== undefined) texts.push(`${distance.toFixed(2)} radii away`);
    this.element.setAttribute('aria-valuetext', texts.join(', '));
  }

  private readonly onPointerDown = (event: PointerEvent): void => {
    if (this.pointer || event.button !== 0) return;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    // The handle keeps its offset from the pointer, so that it does not jump.
    const grip = this.placeOnSheet().sub(this.projection.pointer(event));
    this.pointer = { id: event.pointerId, grip };
    this.beyondOutline = false;
    this.element.classList.add('is-held');
    addEventListener('pointerdown', this.onSecondPointer, { capture: true });
    this.host.onDrag(true);
  };

  private readonly onPointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer?.id || this.second) return;
    const place = this.projection.pointer(event).add(this.pointer.grip);
    if (event.shiftKey && this.host.place().distance !== undefined) this.moveAway(place);
    else this.moveOverSphere(place);
  };

  private readonly onPointerEnd = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer?.id) return;
    this.pointer = undefined;
    this.second = undefined;
    this.element.classList.remove('is-held');
    removeEventListener('pointerdown', this.onSecondPointer, { capture: true });
    removeEventListener('pointermove', this.onSecondMove, { capture: true });
    removeEventListener('pointerup', this.onSecondEnd, { capture: true });
    removeEventListener('pointercancel', this.onSecondEnd, { capture: true });
    this.host.onDrag(false);
  };

  /** A second finger changes the distance of the light by moving away from the model's centre or towards it. */
  private readonly onSecondPointer = (event: PointerEvent): void => {
    const { distance } = this.host.place();
    if (event.pointerId === this.pointer?.id || this.second || distance === undefined) return;
    event.stopPropagation();
    this.second = { id: event.pointerId, start: this.reach(event), distance };
    addEventListener('pointermove', this.onSecondMove, { capture: true });
    addEventListener('pointerup', this.onSecondEnd, { capture: true });
    addEventListener('pointercancel', this.onSecondEnd, { capture: true });
  };

  private readonly onSecondMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.second?.id) return;
    this.setDistance((this.second.distance * this.reach(event)) / this.second.start);
  };

  private readonly onSecondEnd = (event: PointerEvent): void => {
    if (event.pointerId === this.second?.id) this.second = undefined;
  };

  private readonly onKeyDown = (event: KeyboardEvent): void => {
    const step = event.shiftKey ? FINE_STEP : STEP;
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.turn(-step, 0),
      ArrowRight: () => this.turn(step, 0),
      ArrowUp: () => this.turn(0, step),
      ArrowDown: () => this.turn(0, -step),
      PageUp: () => this.scaleDistance(1.1),
      PageDown: () => this.scaleDistance(1 / 1.1),
      Home: this.onDoubleClick,
    };
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    move();
  };

  private readonly onDoubleClick = (): void => {
    this.host.onMove(this.host.home());
  };

  private turn(around: number, up: number): void {
    const { azimuth, elevation } = this.host.place();
    const { min, max } = SETTINGS.lightElevation;
    this.host.onMove({
      azimuth: MathUtils.euclideanModulo(azimuth + around + 180, 360) - 180,
      elevation: MathUtils.clamp(elevation + up, min, max),
    });
  }

  private setDistance(distance: number): void {
    const { min, max } = SETTINGS.lightDistance;
    this.host.onMove({ distance: MathUtils.clamp(distance, min, max) });
  }

  private scaleDistance(factor: number): void {
    const { distance } = this.host.place();
    if (distance !== undefined) this.setDistance(distance * factor);
  }

  /** Scales the distance of the light by how far it is dragged from the model's centre. */
  private moveAway(place: Vector2): void {
    const centre = this.projection.project(new Vector3());
    const now = Math.max(MIN_REACH, this.projection.project(this.shown).distanceTo(centre));
    const next = Math.max(MIN_REACH, place.distanceTo(centre));
    this.scaleDistance(next / now);
  }

  /** Moves the light to where the ray through `place` meets its sphere, or else to the sphere's outline. */
  private moveOverSphere(place: Vector2): void {
    const seen = place.clone().sub(this.aside);
    const ray = this.projection.ray(seen);
    const radius = this.shown.length();
    const hits = intersectSphere(ray, radius);
    const outline = hits ? undefined : nearestOutlinePoint(ray, radius);
    const past = Math.max(outline ? this.projection.project(outline).distanceTo(seen) : 0, this.pastSheet(place));
    if (past > PAST_OUTLINE) this.beyondOutline = true;
    else if (past === 0 && this.beyondOutline) {
      this.beyondOutline = false;
      this.behind = !this.behind;
    }
    const hit = outline ?? (this.behind ? hits!.far : hits!.near);
    if (this.host.isWithViewer()) hit.applyQuaternion(this.host.camera.quaternion.clone().invert());
    const { theta, phi } = new Spherical().setFromVector3(hit);
    const { min, max } = SETTINGS.lightElevation;
    this.host.onMove({
      azimuth: MathUtils.radToDeg(theta),
      elevation: MathUtils.clamp(90 - MathUtils.radToDeg(phi), min, max),
    });
  }

  /** The radius of the sphere over which a sun's handle moves. */
  private sunRadius(): number {
    const { camera } = this.host;
    const { width, height } = this.projection.size;
    const { x, y } = this.projection.project(new Vector3());
    const room = Math.min(x, y, width - x, height - y) - MARGIN;
    const focalLength = (height / 2) * camera.projectionMatrix.elements[5];
    const isFlat = 'isOrthographicCamera' in camera;
    const radius = isFlat ? room / focalLength : radiusWithin(camera.position.length(), room / focalLength);
    return MathUtils.clamp(radius, SUN_RADIUS.min, SUN_RADIUS.max);
  }

  /** Moves the handle beside a newly framed model. A handle stays once the user has placed it or turned the model. */
  private goAside(isSun: boolean): void {
    const count = this.host.framedCount();
    if (!isSun) this.aside.set(0, 0);
    if (count === 0 || count === this.framedCount || this.pointer) return;
    this.framedCount = count;
    this.aside.set(0, 0);
    if (!isSun) return;
    const silhouette = new Silhouette(this.host.framedPoints(), this.host.camera, this.projection.size);
    const { width, height } = this.projection.size;
    const sheet = new Box2(new Vector2(MARGIN, MARGIN), new Vector2(width - MARGIN, height - MARGIN));
    this.aside.copy(silhouette.wayAround(this.placeOnSheet(), CLEAR.radius, sheet, CLEAR.way));
  }

  /** The handle's position in the picture. */
  private placeOnSheet(): Vector2 {
    const { width, height } = this.projection.size;
    const place = this.projection.project(this.shown).add(this.aside);
    place.x = MathUtils.clamp(place.x, MARGIN, width - MARGIN);
    place.y = MathUtils.clamp(place.y, MARGIN, height - MARGIN);
    return place;
  }

  /** The distance of a place from the allowed area of the handle, in pixels; 0 within it. */
  private pastSheet({ x, y }: Vector2): number {
    const { width, height } = this.projection.size;
    return Math.max(0, MARGIN - x, MARGIN - y, x - (width - MARGIN), y - (height - MARGIN));
  }

  /** The distance of a pointer from the model's centre, in pixels. */
  private reach(event: PointerEvent): number {
    return Math.max(MIN_REACH, this.projection.pointer(event).distanceTo(this.projection.project(new Vector3())));
  }
}

/** The icon of the light handle: a disc with eight rays, styled by the style sheet. */
function createLampIcon(): SVGSVGElement {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '-24 -24 48 48');
  svg.setAttribute('aria-hidden', 'true');
  const rays = Array.from({ length: 8 }, (_, i) => {
    const [x, y] = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
    return `M${(13.5 * x).toFixed(2)} ${(13.5 * y).toFixed(2)}L${(19 * x).toFixed(2)} ${(19 * y).toFixed(2)}`;
  });
  const path = document.createElementNS(svg.namespaceURI, 'path');
  path.setAttribute('d', rays.join(''));
  const disc = document.createElementNS(svg.namespaceURI, 'circle');
  disc.setAttribute('r', '8.5');
  svg.append(path, disc);
  return svg;
}
