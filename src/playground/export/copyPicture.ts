import type { Status } from '../tasks/Status.js';

/**
 * Copies a picture to the clipboard, and tells the user whether that was possible. To be called while a click is handled: the clipboard
 * gets a promise at once, because some browsers, such as Safari, refuse later requests.
 *
 * @param draw draws the picture as PNG. If it rejects, the user has been told why
 */
export async function copyPicture(draw: () => Promise<Blob>, status: Status): Promise<void> {
  const refuse = (): void =>
    status.fail('The browser does not let this page use the clipboard: save the picture instead.');
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

/** Rejects where older browsers throw, which do not take promises. */
const write = async (picture: Promise<Blob>): Promise<void> =>
  navigator.clipboard.write([new ClipboardItem({ 'image/png': picture })]);
