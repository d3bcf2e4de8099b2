import { MathUtils, type PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { fitCamera } from '../../viewer/sceneSetup/framing.js';
import { lookOf } from '../../viewer/settings/lookOf.js';
import type { Settings } from '../../viewer/settings/settings.js';
import { type PrintPlan, placeView, type Size, strokeScale } from '../print/printPlan.js';
import type { Viewport } from '../viewport/Viewport.js';

/** The amplitude of a swinging light, in degrees. It stays in front of the model. */
const SWING = 60;

/** The frames of a video: size in pixels, number, and rate per second. */
export interface VideoPlan extends Size {
  frames: number;
  rate: number;
}

/** The playing clip of a model. */
interface PlayingClip {
  /** Length of the clip and time in it, in seconds. */
  duration: number;
  time: number;
  speed: number;
}

/** The video of the settings. @param view size of the page's view, in CSS pixels */
export function planVideo({ videoSize, videoSeconds, videoRate }: Settings, view: Size): VideoPlan {
  const [width, height] = videoSize === 'page' ? [view.width, view.height] : videoSize.split('x').map(Number);
  const rate = Number(videoRate);
  return { width: toEven(width), height: toEven(height), frames: videoSeconds * rate, rate };
}

/** Sizes are even, because video formats halve the resolution of colours. */
const toEven = (pixels: number): number => Math.max(2, 2 * Math.round(pixels / 2));

/** The time and duration of a frame, in seconds. */
export const stampOf = ({ rate }: VideoPlan, frame: number) => ({ time: frame / rate, duration: 1 / rate });

/**
 * The pose of a frame. The frame after the last one would equal the first, so that the video loops without a jump. A clip therefore plays a
 * whole number of times, the nearest to its speed.
 */
export function poseOf(
  { frames, rate }: VideoPlan,
  frame: number,
  motion: Settings['videoMotion'],
  clip: PlayingClip | undefined,
): FramePose {
  const share = frame / frames;
  const poses = {
    turn: { turn: 360 * share, light: 0 },
    sweep: { turn: 0, light: 360 * share },
    swing: { turn: 0, light: SWING * Math.sin(2 * Math.PI * share) },
    clip: { turn: 0, light: 0 },
  };
  return { ...poses[motion], clipTime: clip && clipTime(clip, frames / rate, share) };
}

function clipTime({ duration, time, speed }: PlayingClip, seconds: number, share: number): number {
  const rounds = Math.max(1, Math.round((seconds * speed) / duration));
  return (time + share * rounds * duration) % duration;
}

/** The place of the view on a frame. @param isFramed whether the camera was placed to frame the model in the video */
export function placeOnFrame(plan: VideoPlan, view: Size, isFramed: boolean): Omit<PrintPlan, 'dpi'> {
  if (!isFramed) return placeView(plan, view);
  const { width, height } = plan;
  const fit = Math.min(width / view.width, height / view.height);
  const scale = strokeScale(fit, plan, view);
  return { width, height, viewWidth: width, viewHeight: height, left: 0, top: 0, scale };
}

/** The number of sampled turns: between two of them, a model is hardly wider than in one. */
const TURNS = 24;

/** The points of a model at all sampled turns about the up axis. @param positions xyz of each point */
export function turnedPoints(positions: ArrayLike<number>): Float32Array {
  const all = new Float32Array(TURNS * positions.length);
  for (let turn = 0; turn < TURNS; turn++) {
    const [cosine, sine] = [Math.cos((2 * Math.PI * turn) / TURNS), Math.sin((2 * Math.PI * turn) / TURNS)];
    for (let i = 0; i < positions.length; i += 3) {
      const [x, z] = [positions[i], positions[i + 2]];
      all.set([x * cosine + z * sine, positions[i + 1], z * cosine - x * sine], turn * positions.length + i);
    }
  }
  return all;
}

/** The pose of a video frame relative to the page. */
interface FramePose {
  /** Rotation of the model, with ground and lights, in degrees. */
  turn: number;
  /** Rotation of the light around the model, in degrees. */
  light: number;
  /** Time in the model's clip, in seconds; undefined leaves it as it is. */
  clipTime: number | undefined;
}

const UP = new Vector3(0, 1, 0);

/** Moves the camera, the light and the model's clip for the frames of a video. To turn the model, the camera orbits it. */
export class FramePoser {
  private readonly clipTime: number | undefined;
  private readonly position = new Vector3();
  private readonly quaternion = new Quaternion();
  private readonly up = new Vector3();
  /** Position and target of the camera in the first frame. */
  private readonly first = new Vector3();
  private readonly target: Vector3;

  /**
   * A model that is framed on the page is framed in the video, in every turn; otherwise the frames show the view of the page.
   *
   * @param aspect of the frames
   * @param turns whether the model will turn
   */
  constructor(
    private readonly viewport: Viewport,
    private readonly settings: Settings,
    aspect: number,
    turns: boolean,
  ) {
    const { camera, view, model } = viewport;
    this.clipTime = model?.motion?.time;
    this.position.copy(camera.position);
    this.quaternion.copy(camera.quaternion);
    this.up.copy(camera.up);
    this.target = view.isFramed ? frame(viewport, camera, aspect, turns) : view.controls.target.clone();
    this.first.copy(camera.position);
  }

  pose({ turn, light, clipTime }: FramePose): void {
    const { viewport, settings } = this;
    const { camera, model } = viewport;
    const { lights } = viewport.scenery;
    const around = MathUtils.degToRad(-turn);
    camera.position.copy(this.first).applyAxisAngle(UP, around);
    camera.up.copy(this.up).applyAxisAngle(UP, around);
    camera.lookAt(this.target.clone().applyAxisAngle(UP, around));
    lights.apply(lookOf({ ...settings, lightAzimuth: settings.lightAzimuth + light }).lights);
    lights.place(camera);
    if (model?.motion && clipTime !== undefined) model.motion.time = clipTime;
    viewport.outdateShadows();
  }

  /** Restores everything that was moved. The viewport itself sets the camera's aspect when frames resume. */
  restore(): void {
    const { camera, model, scenery } = this.viewport;
    camera.position.copy(this.position);
    camera.up.copy(this.up);
    camera.quaternion.copy(this.quaternion);
    scenery.lights.apply(lookOf(this.settings).lights);
    if (model?.motion && this.clipTime !== undefined) model.motion.time = this.clipTime;
    this.viewport.outdateShadows();
  }
}

/** @returns the camera's target */
function frame({ view }: Viewport, camera: PerspectiveCamera, aspect: number, turns: boolean): Vector3 {
  const { framedPoints, first, fill, shadow } = view.framing;
  camera.aspect = aspect;
  camera.updateProjectionMatrix();
  if (!turns) return fitCamera(camera, framedPoints, first, { fill, shadow });
  // The shadows of all turns together would reach to every side, so they are not framed.
  return fitCamera(camera, turnedPoints(framedPoints), first, { fill });
}
