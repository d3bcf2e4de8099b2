/** Answers every message with the buffers of the one before: what comes back has lain on this side, as a result has. */
let held: ArrayBuffer[] = [];

globalThis.onmessage = ({ data }: MessageEvent<ArrayBuffer[]>) => {
  globalThis.postMessage(held, { transfer: held });
  held = data;
};
