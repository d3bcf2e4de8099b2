/** Answers every message with the buffers of the message before, so that what is sent back was in the worker already, as a result is. */
let held: ArrayBuffer[] = [];

globalThis.onmessage = ({ data }: MessageEvent<ArrayBuffer[]>) => {
  globalThis.postMessage(held, { transfer: held });
  held = data;
};
