/** Records the frames of a video in a file. */
export interface FrameSink {
  /** The extension of the file's name, with its dot. */
  readonly extension: string;
  /** The kind of the file, in words for the user. */
  readonly kind: string;
  /** Adds what the canvas shows in this task, and resolves when the next frame can be added. */
  add(canvas: HTMLCanvasElement, frame: number): Promise<void>;
  end(): Promise<Blob>;
  /** To be called instead of `end` if the video is given up. */
  abort(): Promise<void>;
}
