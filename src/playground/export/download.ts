import type { Report } from '../../viewer/drawing/buildModel.js';
import type { Settings } from '../../viewer/settings/settings.js';
import type { Viewport } from '../viewport/Viewport.js';

/**
 * A function that draws a picture or a video, and downloads it unless the caller takes the result.
 *
 * @param name file name without extension
 * @returns a sentence about what was saved, or the result
 * @throws Error with a sentence for the user
 */
export type SaveDrawing<Result = string> = (
  viewport: Viewport,
  settings: Settings,
  name: string,
  report: Report,
  signal: AbortSignal,
) => Promise<Result>;

/** Downloads a file. */
export function download(content: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser needs the URL for a moment after the click.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Copies text to the clipboard. Resolves to false if the browser does not allow that. */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/** Turns the title of a drawing into a file name without an extension. */
export function fileStem(title: string): string {
  const stem = title
    .replace(/\.\w+$/, '')
    .replace(/\W+/g, '-')
    .toLowerCase();
  return stem || 'drawing';
}
