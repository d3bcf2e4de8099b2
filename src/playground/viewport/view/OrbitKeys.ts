import { MathUtils, Spherical, Vector3 } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { LensCamera } from '../../../viewer/sceneSetup/LensCamera.js';

const TURN = MathUtils.degToRad(5);
const FINE_TURN = MathUtils.degToRad(1);
const ZOOM = 1.1;

/** Moves the camera by keyboard: arrows orbit (with Shift in small steps), plus and minus zoom, WASD pan, Home frames the model. */
export class OrbitKeys {
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
