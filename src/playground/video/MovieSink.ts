import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  Quality,
  WebMOutputFormat,
} from 'mediabunny';
import { stampOf, type VideoPlan } from './videoPlan.js';

/** The codecs, the most widely supported first. */
const CODECS = ['avc', 'vp9', 'vp8'] as const;
const NAMES = { avc: 'H.264 in MP4', vp9: 'VP9 in WebM', vp8: 'VP8 in WebM' } as const;

/** Low quality would harm thin strokes first. */
const QUALITY = new Quality('very-high');

/** Records frames as a video that the browser encodes. Each frame has a fixed time, however long it took to draw. */
export class MovieSink implements FrameSink {
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
export interface FrameSink {
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
