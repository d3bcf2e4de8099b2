import { describe, expect, test } from 'vitest';
import { placeOnFrame, planVideo, poseOf, stampOf } from '../../../../src/playground/video/videoPlan.js';
import { strokeShare } from '../../../../src/viewer/sceneSetup/framing.js';
import { defaultSettings, SETTINGS, type Settings } from '../../../../src/viewer/settings/settings.js';

const settings = (changes: Partial<Settings>): Settings => ({ ...defaultSettings(), ...changes });
const view = { width: 901, height: 603 };

describe('planVideo', () => {
  test.each(Object.keys(SETTINGS.videoSize.choices) as Settings['videoSize'][])('has even sides: %s', (videoSize) => {
    const { width, height } = planVideo(settings({ videoSize }), view);
    expect([width % 2, height % 2]).toEqual([0, 0]);
    const wanted = videoSize === 'page' ? `${view.width + 1}x${view.height + 1}` : videoSize;
    expect(`${width}x${height}`).toBe(wanted);
  });

  test('has the frames of its length, each with its time', () => {
    const plan = planVideo(settings({ videoSeconds: 3, videoRate: '24' }), view);
    expect(plan.frames).toBe(72);
    const stamps = Array.from({ length: plan.frames }, (_, frame) => stampOf(plan, frame));
    expect(stamps[0].time).toBe(0);
    for (const [i, { time, duration }] of stamps.entries())
      expect(time + duration).toBeCloseTo(stamps[i + 1]?.time ?? 3, 9);
  });
});

describe('poseOf', () => {
  const plan = planVideo(settings({ videoSeconds: 2, videoRate: '12' }), view);
  const clip = { duration: 0.8, time: 0.3, speed: 1 };
  const MOTIONS = Object.keys(SETTINGS.videoMotion.choices) as Settings['videoMotion'][];
  const degreesApart = (a: number, b: number): number => Math.abs(((((a - b) % 360) + 540) % 360) - 180);

  test.each(MOTIONS)('begins where the page is, and ends where it began, without a jump: %s', (motion) => {
    const poses = Array.from({ length: plan.frames + 1 }, (_, frame) => poseOf(plan, frame, motion, clip));
    expect(poses[0]).toEqual({ turn: 0, light: 0, clipTime: 0.3 });
    const last = poses[plan.frames];
    expect(degreesApart(last.turn, 0)).toBeLessThan(1e-9);
    expect(degreesApart(last.light, 0)).toBeLessThan(1e-9);
    expect(last.clipTime).toBeCloseTo(0.3, 9);
    // 2 s are 2.5 rounds of the clip, so it is played 3 times, which a step over its end shows.
    const steps = poses.slice(1).map(({ clipTime }, i) => (clipTime! - poses[i].clipTime! + 0.8) % 0.8);
    for (const step of steps) expect(step).toBeCloseTo((3 * 0.8) / plan.frames, 9);
  });

  test('turns the model or the light, once around or to and fro', () => {
    const half = plan.frames / 2;
    expect(poseOf(plan, half, 'turn', undefined)).toEqual({ turn: 180, light: 0, clipTime: undefined });
    expect(poseOf(plan, half, 'sweep', undefined)).toEqual({ turn: 0, light: 180, clipTime: undefined });
    const swung = Array.from({ length: plan.frames }, (_, frame) => poseOf(plan, frame, 'swing', undefined).light);
    expect(Math.max(...swung)).toBeCloseTo(60, 9);
    expect(Math.min(...swung)).toBeCloseTo(-60, 9);
  });
});

describe('placeOnFrame', () => {
  const plan = planVideo(settings({ videoSize: '1080x1920' }), view);

  test('shows all of a view that the user has chosen', () => {
    const { viewWidth, viewHeight, left, top, scale } = placeOnFrame(plan, view, false);
    expect(viewWidth).toBeCloseTo(1080, 6);
    expect(viewWidth / viewHeight).toBeCloseTo(901 / 603, 6);
    expect(scale).toBeCloseTo(1080 / 901, 6);
    expect([left, top]).toEqual([-0, -Math.round((1920 - viewHeight) / 2)]);
  });

  test('is the view itself where the camera was placed for it, with strokes as wide as before', () => {
    const framed = placeOnFrame(plan, view, true);
    expect(framed).toMatchObject({ viewWidth: 1080, viewHeight: 1920, left: 0, top: 0 });
    expect(framed.scale).toBe(placeOnFrame(plan, view, false).scale);
  });

  test.each([true, false])('has no strokes finer than on a screen of its pixels, framed: %s', (isFramed) => {
    const small = planVideo(settings({ videoSize: '1280x720' }), view);
    for (const large of [
      { width: 1400, height: 860 },
      { width: 2100, height: 1300 },
    ]) {
      expect(placeOnFrame(small, large, isFramed).scale).toBe(1);
    }
  });

  test('where the camera was placed for the frame, strokes are those of a sheet of its size', () => {
    const phone = { width: 360, height: 480 };
    const share = strokeShare(phone.width, phone.height);
    const frame = planVideo(settings({ videoSize: '1280x720' }), phone);
    expect(placeOnFrame(frame, phone, true).scale * share).toBeCloseTo(1, 6);
    expect(placeOnFrame(frame, phone, false).scale).toBeCloseTo(1.5, 6);
  });
});
