import { ZipWriter } from '../print/ZipWriter.js';
import type { FrameSink } from './FrameSink.js';
import type { VideoPlan } from './videoPlan.js';

/** Saves frames as numbered PNG pictures in an archive. Every program that makes videos can read them. */
export class PicturesSink implements FrameSink {
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
