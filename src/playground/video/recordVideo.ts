import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  Quality,
  WebMOutputFormat,
} from 'mediabunny';
import type { Settings } from '../../viewer/settings/settings.js';
import { ZipWriter } from '../export/zip.js';
import type { Size } from '../print/printPlan.js';
import { LostContextError } from '../viewport/ContextLoss.js';
import type { PictureSession } from '../viewport/PictureSession.js';
import type { Viewport } from '../viewport/Viewport.js';
import { FramePoser, placeOnFrame, planVideo, poseOf, stampOf, type VideoPlan } from './videoPlan.js';

/** Saves frames as numbered PNG pictures in an archive, which every video program can read. */
class PicturesSink implements FrameSink {
  readonly extension = '.zip';
  readonly kind = 'PNG pictures in a ZIP';
  private readonly zip = new ZipWriter();
  private readonly digits: number;

  constructor(
    { frames }: VideoPlan,
    private readonly name: string,
  ) {
    this.digits = String(frames).length;
  }

  async add(canvas: HTMLCanvasElement, frame: number): Promise<void> {
    const picture = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!picture) throw new Error('The browser could not pack a frame as PNG; choose smaller frames.');
    await this.zip.add(`${this.name}-${String(frame + 1).padStart(this.digits, '0')}.png`, picture);
  }

  async end(): Promise<Blob> {
    return this.zip.end();
  }

  async abort(): Promise<void> {}
}

interface RecordOptions {
  /** Size of the page's view, in CSS pixels. */
  view: Size;
  /** The base name of the pictures, if frames are saved as pictures. */
  name: string;
  signal: AbortSignal;
  onProgress: (progress: number) => void;
  /** Called after each frame, while the canvas still shows it. */
  onFrame: (canvas: HTMLCanvasElement) => void;
}

/** A recorded video, and one sentence about it for the user. */
interface Recording {
  content: Blob;
  extension: string;
  sentence: string;
}

/**
 * Records the video of the settings frame by frame, however long each takes. The page's frames are held meanwhile. If the browser cannot
 * encode video, the frames are saved as pictures.
 *
 * @throws Error with a sentence for the user
 */
export async function recordVideo(
  viewport: Viewport,
  session: PictureSession,
  settings: Settings,
  { view, name, signal, onProgress, onFrame }: RecordOptions,
): Promise<Recording> {
  const { videoMotion } = settings;
  const motion = viewport.model?.motion;
  const clip = motion?.isPlaying && motion.duration > 0 ? motion : undefined;
  if (videoMotion === 'clip' && !clip)
    throw new Error('No clip of this model is playing; choose another motion for the video.');
  const plan = planVideo(settings, view);
  const start = clip && { duration: clip.duration, time: clip.time, speed: clip.speed };
  const { canvas } = viewport;
  const { width, height } = plan;
  const place = placeOnFrame(plan, view, viewport.view.isFramed);
  let drawn = 0;
  // The graphics context may be lost and restored between two checks, which leaves a blank frame.
  let wasLost = false;
  const onLost = (): void => {
    wasLost = true;
  };
  canvas.addEventListener('webglcontextlost', onLost);
  session.hold(Math.max(width, height));
  session.begin({ ground: 'paper' });
  const poser = new FramePoser(viewport, settings, width / height, videoMotion === 'turn');
  let sink: FrameSink | undefined;
  try {
    const movie = settings.videoForm === 'video' ? await MovieSink.begin(plan, canvas) : undefined;
    sink = movie ?? new PicturesSink(plan, name);
    while (drawn < plan.frames) {
      // Lets the page handle events between two frames, Cancel among them.
      await nextTask();
      signal.throwIfAborted();
      poser.pose(poseOf(plan, drawn, videoMotion, start));
      session.drawPart(place, { x: 0, y: 0, width, height });
      const taken = sink.add(canvas, drawn);
      onFrame(canvas);
      await taken;
      if (wasLost) throw new LostContextError();
      onProgress(++drawn / plan.frames);
    }
    const content = await sink.end();
    const fallback = settings.videoForm === 'video' && !movie ? ' This browser encodes no video of that size.' : '';
    return { content, extension: sink.extension, sentence: `Saved: ${describe(plan, sink.kind)}.${fallback}` };
  } catch (error) {
    await sink?.abort();
    // An encoder may fail because the graphics context was lost, and be the first to report it.
    const isLoss = error instanceof LostContextError || wasLost || viewport.isLost;
    throw isLoss ? new LostContextError(lossAfter(drawn, plan)) : error;
  } finally {
    canvas.removeEventListener('webglcontextlost', onLost);
    poser.restore();
    session.end();
    session.release();
  }
}

/** Resolves in the next task. Unlike timers, messages are not delayed in a hidden tab. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}

const lossAfter = (drawn: number, { frames }: VideoPlan): string =>
  `The graphics card let go of the drawing after ${drawn} of ${frames} frames. There is no video; record it again when the drawing is back.`;

function describe({ width, height, frames, rate }: VideoPlan, kind: string): string {
  const size = `${width.toLocaleString('en')} × ${height.toLocaleString('en')} px`;
  return `${size}, ${frames / rate} s with ${rate} frames a second, ${kind}`;
}

/** The codecs, the most widely supported first. */
const CODECS = ['avc', 'vp9', 'vp8'] as const;
const NAMES = { avc: 'H.264 in MP4', vp9: 'VP9 in WebM', vp8: 'VP8 in WebM' } as const;

/** Low quality would harm thin strokes first. */
const QUALITY = new Quality('very-high');

/** Records frames as a video that the browser encodes. Each frame has a fixed time, however long it took to draw. */
class MovieSink implements FrameSink {
  readonly extension: string;
  readonly kind: string;
  private readonly target = new BufferTarget();
  private readonly output: Output;
  private readonly source: CanvasSource;

  private constructor(
    private readonly plan: VideoPlan,
    canvas: HTMLCanvasElement,
    codec: (typeof CODECS)[number],
  ) {
    const format = codec === 'avc' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
    this.extension = format.fileExtension;
    this.kind = NAMES[codec];
    this.output = new Output({ format, target: this.target });
    this.source = new CanvasSource(canvas, { codec, quality: QUALITY, keyFrameInterval: 1 });
    this.output.addVideoTrack(this.source, { frameRate: plan.rate });
  }

  /**
   * Starts a video with the first codec in which the browser can encode frames of this size.
   *
   * @returns undefined if there is no such codec
   */
  static async begin(plan: VideoPlan, canvas: HTMLCanvasElement): Promise<MovieSink | undefined> {
    const { width, height, rate: frameRate } = plan;
    const codec = await getFirstEncodableVideoCodec([...CODECS], { width, height, quality: QUALITY, frameRate });
    if (codec === null) return undefined;
    const sink = new MovieSink(plan, canvas, codec as (typeof CODECS)[number]);
    await sink.output.start();
    return sink;
  }

  add(_: HTMLCanvasElement, frame: number): Promise<void> {
    const { time, duration } = stampOf(this.plan, frame);
    return this.source.add(time, duration).catch(giveUp);
  }

  async end(): Promise<Blob> {
    await this.output.finalize().catch(giveUp);
    return new Blob([this.target.buffer!], { type: this.output.format.mimeType });
  }

  async abort(): Promise<void> {
    await this.output.cancel();
  }
}

function giveUp(cause: unknown): never {
  throw new Error('The browser gave up encoding the video; choose smaller frames, or pictures in a ZIP.', { cause });
}

/** Writes the frames of a video to a file. */
interface FrameSink {
  /** The file extension, with its dot. */
  readonly extension: string;
  /** The kind of the file, for the user. */
  readonly kind: string;
  /** Adds the canvas as drawn in this task, and resolves when the next frame can be added. */
  add(canvas: HTMLCanvasElement, frame: number): Promise<void>;
  end(): Promise<Blob>;
  /** Call this instead of `end` to discard the video. */
  abort(): Promise<void>;
}
