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
