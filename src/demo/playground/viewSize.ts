import { page } from './page.js';

/** Size of the page's view, in CSS pixels. */
export function viewSize(): { width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = page.viewport;
  return { width, height };
}
