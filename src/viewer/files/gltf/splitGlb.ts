import { ModelError } from '../common/ModelError.js';

const GLB_JSON = 0x4e4f534a;
const GLB_BINARY = 0x004e4942;

/** Splits a GLB file into its document and its binary part. */
export function splitGlb(bytes: Uint8Array, name: string): { text: string; binary: Uint8Array | undefined } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20) throw new ModelError(`${name} is cut short: it ends within its header.`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new ModelError(`${name} is glTF version ${version}; this page reads version 2.`);
  if (view.getUint32(8, true) > bytes.length) {
    throw new ModelError(
      `${name} is cut short: it should have ${view.getUint32(8, true).toLocaleString('en')} bytes and has ${bytes.length.toLocaleString('en')}.`,
    );
  }
  let text: string | undefined;
  let binary: Uint8Array | undefined;
  for (let offset = 12; offset + 8 <= bytes.length; ) {
    const length = view.getUint32(offset, true);
    const kind = view.getUint32(offset + 4, true);
    const chunk = bytes.subarray(offset + 8, offset + 8 + length);
    if (chunk.length < length) throw new ModelError(`${name} is cut short: one of its parts ends too early.`);
    if (kind === GLB_JSON) text ??= new TextDecoder().decode(chunk);
    else if (kind === GLB_BINARY) binary ??= chunk;
    offset += 8 + length;
  }
  if (text === undefined) throw new ModelError(`${name} has no description of its scene.`);
  return { text, binary };
}
