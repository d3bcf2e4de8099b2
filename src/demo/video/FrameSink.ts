/** Takes the frames of a video. */
export interface FrameSink {
  /** Of the file. */
  readonly extension: string;
  /** What the file is, in words. */
  readonly kind: string;
  /** Takes what the canvas shows in this task, and resolves when the next frame may come. */
  add(canvas: HTMLCanvasElement, frame: number): Promise<void>;
  end(): Promise<Blob>;
  /** To be called in the place of `end`, if the video is given up. */
  abort(): Promise<void>;
}
