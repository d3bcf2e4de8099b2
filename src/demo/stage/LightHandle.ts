import { MathUtils, type PerspectiveCamera, Raycaster, Spherical, Vector2, Vector3 } from 'three';
import { SETTINGS, type Settings } from '../settings/settings.js';
import { createLampIcon } from './createLampIcon.js';
import { intersectSphere, isBehind, isHidden, nearestOutlinePoint } from './lightSphere.js';

type LightPlace = Pick<Settings, 'lightAzimuth' | 'lightElevation' | 'lightDistance'>;

const STEP = 5;
const FINE_STEP = 1;
/** Nearer to the edge of the viewport than this and the lamp is held back, so that it can always be taken. */
const MARGIN = 26;
/** Nearer to an edge than this and the hint below the lamp would be cut; it stands elsewhere then. */
const HINT_REACH = 76;
/** Closer to the model's centre than this and the share of the distance by which a drag moves a lamp would explode. */
const MIN_REACH = 32;

/** What the handle works on. */
export interface LightHandleHost {
  /** The element the handle is laid over; its client size is the picture's. */
  viewport: HTMLElement;
  camera: PerspectiveCamera;
  settings: Settings;
  /** Where the light stands now, in world coordinates. */
  lightPosition: Vector3;
  /** Moves the light. */
  onMove(place: Partial<LightPlace>): void;
  /** A drag begins or ends: the camera must hold still meanwhile. */
  onDrag(dragging: boolean): void;
}

/**
 * The lamp one can take in the hand: drag it over a sphere around the model; past the sphere's edge and back takes it
 * behind. Shift, or a second finger, changes the distance of a lamp or spot. Arrow keys move it by 5°, with Shift by 1°.
 */
export class LightHandle {
  private readonly raycaster = new Raycaster();
  private behind = false;
  private beyondEdge = false;
  private pointer: { id: number; grip: Vector2 } | undefined;
  private second: { id: number; start: number; distance: number } | undefined;

  constructor(
    private readonly element: HTMLElement,
    private readonly host: LightHandleHost,
  ) {
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

  /** Lays the handle over the light's place in the picture; to be called with every frame. */
  update(): void {
    const { settings, lightPosition, camera } = this.host;
    const { x, y } = this.projectToViewport(lightPosition);
    const { width, height } = this.viewportSize();
    const left = MathUtils.clamp(x, MARGIN, width - MARGIN);
    const top = MathUtils.clamp(y, MARGIN, height - MARGIN);
    this.element.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
    this.element.classList.toggle('is-at-left', left < HINT_REACH);
    this.element.classList.toggle('is-at-right', left > width - HINT_REACH);
    this.element.classList.toggle('is-at-bottom', top > height - HINT_REACH);
    if (!this.pointer) this.behind = isBehind(lightPosition, camera.position);
    this.element.classList.toggle('is-behind', isHidden(lightPosition, camera.position));
    this.element.setAttribute('aria-valuenow', settings.lightAzimuth.toFixed(0));
    const facts = [
      `${settings.lightAzimuth.toFixed(1)}° around`,
      `${settings.lightElevation.toFixed(1)}° high`,
      this.behind ? 'behind the model' : 'in front of the model',
    ];
    if (settings.lightKind !== 'directional') facts.push(`${settings.lightDistance.toFixed(2)} radii away`);
    this.element.setAttribute('aria-valuetext', facts.join(', '));
  }

  private readonly onPointerDown = (event: PointerEvent): void => {
    if (this.pointer || event.button !== 0) return;
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    // The lamp is held where it was gripped and does not jump under the pointer.
    const grip = this.projectToViewport(this.host.lightPosition).sub(this.pointerPosition(event));
    this.pointer = { id: event.pointerId, grip };
    this.beyondEdge = false;
    this.element.classList.add('is-held');
    addEventListener('pointerdown', this.onSecondPointer, { capture: true });
    this.host.onDrag(true);
  };

  private readonly onPointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer?.id || this.second) return;
    const place = this.pointerPosition(event).add(this.pointer.grip);
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

  /** A second finger sets the distance of the lamp by how far it moves from or towards the model's centre. */
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

  private moveAway(place: Vector2): void {
    const centre = this.projectToViewport(new Vector3());
    const now = Math.max(MIN_REACH, this.projectToViewport(this.host.lightPosition).distanceTo(centre));
    const next = Math.max(MIN_REACH, place.distanceTo(centre));
    this.setDistance((this.host.settings.lightDistance * next) / now);
  }

  /** Puts the light where the line of sight through `place` meets the sphere it moves on, or at the sphere's edge. */
  private moveOverSphere(place: Vector2): void {
    const { camera, lightPosition } = this.host;
    const { width, height } = this.viewportSize();
    this.raycaster.setFromCamera(new Vector2((place.x / width) * 2 - 1, 1 - (place.y / height) * 2), camera);
    const hits = intersectSphere(this.raycaster.ray, lightPosition.length());
    if (!hits) this.beyondEdge = true;
    else if (this.beyondEdge) {
      this.beyondEdge = false;
      this.behind = !this.behind;
    }
    const hit = hits
      ? this.behind
        ? hits.far
        : hits.near
      : nearestOutlinePoint(this.raycaster.ray, lightPosition.length());
    const { theta, phi } = new Spherical().setFromVector3(hit);
    const { min, max } = SETTINGS.lightElevation;
    this.host.onMove({
      lightAzimuth: MathUtils.radToDeg(theta),
      lightElevation: MathUtils.clamp(90 - MathUtils.radToDeg(phi), min, max),
    });
  }

  private reach(event: PointerEvent): number {
    return Math.max(MIN_REACH, this.pointerPosition(event).distanceTo(this.projectToViewport(new Vector3())));
  }

  private viewportSize(): { width: number; height: number } {
    return { width: this.host.viewport.clientWidth, height: this.host.viewport.clientHeight };
  }

  private pointerPosition(event: PointerEvent): Vector2 {
    const { left, top } = this.host.viewport.getBoundingClientRect();
    return new Vector2(event.clientX - left, event.clientY - top);
  }

  private projectToViewport(world: Vector3): Vector2 {
    const { width, height } = this.viewportSize();
    const projected = world.clone().project(this.host.camera);
    return new Vector2(((projected.x + 1) / 2) * width, ((1 - projected.y) / 2) * height);
  }
}
