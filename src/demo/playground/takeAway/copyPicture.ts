import type { Status } from '../tasks/Status.js';

/**
 * Puts a picture on the clipboard, and says whether that went well. To be called while a click is handled: the clipboard is asked at
 * once and given a promise, because some browsers, Safari among them, hear no later request.
 *
 * @param draw draws the picture as PNG; where it rejects, the user has been told why
 */
export async function copyPicture(draw: () => Promise<Blob>, status: Status): Promise<void> {
  const refuse = (): void => status.fail('The browser keeps its clipboard from this page: save the picture instead.');
  if (!navigator.clipboard?.write || typeof ClipboardItem === 'undefined') {
    refuse();
    return;
  }
  const picture = draw();
  const [drawn, copied] = await Promise.allSettled([picture, write(picture)]);
  if (drawn.status === 'rejected') return;
  if (copied.status === 'rejected') refuse();
  else status.say('The picture is on the clipboard, as PNG.');
}

/** Rejects also where older browsers throw because of the promise. */
const write = async (picture: Promise<Blob>): Promise<void> =>
  navigator.clipboard.write([new ClipboardItem({ 'image/png': picture })]);
