/** The extensions that a glTF file lists. */
export interface GltfExtensions {
  used: readonly string[];
  /** The extensions without which the file cannot be read. */
  required: readonly string[];
}

const MAGIC = 0x46546c67;
const HEADER = 20;

/** Reads the extensions of a glTF or GLB file. If the file cannot be read, it returns none, and the loader reports the error. */
export function readExtensions(content: ArrayBuffer): GltfExtensions {
  try {
    const view = new DataView(content);
    const isBinary = view.getUint32(0, true) === MAGIC;
    const text = isBinary ? new Uint8Array(content, HEADER, view.getUint32(HEADER - 8, true)) : content;
    const { extensionsUsed, extensionsRequired } = JSON.parse(new TextDecoder().decode(text));
    return { used: names(extensionsUsed), required: names(extensionsRequired) };
  } catch {
    return { used: [], required: [] };
  }
}

const names = (list: unknown): string[] =>
  Array.isArray(list) ? list.filter((name): name is string => typeof name === 'string') : [];
