import type { FirstDraw } from './FirstDraw.js';

/** Milliseconds in which a page draws again that means to, from when everything is there. */
const PATIENCE = 3000;

/** Whether a renderer has drawn nothing since a mesh that lacked something, though what it lacked has come. */
export async function isOnlyFrame({ material, renderer, frame }: FirstDraw): Promise<boolean> {
  await material.ready;
  await new Promise((resolve) => setTimeout(resolve, PATIENCE));
  // A page in the background draws when it is shown again, and asks for that earlier than this.
  await new Promise((resolve) => requestAnimationFrame(resolve));
  return renderer.info.render.frame === frame && !renderer.getContext().isContextLost();
}
