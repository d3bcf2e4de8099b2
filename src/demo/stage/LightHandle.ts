import { MathUtils, type PerspectiveCamera, Spherical, type Vector2, Vector3 } from 'three';
import { SETTINGS, type Settings } from '../settings/settings.js';
import { createLampIcon } from './createLampIcon.js';
import { intersectSphere, isBehind, isHidden, nearestOutlinePoint } from './lightSphere.js';
import { ViewportProjection } from './ViewportProjection.js';

type LightPlace = Pick<Settings, 'lightAzimuth' | 'lightElevation' | 'lightDistance'>;

const STEP = 5;
const FINE_STEP = 1;
/** The lamp stays at least this far from the edges of the viewport, in pixels, so that it can always be grabbed. */
const MARGIN = 26;
/** Nearer to an edge than this, the hint below the lamp would be cut off. It is moved then. In pixels. */
const HINT_MARGIN = 76;
/**
 * Distances from the model's centre count as at least this, in pixels: the distance of the light is scaled by their
 * ratio.
 */
const MIN_REACH = 32;

/** What the handle works on. */
export interface LightHandleHost {
  /** The element the handle lies over. Its client size is the size of the picture. */
  viewport: HTMLElement;
  camera: PerspectiveCamera;
  settings: Settings;
  /** The position of the light, in world coordinates. The model's centre is the origin. */
  lightPosition: Vector3;
  /** Moves the light. */
  onMove(place: Partial<LightPlace>): void;
  /** A drag begins or ends. The camera must not move meanwhile. */
  onDrag(dragging: boolean): void;
}

/**
 * The handle of the light. Dragging moves it over a sphere around the model; past the sphere's outline and back takes
 * it behind the model. Shift or a second finger changes the distance of a point light or spot light. Arrow keys move it
 * by 5°, with Shift by 1°.
 */
export class LightHandle {
  private readonly projection: ViewportProjection;
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
    element.setAttribute('aria-label', 'Light');
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

  /** Moves the handle to where the light is seen. To be called with every frame. */
  update(): void {
    const { settings, lightPosition, camera } = this.host;
    const { x, y } = this.projection.project(lightPosition);
    const { width, height } = this.projection.size;
    const left = MathUtils.clamp(x, MARGIN, width - MARGIN);
    const top = MathUtils.clamp(y, MARGIN, height - MARGIN);
    this.element.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
    this.element.classList.toggle('is-at-left', left < HINT_MARGIN);
    this.element.classList.toggle('is-at-right', left > width - HINT_MARGIN);
    this.element.classList.toggle('is-at-bottom', top > height - HINT_MARGIN);
    if (!this.pointer) this.behind = isBehind(lightPosition, camera.position);
    this.element.classList.toggle('is-behind', isHidden(lightPosition, camera.position));
    this.element.setAttribute('aria-valuenow', settings.lightAzimuth.toFixed(0));
    const texts = [
      `${settings.lightAzimuth.toFixed(1)}° around`,
      `${settings.lightElevation.toFixed(1)}° high`,
      this.behind ? 'behind the model' : 'in front of the model',
    ];
    if (settings.lightKind !== 'directional') texts.push(`${settings.lightDistance.toFixed(2)} radii away`);
    this.element.setAttribute('aria-valuetext', texts.join(', '));
  }

  private readonly onPointerDown = (event: PointerEvent): void => {
    if (this.pointer || event.button !== 0) return;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    // The lamp keeps its offset from the pointer, so that it does not jump.
    const grip = this.projection.project(this.host.lightPosition).sub(this.projection.pointer(event));
    this.pointer = { id: event.pointerId, grip };
    this.beyondOutline = false;
    this.element.classList.add('is-held');
    addEventListener('pointerdown', this.onSecondPointer, { capture: true });
    this.host.onDrag(true);
  };

  private readonly onPointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer?.id || this.second) return;
    const place = this.projection.pointer(event).add(this.pointer.grip);
    if (event.shiftKey && this.host.settings.lightKind !== 'directional') this.moveAway(place);
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

  /** A second finger changes the distance of the light as it moves away from the model's centre or towards it. */
  private readonly onSecondPointer = (event: PointerEvent): void => {
    if (event.pointerId === this.pointer?.id || this.second || this.host.settings.lightKind === 'directional') return;
    event.stopPropagation();
    this.second = { id: event.pointerId, start: this.reach(event), distance: this.host.settings.lightDistance };
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
    const { settings } = this.host;
    const step = event.shiftKey ? FINE_STEP : STEP;
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.turn(-step, 0),
      ArrowRight: () => this.turn(step, 0),
      ArrowUp: () => this.turn(0, step),
      ArrowDown: () => this.turn(0, -step),
      PageUp: () => this.setDistance(settings.lightDistance * 1.1),
      PageDown: () => this.setDistance(settings.lightDistance / 1.1),
      Home: this.onDoubleClick,
    };
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    move();
  };

  private readonly onDoubleClick = (): void => {
    this.host.onMove({
      lightAzimuth: SETTINGS.lightAzimuth.default,
      lightElevation: SETTINGS.lightElevation.default,
      lightDistance: SETTINGS.lightDistance.default,
    });
  };

  private turn(around: number, up: number): void {
    const { lightAzimuth, lightElevation } = this.host.settings;
    const { min, max } = SETTINGS.lightElevation;
    this.host.onMove({
      lightAzimuth: MathUtils.euclideanModulo(lightAzimuth + around + 180, 360) - 180,
      lightElevation: MathUtils.clamp(lightElevation + up, min, max),
    });
  }

  private setDistance(distance: number): void {
    const { min, max } = SETTINGS.lightDistance;
    this.host.onMove({ lightDistance: MathUtils.clamp(distance, min, max) });
  }

  /** Scales the distance of the light by how far it is dragged from the model's centre. */
  private moveAway(place: Vector2): void {
    const centre = this.projection.project(new Vector3());
    const now = Math.max(MIN_REACH, this.projection.project(this.host.lightPosition).distanceTo(centre));
    const next = Math.max(MIN_REACH, place.distanceTo(centre));
    this.setDistance((this.host.settings.lightDistance * next) / now);
  }

  /** Moves the light to where the line of sight through `place` meets its sphere, or else to the sphere's outline. */
  private moveOverSphere(place: Vector2): void {
    const ray = this.projection.ray(place);
    const radius = this.host.lightPosition.length();
    const hits = intersectSphere(ray, radius);
    if (!hits) this.beyondOutline = true;
    else if (this.beyondOutline) {
      this.beyondOutline = false;
      this.behind = !this.behind;
    }
    const hit = hits ? (this.behind ? hits.far : hits.near) : nearestOutlinePoint(ray, radius);
    const { settings, camera } = this.host;
    if (settings.lightFollows === 'viewer') hit.applyQuaternion(camera.quaternion.clone().invert());
    const { theta, phi } = new Spherical().setFromVector3(hit);
    const { min, max } = SETTINGS.lightElevation;
    this.host.onMove({
      lightAzimuth: MathUtils.radToDeg(theta),
      lightElevation: MathUtils.clamp(90 - MathUtils.radToDeg(phi), min, max),
    });
  }

  /** How far a pointer is from the model's centre, in pixels. */
  private reach(event: PointerEvent): number {
    return Math.max(MIN_REACH, this.projection.pointer(event).distanceTo(this.projection.project(new Vector3())));
  }
}
