import type { Settings } from '../../viewer/settings/settings.js';
import { type PrintPlan, placeView, type Size, strokeScale } from '../print/printPlan.js';
import type { FramePose } from './FramePoser.js';

/** The amplitude of a swinging light, in degrees. It stays in front of the model. */
const SWING = 60;

/** The frames of a video: size in pixels, number, and rate per second. */
export interface VideoPlan extends Size {
  frames: number;
  rate: number;
}

/** The playing clip of a model. */
export interface PlayingClip {
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
